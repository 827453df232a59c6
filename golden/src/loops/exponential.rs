//! e^t by one multiplication a pixel [lecture, exercise 2].
use super::Number;

/// e^(t0 + iδ): what is there, times e^δ.
#[derive(Clone, Copy, Debug)]
pub struct Exponential<T> {
    value: T,
    ratio: T,
}

impl<T: Number> Exponential<T> {
    /// The exponential that begins at e^`start` and whose argument grows by `step` a pixel.
    pub fn new(start: f64, step: f64) -> Self {
        Exponential { value: T::of(start.exp()), ratio: T::of(step.exp()) }
    }

    /// The value at this pixel; then advances to the next.
    #[inline(always)]
    pub fn pixel(&mut self) -> T {
        let here = self.value;
        self.value = here * self.ratio;
        here
    }
}

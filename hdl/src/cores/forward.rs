//! What goes along a span by additions.
use specula_spec::{Linear, Quadratic};

use crate::units::{self, Differences, Steps};
use specula_datapath::builder::{Builder, Sig};

/// A core's spans.
#[derive(Clone, Copy)]
pub(super) struct Forward<'a> {
    pub b: &'a Builder,
    /// 1 at the first pixel of a span.
    pub first: &'a Sig,
    /// Steps of the longest span.
    pub steps: u32,
}

impl Forward<'_> {
    /// What is linear along a span, from -1 to 1, rounded.
    pub fn linear(&self, instance: &str, linear: &Linear<Sig>, fraction_bits: u32) -> Sig {
        let of = Steps { start: &linear.start, step: &linear.step };
        self.b
            .instance(instance, || units::linear(self.b, self.first, of, self.steps))
            .rounded(fraction_bits)
    }

    /// What is quadratic along a span and stays within `limits`, rounded.
    pub fn quadratic(
        &self,
        instance: &str,
        quadratic: &Quadratic<Sig>,
        limits: (f64, f64),
        fraction_bits: u32,
    ) -> Sig {
        let of = Differences {
            start: &quadratic.start,
            first_difference: &quadratic.first_difference,
            second_difference: &quadratic.second_difference,
        };
        self.b
            .instance(instance, || units::quadratic(self.b, self.first, of, limits, self.steps))
            .rounded(fraction_bits)
    }
}

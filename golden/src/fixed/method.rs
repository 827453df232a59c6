//! What methods have in common.
use specula_spec::{CoreInputs, Format, InputGroup};

use super::error::PacketError;
use super::number::Wide;
use super::observer::Observer;
use super::span_extent::SpanExtent;

/// A span's inputs, by the names that a method has for them.
pub(super) type Inputs<M> = CoreInputs<<M as Method>::Span, <M as Method>::Light, Wide>;

/// Something of a light's diffuse and of its specular intensity.
pub(super) struct Intensities<T> {
    pub diffuse: T,
    pub specular: T,
}

/// A method in the formats of one core.
pub(super) trait Method {
    /// Inputs that the lights of a span have in common.
    type Span: InputGroup<Value = Wide>;
    /// Inputs of each light, coefficients apart.
    type Light: InputGroup<Value = Wide>;
    /// What a pixel leaves to the one after it: registers that are fed back. `()` where pixels do
    /// not depend on one another.
    type State: Copy + Default;
    /// What the lights have in common at one pixel.
    type Pixel;

    /// Formats of the intensities.
    fn formats(&self) -> Intensities<Format>;

    /// Whether inputs within their ports' ranges can be computed together.
    fn check(&self, inputs: &Inputs<Self>, extent: SpanExtent) -> Result<(), PacketError>
    where
        Self: Sized;

    /// The state at pixel `i`, from that at the pixel before; `None` before the first pixel.
    fn state(
        &self,
        _span: &Self::Span,
        _before: Option<Self::State>,
        _i: u32,
        _observer: &mut impl Observer,
    ) -> Self::State {
        Self::State::default()
    }

    /// What the lights have in common at pixel `i`, at which the state is `state`.
    fn pixel(
        &self,
        span: &Self::Span,
        state: Self::State,
        i: u32,
        observer: &mut impl Observer,
    ) -> Self::Pixel;

    /// The intensities of one light at a pixel, 0 to 1.
    fn light(
        &self,
        pixel: &Self::Pixel,
        light: &Self::Light,
        observer: &mut impl Observer,
    ) -> Intensities<Wide>;
}

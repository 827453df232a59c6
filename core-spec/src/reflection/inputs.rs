//! The inputs of a `reflection` core.
use super::{Highlight, ReflectionSpec};
use crate::core_input::CoreInput;
use crate::core_input::InputRole::Light;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;
use crate::quadratic::Quadratic;

inputs! {
    /// Inputs that the lights of a span have in common.
    ReflectionSpan {
        /// q = H·H.
        denominator: group(Quadratic),
        /// q N'·V; there with eq. 34 only.
        view: group_if_any(Quadratic),
        /// N·N; there with the hybrid's highlight only.
        normal_squared: group_if_any(Quadratic),
        /// The highlight's exponent, n or 4n with Blinn's half-way vector, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    ReflectionLight {
        /// q N'·L.
        cosine: group(Quadratic),
        /// q N'·H with H = (L + V)/|L + V|; there with Blinn's highlight only.
        halfway: group_if_any(Quadratic),
        /// 2(N·V)(N·L) - (L·V)(N·N); there with the hybrid's highlight only.
        numerator: group_if_any(Quadratic),
        /// L·V; there with eq. 34 only.
        dot_view: one_if_any,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type ReflectionInputs<T> = CoreInputs<ReflectionSpan<T>, ReflectionLight<T>, T>;

/// With |H| ≤ 1 and |N| ≤ 1 along the span, squares lie from 0 to 1 and numerators from -1 to 1.
impl MethodInputs for ReflectionSpec {
    type SpanGroup = ReflectionSpan<CoreInput>;
    type LightGroup = ReflectionLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> ReflectionSpan<CoreInput> {
        let accumulator = self.formats.accumulator;
        ReflectionSpan {
            denominator: Quadratic::squared_length_inputs("denominator", accumulator),
            view: self
                .only_with(Highlight::Eq34, || Quadratic::reflected_inputs("view", accumulator)),
            normal_squared: self.only_with(Highlight::Hybrid, || {
                Quadratic::squared_length_inputs("normal_squared", accumulator)
            }),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, _core: &CoreParameters, index: usize) -> ReflectionLight<CoreInput> {
        let called = |input: &str| format!("light{index}_{input}");
        let reflected =
            |input: &str| Quadratic::reflected_inputs(&called(input), self.formats.accumulator);
        ReflectionLight {
            cosine: reflected("cosine"),
            halfway: self.only_with(Highlight::Blinn, || reflected("halfway")),
            numerator: self.only_with(Highlight::Hybrid, || reflected("numerator")),
            dot_view: self.only_with(Highlight::Eq34, || {
                CoreInput::between(Light, called("dot_view"), self.formats.cosine, -1.0, 1.0)
            }),
        }
    }
}

impl ReflectionSpec {
    /// What belongs to one highlight alone.
    pub(super) fn only_with<T>(&self, highlight: Highlight, make: impl FnOnce() -> T) -> Option<T> {
        (self.specular == highlight).then(make)
    }
}

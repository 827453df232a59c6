//! The inputs of a `reflection` core.
use super::{Highlight, ReflectionSpec};
use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;
use crate::quadratic::{Quadratic, REFLECTED};

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
            denominator: Quadratic::squared_length_inputs("H.H", "denominator", accumulator),
            view: self.only_with(Highlight::Eq34, || {
                Quadratic::reflected_inputs("2(H.n)(H.V) - (n.V)(H.H)", "view", accumulator)
            }),
            normal_squared: self.only_with(Highlight::Hybrid, || {
                Quadratic::squared_length_inputs("N.N", "normal_squared", accumulator)
            }),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, _core: &CoreParameters, index: usize) -> ReflectionLight<CoreInput> {
        let called = |input: &str| format!("light{index}_{input}");
        let reflected = |value: &str, input: &str| {
            Quadratic::reflected_inputs(value, &called(input), self.formats.accumulator)
        };
        ReflectionLight {
            cosine: reflected("2(H.n)(H.L) - (n.L)(H.H)", "cosine"),
            halfway: self.only_with(Highlight::Blinn, || {
                reflected("2(H.n)(H.h) - (n.h)(H.H) with h = (L + V)/|L + V|", "halfway")
            }),
            numerator: self.only_with(Highlight::Hybrid, || reflected(REFLECTED, "numerator")),
            dot_view: self.only_with(Highlight::Eq34, || {
                let meaning = InputMeaning::light_dot_view();
                CoreInput::between(meaning, called("dot_view"), self.formats.cosine, -1.0, 1.0)
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

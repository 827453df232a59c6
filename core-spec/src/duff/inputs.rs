//! The inputs of a `duff` core.
use super::{DuffSpec, Highlight};
use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::linear::Linear;
use crate::parameters::CoreParameters;
use crate::quadratic::{Quadratic, REFLECTED};

inputs! {
    /// Inputs that the lights of a span have in common.
    DuffSpan {
        /// q = N·N.
        denominator: group(Quadratic),
        /// N·V; there with eq. 33 and 34 only.
        view: group_if_any(Linear),
        /// The highlight's exponent, n or 4n with Blinn's half-way vector, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    DuffLight {
        /// p = N·L.
        cosine: group(Linear),
        /// N·H with H = (L + V)/|L + V|; there with Blinn's highlight only.
        halfway: group_if_any(Linear),
        /// 2(N·V)(N·L) - (L·V)(N·N); there with the quotient only.
        numerator: group_if_any(Quadratic),
        /// L·V; there with eq. 33 and 34 only.
        dot_view: one_if_any,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type DuffInputs<T> = CoreInputs<DuffSpan<T>, DuffLight<T>, T>;

/// With |N| ≤ 1 along the span every linear value lies from -1 to 1, and q from 0 to 1; for
/// numerators see `hybrid`.
impl MethodInputs for DuffSpec {
    type SpanGroup = DuffSpan<CoreInput>;
    type LightGroup = DuffLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> DuffSpan<CoreInput> {
        let f = &self.formats;
        let view = || Linear::inputs("N.V", "view", f.linear_accumulator);
        DuffSpan {
            denominator: Quadratic::squared_length_inputs("N.N", "denominator", f.accumulator),
            view: self.specular.looks_at_the_eye().then(view),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, _core: &CoreParameters, index: usize) -> DuffLight<CoreInput> {
        let f = &self.formats;
        let called = |input: &str| format!("light{index}_{input}");
        let halfway = || Linear::inputs("N.H", &called("halfway"), f.linear_accumulator);
        let numerator =
            || Quadratic::reflected_inputs(REFLECTED, &called("numerator"), f.accumulator);
        let dot_view = || {
            let meaning = InputMeaning::light_dot_view();
            CoreInput::between(meaning, called("dot_view"), f.cosine, -1.0, 1.0)
        };
        DuffLight {
            cosine: Linear::inputs("N.L", &called("cosine"), f.linear_accumulator),
            halfway: (self.specular == Highlight::Blinn).then(halfway),
            numerator: (self.specular == Highlight::Quotient).then(numerator),
            dot_view: self.specular.looks_at_the_eye().then(dot_view),
        }
    }
}

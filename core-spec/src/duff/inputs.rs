//! The inputs of a `duff` core.
use super::{DuffSpec, Highlight};
use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::linear::Linear;
use crate::parameters::CoreParameters;
use crate::quadratic::{Quadratic, REFLECTED};
use crate::ways::{EyeCosine, LightCosine};

inputs! {
    /// Inputs that the lights of a span have in common.
    DuffSpan {
        /// q = N·N.
        denominator: group(Quadratic),
        /// N·V; there with eq. 33 and 34 only, and with ways to places.
        view: group_if_any(Linear),
        /// The way to an eye at a place; there if places are seen from pixels.
        eye: group_if_any(EyeCosine),
        /// The highlight's exponent, n or 4n with Blinn's half-way vector, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    DuffLight {
        /// p = N·L; there without ways to places.
        cosine: group_if_any(Linear),
        /// The way to the light; there if places are seen from pixels, and then all else is not.
        way: group_if_any(LightCosine),
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
        let follows_ways = self.places.follows_ways(core);
        let has_eye = follows_ways && core.local_eye;
        let looks_at_the_eye = self.specular.looks_at_the_eye() || follows_ways;
        DuffSpan {
            denominator: Quadratic::squared_length_inputs("N.N", "denominator", f.accumulator),
            view: (looks_at_the_eye && !has_eye).then(view),
            eye: has_eye.then(|| EyeCosine::inputs(f.accumulator)),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, core: &CoreParameters, index: usize) -> DuffLight<CoreInput> {
        let f = &self.formats;
        let called = |input: &str| format!("light{index}_{input}");
        let halfway = || Linear::inputs("N.H", &called("halfway"), f.linear_accumulator);
        let numerator =
            || Quadratic::reflected_inputs(REFLECTED, &called("numerator"), f.accumulator);
        let dot_view = || {
            let meaning = InputMeaning::light_dot_view();
            CoreInput::between(meaning, called("dot_view"), f.cosine, -1.0, 1.0)
        };
        let follows_ways = self.places.follows_ways(core);
        let of = |highlight: Highlight| self.specular == highlight && !follows_ways;
        let cosine = || Linear::inputs("N.L", &called("cosine"), f.linear_accumulator);
        DuffLight {
            cosine: (!follows_ways).then(cosine),
            way: follows_ways.then(|| LightCosine::inputs(core, index, f.accumulator)),
            halfway: of(Highlight::Blinn).then(halfway),
            numerator: of(Highlight::Quotient).then(numerator),
            dot_view: (self.specular.looks_at_the_eye() && !follows_ways).then(dot_view),
        }
    }
}

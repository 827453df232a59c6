//! The inputs of a `duff` core.
use super::{DuffSpec, Highlight};
use crate::inputs::inputs;
use crate::linear::Linear;
use crate::quadratic::Quadratic;
use crate::{CoreSpec, InputPort};

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    DuffInputs {
        /// q = N·N.
        denominator: group(Quadratic),
        /// N·V; there with eq. 33 and 34 only.
        view: group_if_any(Linear),
        /// The highlight's exponent, n or 4n with Blinn's half-way vector, or its logarithm.
        exponent: one,
        /// Ambient light sent back, in LSBs.
        ambient: vector,
        /// What belongs to each light.
        lights: many(DuffLight),
    }
}

inputs! {
    /// Inputs that belong to one light.
    DuffLight {
        /// p = N·L.
        cosine: group(Linear),
        /// N·H with H = (L + V)/|L + V|; there with Blinn's highlight only.
        halfway: group_if_any(Linear),
        /// 2(N·V)(N·L) - (L·V)(N·N); there with the quotient only.
        numerator: group_if_any(Quadratic),
        /// L·V; there with eq. 33 and 34 only.
        dot_view: one_if_any,
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
    }
}

impl DuffSpec {
    /// The ports of a core with this method.
    ///
    /// With |N| ≤ 1 along the span every linear value lies from -1 to 1, and q from 0 to 1; for
    /// numerators see `hybrid`.
    pub fn inputs(&self, core: &CoreSpec) -> DuffInputs<InputPort> {
        let f = &self.formats;
        let view = || Linear::ports("view", f.linear_accumulator);
        let whole = DuffInputs {
            denominator: Quadratic::squared_length_ports("denominator", f.accumulator),
            view: self.specular.looks_at_the_eye().then(view),
            exponent: self.power_unit().port(core),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> DuffLight<InputPort> {
        let f = &self.formats;
        let called = |input: &str| format!("light{index}_{input}");
        let halfway = || Linear::ports(&called("halfway"), f.linear_accumulator);
        let numerator = || Quadratic::reflected_ports(&called("numerator"), f.accumulator);
        let dot_view = || InputPort::between(called("dot_view"), f.cosine, -1.0, 1.0);
        DuffLight {
            cosine: Linear::ports(&called("cosine"), f.linear_accumulator),
            halfway: (self.specular == Highlight::Blinn).then(halfway),
            numerator: (self.specular == Highlight::Quotient).then(numerator),
            dot_view: self.specular.looks_at_the_eye().then(dot_view),
            diffuse: core.colour_ports(&called("diffuse")),
            specular: core.colour_ports(&called("specular")),
        }
    }
}

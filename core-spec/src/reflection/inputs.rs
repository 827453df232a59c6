//! The inputs of a `reflection` core.
use super::{Highlight, ReflectionSpec};
use crate::inputs::inputs;
use crate::quadratic::Quadratic;
use crate::{CoreSpec, InputPort};

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    ReflectionInputs {
        /// q = H·H.
        denominator: group(Quadratic),
        /// q N'·V; there with eq. 34 only.
        view: group_if_any(Quadratic),
        /// N·N; there with the hybrid's highlight only.
        normal_squared: group_if_any(Quadratic),
        /// The highlight's exponent, n or 4n with Blinn's half-way vector, or its logarithm.
        exponent: one,
        /// Ambient light sent back, in LSBs.
        ambient: vector,
        /// What belongs to each light.
        lights: many(ReflectionLight),
    }
}

inputs! {
    /// Inputs that belong to one light.
    ReflectionLight {
        /// q N'·L.
        cosine: group(Quadratic),
        /// q N'·H with H = (L + V)/|L + V|; there with Blinn's highlight only.
        halfway: group_if_any(Quadratic),
        /// 2(N·V)(N·L) - (L·V)(N·N); there with the hybrid's highlight only.
        numerator: group_if_any(Quadratic),
        /// L·V; there with eq. 34 only.
        dot_view: one_if_any,
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
    }
}

impl ReflectionSpec {
    /// The ports of a core with this method. With |H| ≤ 1 and |N| ≤ 1 along the span, squares lie
    /// from 0 to 1 and numerators from -1 to 1.
    pub fn inputs(&self, core: &CoreSpec) -> ReflectionInputs<InputPort> {
        let accumulator = self.formats.accumulator;
        let whole = ReflectionInputs {
            denominator: Quadratic::squared_length_ports("denominator", accumulator),
            view: self
                .only_with(Highlight::Eq34, || Quadratic::reflected_ports("view", accumulator)),
            normal_squared: self.only_with(Highlight::Hybrid, || {
                Quadratic::squared_length_ports("normal_squared", accumulator)
            }),
            exponent: self.power_unit().port(core),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> ReflectionLight<InputPort> {
        let called = |input: &str| format!("light{index}_{input}");
        let reflected =
            |input: &str| Quadratic::reflected_ports(&called(input), self.formats.accumulator);
        ReflectionLight {
            cosine: reflected("cosine"),
            halfway: self.only_with(Highlight::Blinn, || reflected("halfway")),
            numerator: self.only_with(Highlight::Hybrid, || reflected("numerator")),
            dot_view: self.only_with(Highlight::Eq34, || {
                InputPort::between(called("dot_view"), self.formats.cosine, -1.0, 1.0)
            }),
            diffuse: core.colour_ports(&called("diffuse")),
            specular: core.colour_ports(&called("specular")),
        }
    }

    /// What belongs to one highlight alone.
    pub(super) fn only_with<T>(&self, highlight: Highlight, make: impl FnOnce() -> T) -> Option<T> {
        (self.specular == highlight).then(make)
    }
}

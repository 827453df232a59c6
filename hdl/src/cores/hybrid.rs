//! Hast's hybrid core.
use specula_spec::hybrid::{HybridInputs, HybridLight, HybridSpec};
use specula_spec::{CoreParameters, InputPort};

use super::common::{Intensities, finish, squared_normal, time_slots};
use super::forward::Forward;
use crate::units;
use specula_datapath::builder::{BuildError, Builder, Sig};
use specula_datapath::graph::Graph;

/// Gouraud diffuse; specular base p/q, both by forward differences, then its power. [Hast et al.,
/// eq. 17 to 26]
pub(super) fn core(
    b: Builder,
    parameters: &CoreParameters,
    hybrid: &HybridSpec,
    ports: &HybridInputs<InputPort>,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, parameters);
    let inputs = ports.map(|port| b.input(port));
    let forward = Forward { b: &b, first: &slots.first_pixel, steps: parameters.longest_span - 1 };
    let q = forward
        .quadratic(
            "denominator",
            &inputs.span.denominator,
            (0.0, 1.0),
            hybrid.formats.operand.fraction_bits,
        )
        .named("q");
    let q = squared_normal(q, parameters);
    let pixel = Pixel { forward, hybrid, exponent: &inputs.span.exponent };
    finish(&b, &slots, &inputs, |i, light| pixel.shade(i, light, &q))
}

/// What the lights have in common.
struct Pixel<'a> {
    forward: Forward<'a>,
    hybrid: &'a HybridSpec,
    exponent: &'a Sig,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &HybridLight<Sig>, q: &Sig) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        let Forward { b, first, steps } = self.forward;
        let formats = &self.hybrid.formats;
        let fraction_bits = formats.base.fraction_bits;
        let p = self
            .forward
            .quadratic(
                &called("numerator"),
                &light.numerator,
                (-1.0, 1.0),
                formats.operand.fraction_bits,
            )
            .named(&called("p"));
        let base = b.instance(&called("divider"), || units::divider(b, &p, q, fraction_bits));
        let ends = (&light.intensity_start, &light.intensity_step);
        let gouraud = || units::gouraud(b, first, ends, formats.diffuse.fraction_bits, steps);
        let power = || units::raised(b, &base, self.exponent, self.hybrid.power_unit());
        Intensities {
            diffuse: b.instance(&called("diffuse"), gouraud),
            specular: b.instance(&called("power"), power),
        }
    }
}

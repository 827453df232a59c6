//! Hast's hybrid core.
use specula_spec::hybrid::{HybridInputs, HybridLight, HybridSpec};
use specula_spec::{CoreParameters, InputPort};

use super::forward::Forward;
use super::{Intensities, finish, time_slots};
use crate::units;
use specula_datapath::builder::{BuildError, Builder, Sig};
use specula_datapath::design::Design;

/// Gouraud diffuse; specular base p/q, both by forward differences, then its power. [Hast et al.,
/// eq. 17 to 26]
pub(super) fn core(
    b: Builder,
    spec: &CoreParameters,
    hybrid: &HybridSpec,
    ports: &HybridInputs<InputPort>,
) -> Result<Design, BuildError> {
    let slots = time_slots(&b, spec);
    let inputs = ports.map(|port| b.input(port));
    let forward = Forward { b: &b, first: &slots.first_pixel, steps: spec.longest_span - 1 };
    let q = forward
        .quadratic(
            "denominator",
            &inputs.span.denominator,
            (0.0, 1.0),
            hybrid.formats.operand.fraction_bits,
        )
        .named("q");
    let pixel = Pixel { forward, spec, hybrid, exponent: &inputs.span.exponent };
    finish(&b, &slots, &inputs, |i, light| pixel.shade(i, light, &q))
}

/// What the lights have in common.
struct Pixel<'a> {
    forward: Forward<'a>,
    spec: &'a CoreParameters,
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
        let smallest_q = self.spec.shortest_normal * self.spec.shortest_normal;
        let base =
            b.instance(&called("divider"), || units::divider(b, &p, q, fraction_bits, smallest_q));
        let ends = (&light.intensity_start, &light.intensity_step);
        let gouraud = || units::gouraud(b, first, ends, formats.diffuse.fraction_bits, steps);
        let power = || units::raised(b, &base, self.exponent, self.hybrid.power_unit());
        Intensities {
            diffuse: b.instance(&called("diffuse"), gouraud),
            specular: b.instance(&called("power"), power),
        }
    }
}

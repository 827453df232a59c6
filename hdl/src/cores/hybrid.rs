//! Hast's hybrid core.
use specula_spec::hybrid::{HybridInputs, HybridLight, HybridSpec};
use specula_spec::{CoreParameters, InputPort};

use super::common::{Intensities, finish, squared_normal, time_slots};
use super::forward::Forward;
use super::ways::{Arrival, Ways, alike};
use crate::units::{self, Length};
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
    let mut inputs = ports.map(|port| b.input(port));
    alike(&b, &slots, &mut inputs.lights, |light| light.way.as_mut().map(|to| &mut to.way));
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
    let ways = Ways::new(forward, parameters, hybrid.ways(), &slots);
    let (view, eye) = ways.view(inputs.span.view.as_ref(), inputs.span.eye.as_ref());
    let exponent = &inputs.span.exponent;
    let pixel =
        Pixel { ways: &ways, hybrid, view: view.as_ref(), eye: eye.as_ref(), q: &q, exponent };
    finish(&b, parameters, &slots, &inputs, |i, light| pixel.shade(i, light))
}

/// What the lights have in common.
struct Pixel<'a> {
    ways: &'a Ways<'a>,
    hybrid: &'a HybridSpec,
    /// N·V, with ways to places.
    view: Option<&'a Sig>,
    /// What divides by the way to an eye at a place.
    eye: Option<&'a Length>,
    q: &'a Sig,
    exponent: &'a Sig,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &HybridLight<Sig>) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        let Forward { b, first, steps } = self.ways.forward;
        let formats = &self.hybrid.formats;
        let fraction_bits = formats.base.fraction_bits;
        let (p, arrival) = self.numerator(index, light);
        let p = p.named(&called("p"));
        let base = b.instance(&called("divider"), || units::divider(b, &p, self.q, fraction_bits));
        let ends = (&light.intensity_start, &light.intensity_step);
        let gouraud = || units::gouraud(b, first, ends, formats.diffuse.fraction_bits, steps);
        let power = || units::raised(b, &base, self.exponent, self.hybrid.power_unit());
        let (diffuse, specular) =
            (b.instance(&called("diffuse"), gouraud), b.instance(&called("power"), power));
        // What a spot leaves of the diffuse light is part of the vertices' intensities.
        match arrival {
            Some(arrival) => {
                let bits = self.hybrid.power_unit().format().fraction_bits;
                Intensities { diffuse, specular: arrival.share_of(specular, bits) }
            }
            None => Intensities { diffuse, specular },
        }
    }

    /// R·L q, and the way to the light if that is followed.
    fn numerator(&self, index: usize, light: &HybridLight<Sig>) -> (Sig, Option<Arrival>) {
        let instance = format!("light{index}_numerator");
        match (&light.numerator, &light.way, self.view) {
            (_, Some(way), Some(view)) => {
                let (cosine, arrival) = self.ways.light(index, way, self.eye);
                let factors = [view, &cosine];
                let p = self.ways.reflected(&instance, factors, &arrival.dot_view, self.q);
                (p, Some(arrival))
            }
            (Some(numerator), ..) => (self.ways.quadratic(&instance, numerator), None),
            _ => unreachable!("`HybridSpec` gives lights numerators, or ways and N.V"),
        }
    }
}

//! The core of spherical interpolation.
use specula_scene::CoreSpec;
use specula_scene::spec::slerp::{SlerpLight, SlerpSpec};

use super::finish;
use crate::builder::{Builder, Sig, TooWide};
use crate::design::Design;
use crate::units::{self, BaseBound, Light};

/// One rotation, and what it makes of N·V and of each light's N·L; specular base 2 J K - L·V, then its power. [lecture, eq. 4.5, 4.7 to
/// 4.12]
pub(super) fn core(b: Builder, spec: &CoreSpec, slerp: &SlerpSpec) -> Result<Design, TooWide> {
    let control = b.control();
    let inputs = slerp.inputs(spec).map(|port| b.input(port));
    let steps = spec.longest_span - 1;
    let turn = [&inputs.turn_cosine, &inputs.turn_sine];
    let [c, s] = units::rotation(&b, &control.start, turn, &slerp.formats, steps)
        .map(|x| x.rounded(slerp.formats.weight.fraction_bits).named("weight"));
    let weights = [&c, &s];
    let view = [&inputs.view_start, &inputs.view_across];
    let n_dot_v = b.instance("n_dot_v", || units::along_arc(&b, weights, view, &slerp.formats, steps));
    let n_dot_v = units::corrected(&b, &n_dot_v, weights, &slerp.formats, steps);
    let bound = BaseBound::new(&slerp.formats, steps);
    let pixel = Pixel { b: &b, spec, slerp, weights, n_dot_v: &n_dot_v, exponent: &inputs.exponent, bound };
    let lights: Vec<Light> = inputs.lights.iter().enumerate().map(|(i, light)| pixel.shade(i, light)).collect();
    finish(&b, &control, &inputs.ambient, &lights)
}

/// What the lights have in common.
struct Pixel<'a> {
    b: &'a Builder,
    spec: &'a CoreSpec,
    slerp: &'a SlerpSpec,
    weights: [&'a Sig; 2],
    n_dot_v: &'a Sig,
    exponent: &'a Sig,
    bound: BaseBound,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &SlerpLight<Sig>) -> Light {
        let (b, formats) = (self.b, &self.slerp.formats);
        let called = |unit: &str| format!("light{index}_{unit}");
        let scalars = [&light.light_start, &light.light_across];
        let along_arc = || units::along_arc(b, self.weights, scalars, formats, self.spec.longest_span - 1);
        let n_dot_l = b.instance(&called("n_dot_l"), along_arc);
        let base = || units::base(b, &n_dot_l, self.n_dot_v, &light.light_dot_view, &self.bound, formats);
        let base = b.instance(&called("base"), base);
        let power = || units::raised(b, &base, self.exponent, self.slerp.power_unit());
        Light {
            diffuse: b.instance(&called("diffuse"), || units::kept_within_one(b, &n_dot_l, formats.diffuse.fraction_bits)),
            specular: b.instance(&called("power"), power),
            diffuse_coefficients: light.diffuse.clone(),
            specular_coefficients: light.specular.clone(),
        }
    }
}

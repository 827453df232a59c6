//! The core that evaluates fast Phong shading anew at every pixel.
use specula_scene::CoreSpec;
use specula_scene::spec::direct::{DirectLight, DirectSpec};

use super::finish;
use crate::builder::{Builder, Sig, TooWide};
use crate::design::Design;
use crate::units::{self, Light, UnitNormal};

/// q from t, one reciprocal root for all lights, then J, K and 2 J K - L·V. [lecture, eq. 4.3 to 4.6]
pub(super) fn core(b: Builder, spec: &CoreSpec, direct: &DirectSpec) -> Result<Design, TooWide> {
    let control = b.control();
    let inputs = direct.inputs(spec).map(|port| b.input(port));
    let formats = &direct.formats;
    let t = units::parameter(&b, &control.start, &inputs.weight_step, formats, spec.longest_span - 1);
    let q = units::squared_length(&b, &t, &inputs.spread, formats);
    // Unit ends are no closer to each other's middle than those of which the longer alone is a unit vector.
    let smallest_q = spec.shortest_normal * spec.shortest_normal;
    let s = units::reciprocal_square_root(&b, &q, formats.reciprocal.into(), smallest_q);
    let view = [&inputs.view.start, &inputs.view.delta];
    let normal = UnitNormal::new(&t, &inputs.spread, formats, spec.shortest_normal);
    let k = b.instance("n_dot_v", || units::direct_cosine(&b, &t, view, &s, formats, normal));
    let pixel = Pixel { b: &b, direct, t: &t, q: &q, s: &s, k: &k, smallest_q, normal, exponent: &inputs.exponent };
    let lights: Vec<Light> = inputs.lights.iter().enumerate().map(|(i, light)| pixel.shade(i, light)).collect();
    finish(&b, &control, &inputs.ambient, &lights)
}

/// What the lights have in common.
struct Pixel<'a> {
    b: &'a Builder,
    direct: &'a DirectSpec,
    t: &'a Sig,
    q: &'a Sig,
    s: &'a Sig,
    k: &'a Sig,
    smallest_q: f64,
    normal: UnitNormal,
    exponent: &'a Sig,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &DirectLight<Sig>) -> Light {
        let (b, formats) = (self.b, &self.direct.formats);
        let called = |unit: &str| format!("light{index}_{unit}");
        let ends = [&light.light.start, &light.light.delta];
        let j = b.instance(&called("n_dot_l"), || units::direct_cosine(b, self.t, ends, self.s, formats, self.normal));
        let bits = formats.base.fraction_bits;
        let base = || units::directed_base(b, [&j, self.k], &light.light_dot_view, self.q, self.smallest_q, bits);
        let base = b.instance(&called("base"), base);
        let power = || units::raised(b, &base, self.exponent, self.direct.power_unit());
        Light {
            diffuse: b.instance(&called("diffuse"), || units::kept_within_one(b, &j, formats.diffuse.fraction_bits)),
            specular: b.instance(&called("power"), power),
            diffuse_coefficients: light.diffuse.clone(),
            specular_coefficients: light.specular.clone(),
        }
    }
}

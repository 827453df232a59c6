//! Lyon's core.
use specula_scene::CoreSpec;
use specula_scene::spec::lyon::{LyonLight, LyonSpec};

use super::eye;
use crate::builder::{Builder, Sig, TooWide, Vector};
use crate::design::Design;
use crate::units::{self, Light, SpanNormals};

/// Interpolated normal, approximate normalisation, and for each light N·L and f_k of D. [Lyon, TR 43, fig. 6 to 8]
pub(super) fn core(b: Builder, spec: &CoreSpec, lyon: &LyonSpec) -> Result<Design, TooWide> {
    let control = b.control();
    let inputs = lyon.inputs(spec).map(|port| b.input(port));
    let span = SpanNormals {
        first: &control.start,
        start: &Vector::new(inputs.normal_start),
        delta: &Vector::new(inputs.normal_delta),
        weight_step: &inputs.weight_step,
    };
    let f = &lyon.formats;
    let normal = units::interpolate(&b, span, [f.weight_accumulator, f.weight, f.vector], spec.longest_span - 1);
    let (n, has_direction) = units::normalise(&b, &normal, lyon, spec.shortest_normal);
    let pixel = Pixel { b: &b, lyon, n: &n, has_direction: &has_direction, shininess: &inputs.shininess };
    let lights: Vec<Light> = inputs.lights.iter().enumerate().map(|(i, light)| pixel.shade(i, light)).collect();
    let [red, green, blue] = units::channels(&b, &inputs.ambient, &lights);
    b.clone().finish(&control.valid, &control.start, &[("red", red), ("green", green), ("blue", blue)])
}

/// What the lights have in common.
struct Pixel<'a> {
    b: &'a Builder,
    lyon: &'a LyonSpec,
    n: &'a Vector,
    has_direction: &'a Sig,
    shininess: &'a Sig,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &LyonLight<Sig>) -> Light {
        let (b, formats) = (self.b, &self.lyon.formats);
        let called = |unit: &str| format!("light{index}_{unit}");
        let direction = Vector::new(light.direction.clone());
        let d = b.instance(&called("difference"), || match &light.halfway {
            Some(halfway) => units::halfway_cross_normal(b, &Vector::new(halfway.clone()), self.n, formats),
            None => units::reflection_minus_light(b, self.n, &eye(b), &direction, formats),
        });
        let shape = || units::shape(b, &d, self.shininess, self.has_direction, self.lyon);
        Light {
            diffuse: b.instance(&called("diffuse"), || units::diffuse(b, self.n, &direction, formats)),
            specular: b.instance(&called("shape"), shape),
            diffuse_coefficients: light.diffuse.clone(),
            specular_coefficients: light.specular.clone(),
        }
    }
}

//! The core of linearly interpolated or uniform intensities.
use specula_spec::CoreSpec;
use specula_spec::gouraud::{GouraudLight, GouraudSpec, Intensity};

use super::{finish, pipelines, time_slots};
use crate::units::{self, Light};
use specula_datapath::builder::{BuildError, Builder, Sig};
use specula_datapath::graph::Graph;

/// For each light a diffuse and a specular intensity, one accumulator each, or none where they are
/// uniform. [lecture, eq. 2.1 and 3.2 to 3.6]
pub(super) fn core(
    b: Builder,
    spec: &CoreSpec,
    gouraud: &GouraudSpec,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, spec);
    let inputs = gouraud.inputs(spec).map(|port| b.input(port));
    let fraction_bits = gouraud.formats.intensity.fraction_bits;
    let intensity = |intensity: &Intensity<Sig>, name: String| match &intensity.step {
        Some(step) => {
            let ends = (&intensity.start, step);
            b.instance(&name, || {
                units::gouraud(&b, &slots.first_pixel, ends, fraction_bits, spec.longest_span - 1)
            })
        }
        None => intensity.start.clone(),
    };
    let light = |(i, light): (usize, &GouraudLight<Sig>)| Light {
        diffuse: intensity(&light.diffuse_intensity, format!("light{i}_diffuse")),
        specular: intensity(&light.specular_intensity, format!("light{i}_specular")),
        diffuse_coefficients: light.diffuse.clone(),
        specular_coefficients: light.specular.clone(),
    };
    let lights: Vec<Light> =
        pipelines(&slots, &inputs.lights).iter().enumerate().map(light).collect();
    finish(&b, &slots, &inputs.ambient, &lights)
}

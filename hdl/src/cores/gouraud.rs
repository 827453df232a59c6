//! The core of linearly interpolated or uniform intensities.
use specula_spec::gouraud::{GouraudInputs, GouraudLight, GouraudSpec, Intensity};
use specula_spec::{CoreParameters, InputPort};

use super::common::{Intensities, finish, time_slots};
use crate::units;
use specula_datapath::builder::{BuildError, Builder, Sig};
use specula_datapath::graph::Graph;

/// For each light a diffuse and a specular intensity, one accumulator each, or none where they are
/// uniform. [lecture, eq. 2.1 and 3.2 to 3.6]
pub(super) fn core(
    b: Builder,
    parameters: &CoreParameters,
    gouraud: &GouraudSpec,
    ports: &GouraudInputs<InputPort>,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, parameters);
    let inputs = ports.map(|port| b.input(port));
    let fraction_bits = gouraud.formats.intensity.fraction_bits;
    let intensity = |intensity: &Intensity<Sig>, name: String| match &intensity.step {
        Some(step) => {
            let ends = (&intensity.start, step);
            b.instance(&name, || {
                units::gouraud(
                    &b,
                    &slots.first_pixel,
                    ends,
                    fraction_bits,
                    parameters.longest_span - 1,
                )
            })
        }
        None => intensity.start.clone(),
    };
    let shade = |i: usize, light: &GouraudLight<Sig>| Intensities {
        diffuse: intensity(&light.diffuse_intensity, format!("light{i}_diffuse")),
        specular: intensity(&light.specular_intensity, format!("light{i}_specular")),
    };
    finish(&b, parameters, &slots, &inputs, shade)
}

//! `gouraud`, bit for bit [lecture, eq. 2.1 and 3.2 to 3.6; methods A3, A4;
//! `docs/arithmetic/gouraud.md`].
use std::fmt;

use specula_spec::gouraud::{GouraudFormats, GouraudInputs, GouraudLight, GouraudSpec, Intensity};
use specula_spec::{Format, Linear, NoInputs};

use super::error::PacketError;
use super::method::{Intensities, Method};
use super::number::{Wide, round_to};
use super::observer::Observer;
use super::span_extent::SpanExtent;

/// The method in one core's formats.
pub(super) struct Gouraud {
    formats: GouraudFormats,
}

impl Gouraud {
    pub fn new(gouraud: &GouraudSpec) -> Gouraud {
        Gouraud { formats: gouraud.formats.clone() }
    }
}

impl Method for Gouraud {
    type Span = NoInputs<Wide>;
    type Light = GouraudLight<Wide>;
    type State = ();
    /// Its number.
    type Pixel = u32;

    fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.formats.intensity, specular: self.formats.intensity }
    }

    fn check(&self, inputs: &GouraudInputs<Wide>, extent: SpanExtent) -> Result<(), PacketError> {
        let check = |name: fmt::Arguments<'_>, intensity: &Intensity<Wide>| {
            let linear =
                Linear { start: intensity.start, step: intensity.step.unwrap_or_default() };
            extent.linear(name, &linear, self.formats.accumulator, (0, 1))
        };
        inputs.lights.iter().enumerate().try_for_each(|(index, light)| {
            check(format_args!("light{index}_diffuse_intensity"), &light.light.diffuse_intensity)?;
            check(format_args!("light{index}_specular_intensity"), &light.light.specular_intensity)
        })
    }

    fn pixel(&self, _span: &NoInputs<Wide>, (): (), i: u32, _observer: &mut impl Observer) -> u32 {
        i
    }

    fn light(
        &self,
        &i: &u32,
        light: &GouraudLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        Intensities {
            diffuse: self.intensity("diffuse", &light.diffuse_intensity, i, observer),
            specular: self.intensity("specular", &light.specular_intensity, i, observer),
        }
    }
}

impl Gouraud {
    fn intensity(
        &self,
        name: &str,
        intensity: &Intensity<Wide>,
        i: u32,
        observer: &mut impl Observer,
    ) -> Wide {
        let value = match intensity.step {
            Some(step) => {
                let accumulated = intensity.start + Wide::from_num(i) * step;
                observer.see(
                    format_args!("{name}_accumulator"),
                    accumulated,
                    self.formats.accumulator,
                );
                round_to(accumulated, self.formats.intensity.fraction_bits)
                    .clamp(Wide::ZERO, Wide::ONE)
            }
            None => intensity.start,
        };
        observer.see(format_args!("{name}"), value, self.formats.intensity);
        value
    }
}

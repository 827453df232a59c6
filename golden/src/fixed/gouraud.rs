//! `gouraud`, bit for bit [lecture, eq. 2.1 and 3.2 to 3.6; methods A3, A4;
//! `docs/arithmetic/gouraud.md`].
use std::fmt;

use specula_spec::gouraud::{GouraudFormats, GouraudInputs, GouraudSpec, Intensity};
use specula_spec::{CoreSpec, Format, InputPort, Linear};

use super::colour::{Colour, sum_format};
use super::course::Course;
use super::error::PacketError;
use super::method::{Method, Values};
use super::number::{Wide, round_to};
use super::observer::{Observer, OfLight};

/// The method in one core's formats.
pub(super) struct Gouraud {
    formats: GouraudFormats,
    colour: Format,
    ports: GouraudInputs<InputPort>,
}

impl Gouraud {
    pub fn new(core: &CoreSpec, gouraud: &GouraudSpec) -> Gouraud {
        let intensity = gouraud.formats.intensity;
        Gouraud {
            formats: gouraud.formats.clone(),
            colour: sum_format(core, intensity, intensity),
            ports: gouraud.inputs(core),
        }
    }
}

impl Method for Gouraud {
    type Inputs = GouraudInputs<Wide>;
    type State = ();

    fn read(&self, mut values: Values<'_>) -> GouraudInputs<Wide> {
        self.ports.map(|port| values.next(port))
    }

    fn check(&self, inputs: &GouraudInputs<Wide>, course: Course) -> Result<(), PacketError> {
        let check = |name: fmt::Arguments<'_>, intensity: &Intensity<Wide>| {
            let linear =
                Linear { start: intensity.start, step: intensity.step.unwrap_or_default() };
            course.linear(name, &linear, self.formats.accumulator, (0, 1))
        };
        inputs.lights.iter().enumerate().try_for_each(|(index, light)| {
            check(format_args!("light{index}_diffuse_intensity"), &light.diffuse_intensity)?;
            check(format_args!("light{index}_specular_intensity"), &light.specular_intensity)
        })
    }

    fn pixel(
        &self,
        inputs: &GouraudInputs<Wide>,
        (): (),
        i: u32,
        observer: &mut impl Observer,
    ) -> [u8; 3] {
        let mut colour = Colour::ambient(inputs.ambient);
        for (index, light) in inputs.lights.iter().enumerate() {
            let mut observer = OfLight { observer, index };
            colour.add(
                &light.diffuse,
                self.intensity("diffuse", &light.diffuse_intensity, i, &mut observer),
            );
            colour.add(
                &light.specular,
                self.intensity("specular", &light.specular_intensity, i, &mut observer),
            );
        }
        colour.code(self.colour, observer)
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

//! `hybrid`, bit for bit [Hast, Barrera and Bengtsson, eq. 17 to 26; methods C3;
//! `docs/arithmetic.md`].
use specula_spec::hybrid::{HybridFormats, HybridInputs, HybridLight, HybridSpec};
use specula_spec::{CoreSpec, Format, InputPort, Linear};

use super::colour::{Colour, sum_format};
use super::course::Course;
use super::error::PacketError;
use super::forward::Accumulator;
use super::highlight::quotient;
use super::method::{Method, Values};
use super::number::{Wide, round_to};
use super::observer::{Observer, OfLight};
use super::raised::Raised;

/// The method in one core's formats.
pub(super) struct Hybrid {
    power: Raised,
    formats: HybridFormats,
    colour: Format,
    ports: HybridInputs<InputPort>,
}

impl Hybrid {
    pub fn new(core: &CoreSpec, hybrid: &HybridSpec) -> Hybrid {
        Hybrid {
            power: Raised::new(core, hybrid.power_unit()),
            formats: hybrid.formats.clone(),
            colour: sum_format(core, hybrid.formats.diffuse, hybrid.power_unit().format()),
            ports: hybrid.inputs(core),
        }
    }
}

impl Method for Hybrid {
    type Inputs = HybridInputs<Wide>;
    type State = ();

    fn read(&self, mut values: Values<'_>) -> HybridInputs<Wide> {
        self.ports.map(|port| values.next(port))
    }

    fn check(&self, inputs: &HybridInputs<Wide>, course: Course) -> Result<(), PacketError> {
        let f = &self.formats;
        course.quadratic(
            format_args!("denominator"),
            &inputs.denominator,
            f.accumulator,
            (0, 1),
        )?;
        inputs.lights.iter().enumerate().try_for_each(|(index, light)| {
            course.quadratic(
                format_args!("light{index}_numerator"),
                &light.numerator,
                f.accumulator,
                (-1, 1),
            )?;
            let intensity = Linear { start: light.intensity_start, step: light.intensity_step };
            course.linear(
                format_args!("light{index}_intensity"),
                &intensity,
                f.diffuse_accumulator,
                (0, 1),
            )
        })
    }

    fn pixel(
        &self,
        inputs: &HybridInputs<Wide>,
        (): (),
        i: u32,
        observer: &mut impl Observer,
    ) -> [u8; 3] {
        let f = &self.formats;
        let operand = Accumulator { exact: f.accumulator, rounded: f.operand };
        let q = operand.quadratic(observer, "denominator", &inputs.denominator, i);
        let mut colour = Colour::ambient(inputs.ambient);
        for (index, light) in inputs.lights.iter().enumerate() {
            let mut observer = OfLight { observer, index };
            let p = operand.quadratic(&mut observer, "numerator", &light.numerator, i);
            let base = quotient(&mut observer, p, q, f.base);
            colour.add(&light.diffuse, self.diffuse(light, i, &mut observer));
            colour.add(&light.specular, self.power.of(&mut observer, base, inputs.exponent));
        }
        colour.code(self.colour, observer)
    }
}

impl Hybrid {
    /// Gouraud's intensity, kept within 0 to 1.
    fn diffuse(&self, light: &HybridLight<Wide>, i: u32, observer: &mut impl Observer) -> Wide {
        let accumulated = light.intensity_start + Wide::from_num(i) * light.intensity_step;
        observer.see(
            format_args!("intensity_accumulator"),
            accumulated,
            self.formats.diffuse_accumulator,
        );
        let rounded = round_to(accumulated, self.formats.diffuse.fraction_bits);
        let diffuse = rounded.clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("diffuse"), diffuse, self.formats.diffuse);
        diffuse
    }
}

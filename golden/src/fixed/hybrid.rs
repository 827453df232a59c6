//! `hybrid`, bit for bit [Hast, Barrera and Bengtsson, eq. 17 to 26; METHODS.md C3; `docs/arithmetic.md`].
use specula_scene::Format;
use specula_scene::spec::hybrid::{HybridFormats, HybridInputs, HybridLight, HybridSpec};
use specula_scene::spec::{CoreSpec, InputPort, Quadratic};

use super::colour::{Colour, sum_format};
use super::method::{Method, Values};
use super::number::{Wide, round_quotient, round_to};
use super::observer::{Observer, OfLight, narrow};
use super::packet::PacketError;

/// The method in one core's formats.
pub(super) struct Hybrid {
    formats: HybridFormats,
    colour: Format,
    ports: HybridInputs<InputPort>,
}

impl Hybrid {
    pub fn new(core: &CoreSpec, hybrid: &HybridSpec) -> Hybrid {
        Hybrid {
            formats: hybrid.formats.clone(),
            colour: sum_format(core, hybrid.formats.diffuse, hybrid.formats.base),
            ports: hybrid.inputs(core),
        }
    }
}

impl Method for Hybrid {
    type Inputs = HybridInputs<Wide>;

    fn read(&self, mut values: Values<'_>) -> HybridInputs<Wide> {
        self.ports.map(|port| values.next(port))
    }

    /// Everything within the ports' ranges can be computed.
    fn check(&self, _: &HybridInputs<Wide>, _: u32) -> Result<(), PacketError> {
        Ok(())
    }

    fn pixel(&self, inputs: &HybridInputs<Wide>, i: u32, observer: &mut impl Observer) -> [u8; 3] {
        let q = self.operand("denominator", &inputs.denominator, i, observer);
        let mut colour = Colour::ambient(inputs.ambient);
        for (index, light) in inputs.lights.iter().enumerate() {
            let mut observer = OfLight { observer, index };
            let p = self.operand("numerator", &light.numerator, i, &mut observer);
            let base = self.base(p, q, &mut observer);
            colour.add(&light.diffuse, self.diffuse(light, i, &mut observer));
            colour.add(&light.specular, self.power(base, inputs.log2_shininess, &mut observer));
        }
        colour.code(self.colour, observer)
    }
}

impl Hybrid {
    /// p or q at pixel `i`: start + first · i + second · i(i - 1)/2, rounded for the divider.
    fn operand(&self, name: &str, quadratic: &Quadratic<Wide>, i: u32, observer: &mut impl Observer) -> Wide {
        let pairs = Wide::from_num(u64::from(i) * u64::from(i).saturating_sub(1) / 2);
        let accumulated = quadratic.start + quadratic.first_difference * Wide::from_num(i) + quadratic.second_difference * pairs;
        observer.see(format_args!("{name}_accumulator"), accumulated, self.formats.accumulator);
        narrow(observer, format_args!("{name}"), accumulated, self.formats.operand)
    }

    /// R·L = p/q, kept within 0 to 1.
    fn base(&self, p: Wide, q: Wide, observer: &mut impl Observer) -> Wide {
        let quotient = if p <= Wide::ZERO || q <= Wide::ZERO {
            Wide::ZERO
        } else if p >= q {
            Wide::ONE
        } else {
            round_quotient(p, q, self.formats.base.fraction_bits)
        };
        observer.see(format_args!("base"), quotient, self.formats.base);
        quotient
    }

    /// base^n, n = 2^j, by j squarings.
    fn power(&self, base: Wide, log2_shininess: Wide, observer: &mut impl Observer) -> Wide {
        let squarings = log2_shininess.to_num::<u32>();
        (0..squarings).fold(base, |b, j| narrow(observer, format_args!("square{j}"), b * b, self.formats.base))
    }

    /// Gouraud's intensity, kept within 0 to 1.
    fn diffuse(&self, light: &HybridLight<Wide>, i: u32, observer: &mut impl Observer) -> Wide {
        let accumulated = light.intensity_start + Wide::from_num(i) * light.intensity_step;
        observer.see(format_args!("intensity_accumulator"), accumulated, self.formats.diffuse_accumulator);
        let rounded = round_to(accumulated, self.formats.diffuse.fraction_bits);
        let diffuse = rounded.clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("diffuse"), diffuse, self.formats.diffuse);
        diffuse
    }
}

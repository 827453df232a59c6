//! `lyon`, bit for bit [Lyon, TR 43; METHODS.md B; `docs/arithmetic.md`].
use specula_scene::Format;
use specula_scene::spec::lyon::{LyonFormats, LyonInputs, LyonLight, LyonSpec, Normalisation};
use specula_scene::spec::{CoreSpec, InputPort};

use super::colour::{Colour, sum_format};
use super::method::{Method, Values};
use super::number::Wide;
use super::observer::{Observer, OfLight, narrow, narrow_vector};
use super::packet::{self, PacketError};
use super::vector::{Vector, cross, dot};

/// V = (0, 0, 1).
const EYE: Vector = [Wide::ZERO, Wide::ZERO, Wide::ONE];
const THREE: Wide = Wide::lit("3");

/// The method in one core's formats.
pub(super) struct Lyon {
    normalisation: Normalisation,
    newton_steps: u32,
    squarings: u32,
    formats: LyonFormats,
    colour: Format,
    ports: LyonInputs<InputPort>,
}

impl Lyon {
    pub fn new(core: &CoreSpec, lyon: &LyonSpec) -> Lyon {
        Lyon {
            normalisation: lyon.normalisation,
            newton_steps: lyon.newton_steps,
            squarings: lyon.squarings,
            formats: lyon.formats.clone(),
            colour: sum_format(core, lyon.formats.diffuse, lyon.formats.shape),
            ports: lyon.inputs(core),
        }
    }
}

impl Method for Lyon {
    type Inputs = LyonInputs<Wide>;

    fn read(&self, mut values: Values<'_>) -> LyonInputs<Wide> {
        self.ports.map(|port| values.next(port))
    }

    /// Whether Newton's steps converge and |n| < 2.
    ///
    /// |N0|², |N1|² ≤ 1.25 and a ≤ 1 + 1/16 give |N'| ≤ √1.25 · (1 + 2/16) + √3/32 (rounding to `S1.4`) < 1.32, so z < 1.75. There z·g1² ≤ 1 and
    /// z·g2² < 1.42, inside the 3 below which g(3 - z g²)/2 goes towards 1/√z, and |n| = g√z < 1.2 at first and 1 after a step, before
    /// rounding.
    fn check(&self, inputs: &LyonInputs<Wide>, length: u32) -> Result<(), PacketError> {
        packet::check_ends(&inputs.normal_start, &inputs.normal_delta)?;
        packet::check_weight(inputs.weight_step, length)
    }

    fn pixel(&self, inputs: &LyonInputs<Wide>, i: u32, observer: &mut impl Observer) -> [u8; 3] {
        let (normal, z) = self.normal(inputs, i, observer);
        let mut colour = Colour::ambient(inputs.ambient);
        for (index, light) in inputs.lights.iter().enumerate() {
            let mut observer = OfLight { observer, index };
            colour.add(&light.diffuse, self.diffuse(&normal, light, &mut observer));
            let highlight = self.specular(&normal, light, inputs.shininess, &mut observer);
            colour.add(&light.specular, if z == Wide::ZERO { Wide::ZERO } else { highlight });
        }
        colour.code(self.colour, observer)
    }
}

impl Lyon {
    /// n = g N', with N' = N0 + a (N1 - N0), and z = N'·N'.
    fn normal(&self, inputs: &LyonInputs<Wide>, i: u32, observer: &mut impl Observer) -> (Vector, Wide) {
        let f = &self.formats;
        let accumulated = Wide::from_num(i) * inputs.weight_step;
        observer.see(format_args!("weight_accumulator"), accumulated, f.weight_accumulator);
        let weight = narrow(observer, format_args!("weight"), accumulated, f.weight);
        let lerp: Vector = std::array::from_fn(|c| inputs.normal_start[c] + weight * inputs.normal_delta[c]);
        let interpolated = narrow_vector(observer, "interpolated", lerp, f.vector);
        let z = narrow(observer, format_args!("length_squared"), dot(&interpolated, &interpolated), f.length_squared);
        let gain = self.gain(z, observer);
        (narrow_vector(observer, "normal", interpolated.map(|c| gain * c), f.vector), z)
    }

    /// g, near 1/√z: g1 or g2 (METHODS.md B8, B9), then Newton steps.
    fn gain(&self, z: Wide, observer: &mut impl Observer) -> Wide {
        let y = Wide::ONE - z;
        let first = match self.normalisation {
            Normalisation::G1 => Wide::ONE + (y >> 1),
            Normalisation::G2 => Wide::ONE + ((y + y * y) >> 1),
        };
        let first = narrow(observer, format_args!("gain"), first, self.formats.gain);
        (0..self.newton_steps).fold(first, |g, step| self.newton(g, z, step, observer))
    }

    /// g (3 - z g²)/2.
    fn newton(&self, g: Wide, z: Wide, step: u32, observer: &mut impl Observer) -> Wide {
        let format = self.formats.gain;
        let square = narrow(observer, format_args!("newton{step}_square"), g * g, format);
        let factor = narrow(observer, format_args!("newton{step}_factor"), THREE - z * square, format);
        narrow(observer, format_args!("newton{step}_gain"), (g * factor) >> 1, format)
    }

    fn diffuse(&self, normal: &Vector, light: &LyonLight<Wide>, observer: &mut impl Observer) -> Wide {
        // Rounding is monotonic and leaves 0 as it is, so that the clamp may come first.
        let cosine = dot(normal, &light.direction).max(Wide::ZERO);
        narrow(observer, format_args!("diffuse"), cosine, self.formats.diffuse)
    }

    /// f_k of x = (n/2) D·D.
    fn specular(&self, normal: &Vector, light: &LyonLight<Wide>, shininess: Wide, observer: &mut impl Observer) -> Wide {
        let difference = match &light.halfway {
            Some(halfway) => self.halfway_cross_normal(halfway, normal, observer),
            None => self.reflection_minus_light(normal, &light.direction, observer),
        };
        let argument = (shininess * dot(&difference, &difference)) >> (self.squarings + 1);
        let argument = narrow(observer, format_args!("shape_argument"), argument, self.formats.shape);
        let shape = (Wide::ONE - argument).max(Wide::ZERO);
        observer.see(format_args!("shape"), shape, self.formats.shape);
        (0..self.squarings).fold(shape, |f, k| narrow(observer, format_args!("square{k}"), f * f, self.formats.shape))
    }

    /// D = H × n (METHODS.md B13).
    fn halfway_cross_normal(&self, halfway: &Vector, normal: &Vector, observer: &mut impl Observer) -> Vector {
        narrow_vector(observer, "difference", cross(halfway, normal), self.formats.difference)
    }

    /// D = 2(n·V) n - V - L (METHODS.md B2).
    fn reflection_minus_light(&self, normal: &Vector, light: &Vector, observer: &mut impl Observer) -> Vector {
        let format = self.formats.difference;
        let twice = narrow(observer, format_args!("twice_n_dot_v"), dot(normal, &EYE) << 1, format);
        let difference = std::array::from_fn(|c| twice * normal[c] - EYE[c] - light[c]);
        narrow_vector(observer, "difference", difference, format)
    }
}

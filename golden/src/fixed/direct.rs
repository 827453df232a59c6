//! `direct`, bit for bit [lecture, eq. 4.3 to 4.6; METHODS.md A6, A7; `docs/arithmetic/direct.md`].
use specula_scene::Format;
use specula_scene::spec::direct::{DirectFormats, DirectInputs, DirectLight, DirectSpec, Ends};
use specula_scene::spec::{CoreSpec, InputPort};

use super::colour::{Colour, sum_format};
use super::course::Course;
use super::method::{Method, Values};
use super::number::{Wide, round_to};
use super::observer::{Observer, OfLight, narrow};
use super::packet::PacketError;
use super::raised::Raised;
use super::root::reciprocal_square_root;

/// The method in one core's formats.
pub(super) struct Direct {
    power: Raised,
    formats: DirectFormats,
    colour: Format,
    ports: DirectInputs<InputPort>,
}

/// What the lights have in common at one pixel.
struct Pixel {
    t: Wide,
    q: Wide,
    s: Wide,
    n_dot_v: Wide,
    exponent: Wide,
}

impl Direct {
    pub fn new(core: &CoreSpec, direct: &DirectSpec) -> Direct {
        Direct {
            power: Raised::new(core, direct.power_unit()),
            formats: direct.formats.clone(),
            colour: sum_format(core, direct.formats.diffuse, direct.power_unit().format()),
            ports: direct.inputs(core),
        }
    }
}

impl Method for Direct {
    type Inputs = DirectInputs<Wide>;

    fn read(&self, mut values: Values<'_>) -> DirectInputs<Wide> {
        self.ports.map(|port| values.next(port))
    }

    /// With t below 2, q, 1/√q and scalars are as small as their formats say, but for a bit or two.
    fn check(&self, inputs: &DirectInputs<Wide>, course: Course) -> Result<(), PacketError> {
        course.weight(inputs.weight_step, self.formats.weight_accumulator)
    }

    fn pixel(&self, inputs: &DirectInputs<Wide>, i: u32, observer: &mut impl Observer) -> [u8; 3] {
        let pixel = self.common(inputs, i, observer);
        let mut colour = Colour::ambient(inputs.ambient);
        for (index, light) in inputs.lights.iter().enumerate() {
            let mut observer = OfLight { observer, index };
            let n_dot_l = self.cosine("n_dot_l", &light.light, pixel.t, pixel.s, &mut observer);
            let diffuse = round_to(n_dot_l, self.formats.diffuse.fraction_bits).max(Wide::ZERO);
            observer.see(format_args!("diffuse"), diffuse, self.formats.diffuse);
            colour.add(&light.diffuse, diffuse);
            colour.add(&light.specular, self.highlight(&pixel, n_dot_l, light, &mut observer));
        }
        colour.code(self.colour, observer)
    }
}

impl Direct {
    fn common(&self, inputs: &DirectInputs<Wide>, i: u32, observer: &mut impl Observer) -> Pixel {
        let f = &self.formats;
        let accumulated = inputs.weight_step * Wide::from_num(i);
        observer.see(format_args!("weight_accumulator"), accumulated, f.weight_accumulator);
        let t = narrow(observer, format_args!("weight"), accumulated, f.weight);
        let product = narrow(observer, format_args!("product"), t * (Wide::ONE - t), f.product);
        let q = narrow(observer, format_args!("length_squared"), Wide::ONE - inputs.spread * product, f.length_squared);
        let s = reciprocal_square_root(q, f.reciprocal.integer_bits, f.reciprocal.fraction_bits);
        observer.see(format_args!("reciprocal"), s, f.reciprocal);
        let n_dot_v = self.cosine("n_dot_v", &inputs.view, t, s, observer);
        Pixel { t, q, s, n_dot_v, exponent: inputs.exponent }
    }

    /// N·X s, kept within -1 to 1.
    fn cosine(&self, name: &str, ends: &Ends<Wide>, t: Wide, s: Wide, observer: &mut impl Observer) -> Wide {
        let format = self.formats.cosine;
        let linear = narrow(observer, format_args!("{name}_linear"), ends.start + t * ends.delta, format);
        let cosine = round_to(linear * s, format.fraction_bits).clamp(-Wide::ONE, Wide::ONE);
        observer.see(format_args!("{name}"), cosine, format);
        cosine
    }

    /// max(2 J K - L·V, 0)^n; none for a normal without direction.
    fn highlight(&self, pixel: &Pixel, n_dot_l: Wide, light: &DirectLight<Wide>, observer: &mut impl Observer) -> Wide {
        let format = self.formats.base;
        let rounded = round_to(n_dot_l * pixel.n_dot_v * 2 - light.light_dot_view, format.fraction_bits);
        let base = if pixel.q > Wide::ZERO { rounded.clamp(Wide::ZERO, Wide::ONE) } else { Wide::ZERO };
        observer.see(format_args!("base"), base, format);
        self.power.of(observer, base, pixel.exponent)
    }
}

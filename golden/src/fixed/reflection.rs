//! `reflection`, bit for bit [Hast, Barrera and Bengtsson, eq. 27 to 34; methods C4 to C6 and
//! C12 to C14; `docs/arithmetic.md`].
use std::fmt;

use specula_spec::reflection::{
    Highlight, ReflectionFormats, ReflectionInputs, ReflectionLight, ReflectionSpec,
};
use specula_spec::{CoreSpec, Format, InputPort, Quadratic};

use super::colour::{Colour, sum_format};
use super::course::Course;
use super::error::PacketError;
use super::forward::Accumulator;
use super::highlight::{amount, cosine, quotient, reflection};
use super::method::{Method, Values};
use super::number::{Wide, round_quotient};
use super::observer::{Observer, OfLight};
use super::raised::Raised;

/// The largest 1/q.
const LARGEST_RECIPROCAL: Wide = Wide::lit("4");

/// The method in one core's formats.
pub(super) struct Reflection {
    highlight: Highlight,
    power: Raised,
    formats: ReflectionFormats,
    colour: Format,
    ports: ReflectionInputs<InputPort>,
}

/// What the lights have in common at one pixel.
struct Pixel {
    i: u32,
    q: Wide,
    /// 1/q.
    w: Wide,
    /// N'·V, and N·N; 0 where nobody asks.
    v: Wide,
    normal_squared: Wide,
}

impl Reflection {
    pub fn new(core: &CoreSpec, spec: &ReflectionSpec) -> Reflection {
        Reflection {
            highlight: spec.specular,
            power: Raised::new(core, spec.power_unit()),
            formats: spec.formats.clone(),
            colour: sum_format(core, spec.formats.diffuse, spec.power_unit().format()),
            ports: spec.inputs(core),
        }
    }

    /// An operand at pixel i; 0 for an input that is not there.
    fn operand(
        &self,
        observer: &mut impl Observer,
        name: &str,
        quadratic: Option<&Quadratic<Wide>>,
        i: u32,
    ) -> Wide {
        let accumulator =
            Accumulator { exact: self.formats.accumulator, rounded: self.formats.operand };
        quadratic
            .map_or(Wide::ZERO, |quadratic| accumulator.quadratic(observer, name, quadratic, i))
    }

    /// 1/q, 4 at most, and 0 for q ≤ 0.
    fn reciprocal(&self, observer: &mut impl Observer, q: Wide) -> Wide {
        let format = self.formats.reciprocal;
        let w = if q <= Wide::ZERO {
            Wide::ZERO
        } else if q * LARGEST_RECIPROCAL <= Wide::ONE {
            LARGEST_RECIPROCAL
        } else {
            round_quotient(Wide::ONE, q, format.fraction_bits)
        };
        observer.see(format_args!("reciprocal"), w, format);
        w
    }

    fn common(
        &self,
        inputs: &ReflectionInputs<Wide>,
        i: u32,
        observer: &mut impl Observer,
    ) -> Pixel {
        let q = self.operand(observer, "denominator", Some(&inputs.denominator), i);
        let w = self.reciprocal(observer, q);
        let view = self.operand(observer, "view", inputs.view.as_ref(), i);
        let v = cosine(observer, "view_cosine", view * w, self.formats.cosine);
        let normal_squared =
            self.operand(observer, "normal_squared", inputs.normal_squared.as_ref(), i);
        Pixel { i, q, w, v, normal_squared }
    }

    /// The base of the highlight, 0 to 1.
    fn base(
        &self,
        pixel: &Pixel,
        light: &ReflectionLight<Wide>,
        c: Wide,
        observer: &mut impl Observer,
    ) -> Wide {
        let f = &self.formats;
        match self.highlight {
            Highlight::Blinn => {
                let halfway = self.operand(observer, "halfway", light.halfway.as_ref(), pixel.i);
                let h = cosine(observer, "halfway_cosine", halfway * pixel.w, f.cosine);
                amount(observer, "base", h, f.base)
            }
            Highlight::Hybrid => {
                let p = self.operand(observer, "numerator", light.numerator.as_ref(), pixel.i);
                quotient(observer, p, pixel.normal_squared, f.base)
            }
            Highlight::Eq34 => {
                let dot_view = light.dot_view.unwrap_or(Wide::ZERO);
                reflection(observer, pixel.q > Wide::ZERO, ((pixel.v * c) << 1) - dot_view, f.base)
            }
        }
    }
}

impl Method for Reflection {
    type Inputs = ReflectionInputs<Wide>;
    type State = ();

    fn read(&self, mut values: Values<'_>) -> ReflectionInputs<Wide> {
        self.ports.map(|port| values.next(port))
    }

    fn check(&self, inputs: &ReflectionInputs<Wide>, course: Course) -> Result<(), PacketError> {
        let check = |name: fmt::Arguments<'_>, quadratic: Option<&Quadratic<Wide>>, low: i32| {
            quadratic.map_or(Ok(()), |quadratic| {
                course.quadratic(name, quadratic, self.formats.accumulator, (low, 1))
            })
        };
        check(format_args!("denominator"), Some(&inputs.denominator), 0)?;
        check(format_args!("view"), inputs.view.as_ref(), -1)?;
        check(format_args!("normal_squared"), inputs.normal_squared.as_ref(), 0)?;
        inputs.lights.iter().enumerate().try_for_each(|(index, light)| {
            check(format_args!("light{index}_p"), Some(&light.cosine), -1)?;
            check(format_args!("light{index}_halfway"), light.halfway.as_ref(), -1)?;
            check(format_args!("light{index}_numerator"), light.numerator.as_ref(), -1)
        })
    }

    fn pixel(
        &self,
        inputs: &ReflectionInputs<Wide>,
        (): (),
        i: u32,
        observer: &mut impl Observer,
    ) -> [u8; 3] {
        let pixel = self.common(inputs, i, observer);
        let mut colour = Colour::ambient(inputs.ambient);
        for (index, light) in inputs.lights.iter().enumerate() {
            let mut observer = OfLight { observer, index };
            let p = self.operand(&mut observer, "p", Some(&light.cosine), i);
            let c = cosine(&mut observer, "cosine", p * pixel.w, self.formats.cosine);
            colour.add(&light.diffuse, amount(&mut observer, "diffuse", c, self.formats.diffuse));
            let base = self.base(&pixel, light, c, &mut observer);
            colour.add(&light.specular, self.power.of(&mut observer, base, inputs.exponent));
        }
        colour.code(self.colour, observer)
    }
}

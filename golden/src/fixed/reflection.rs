//! `reflection`, bit for bit [Hast, Barrera and Bengtsson, eq. 27 to 34; methods C4 to C6 and
//! C12 to C14; `docs/arithmetic.md`].
use std::fmt;

use specula_spec::reflection::{
    Highlight, ReflectionFormats, ReflectionInputs, ReflectionLight, ReflectionSpan, ReflectionSpec,
};
use specula_spec::{CoreParameters, Format, Quadratic};

use super::error::PacketError;
use super::forward::Accumulator;
use super::highlight::{amount, cosine, quotient, reflection};
use super::method::{Intensities, Method};
use super::number::{Wide, round_quotient};
use super::observer::Observer;
use super::raised::Raised;
use super::span_extent::SpanExtent;

/// The largest 1/q.
const LARGEST_RECIPROCAL: Wide = Wide::lit("4");

/// The method in one core's formats.
pub(super) struct Reflection {
    highlight: Highlight,
    power: Raised,
    formats: ReflectionFormats,
}

/// What the lights have in common at one pixel.
pub(super) struct Pixel {
    i: u32,
    q: Wide,
    /// 1/q.
    w: Wide,
    /// N'·V, and N·N; 0 where nobody asks.
    v: Wide,
    normal_squared: Wide,
    exponent: Wide,
}

impl Reflection {
    pub fn new(core: &CoreParameters, spec: &ReflectionSpec) -> Reflection {
        Reflection {
            highlight: spec.specular,
            power: Raised::new(core, spec.power_unit()),
            formats: spec.formats.clone(),
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

    fn common(&self, span: &ReflectionSpan<Wide>, i: u32, observer: &mut impl Observer) -> Pixel {
        let q = self.operand(observer, "denominator", Some(&span.denominator), i);
        let w = self.reciprocal(observer, q);
        let view = self.operand(observer, "view", span.view.as_ref(), i);
        let v = cosine(observer, "view_cosine", view * w, self.formats.cosine);
        let normal_squared =
            self.operand(observer, "normal_squared", span.normal_squared.as_ref(), i);
        Pixel { i, q, w, v, normal_squared, exponent: span.exponent }
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
    type Span = ReflectionSpan<Wide>;
    type Light = ReflectionLight<Wide>;
    type State = ();
    type Pixel = Pixel;

    fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.formats.diffuse, specular: self.power.format() }
    }

    fn check(
        &self,
        inputs: &ReflectionInputs<Wide>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        let check = |name: fmt::Arguments<'_>, quadratic: Option<&Quadratic<Wide>>, low: i32| {
            quadratic.map_or(Ok(()), |quadratic| {
                extent.quadratic(name, quadratic, self.formats.accumulator, (low, 1))
            })
        };
        check(format_args!("denominator"), Some(&inputs.span.denominator), 0)?;
        check(format_args!("view"), inputs.span.view.as_ref(), -1)?;
        check(format_args!("normal_squared"), inputs.span.normal_squared.as_ref(), 0)?;
        inputs.lights.iter().enumerate().try_for_each(|(index, inputs)| {
            let light = &inputs.light;
            check(format_args!("light{index}_p"), Some(&light.cosine), -1)?;
            check(format_args!("light{index}_halfway"), light.halfway.as_ref(), -1)?;
            check(format_args!("light{index}_numerator"), light.numerator.as_ref(), -1)
        })
    }

    fn pixel(
        &self,
        span: &ReflectionSpan<Wide>,
        (): (),
        i: u32,
        observer: &mut impl Observer,
    ) -> Pixel {
        self.common(span, i, observer)
    }

    fn light(
        &self,
        pixel: &Pixel,
        light: &ReflectionLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let p = self.operand(observer, "p", Some(&light.cosine), pixel.i);
        let c = cosine(observer, "cosine", p * pixel.w, self.formats.cosine);
        let diffuse = amount(observer, "diffuse", c, self.formats.diffuse);
        let base = self.base(pixel, light, c, observer);
        Intensities { diffuse, specular: self.power.raise(observer, base, pixel.exponent) }
    }
}

//! `duff`, bit for bit [Hast, Barrera and Bengtsson, eq. 3 to 8, 17, 33 and 34; methods C2, C8
//! to C11; `docs/arithmetic.md`].
use std::fmt;

use specula_spec::duff::{DuffFormats, DuffInputs, DuffLight, DuffSpan, DuffSpec, Highlight};
use specula_spec::{CoreParameters, Format, Linear};

use super::error::PacketError;
use super::forward::Accumulator;
use super::highlight::{amount, cosine, quotient, reflection, root};
use super::method::{Intensities, Method};
use super::number::{Wide, round_signed_quotient};
use super::observer::Observer;
use super::raised::Raised;
use super::span_extent::SpanExtent;

/// The method in one core's formats.
pub(super) struct Duff {
    highlight: Highlight,
    power: Raised,
    formats: DuffFormats,
}

/// What the lights have in common at one pixel.
pub(super) struct Pixel {
    i: u32,
    q: Wide,
    s: Wide,
    /// N·V, and that times s; 0 where nobody asks.
    view: Wide,
    view_cosine: Wide,
    exponent: Wide,
}

impl Duff {
    pub fn new(core: &CoreParameters, duff: &DuffSpec) -> Duff {
        Duff {
            highlight: duff.specular,
            power: Raised::new(core, duff.power_unit()),
            formats: duff.formats.clone(),
        }
    }
}

impl Method for Duff {
    type Span = DuffSpan<Wide>;
    type Light = DuffLight<Wide>;
    type State = ();
    type Pixel = Pixel;

    fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.formats.diffuse, specular: self.power.format() }
    }

    fn check(&self, inputs: &DuffInputs<Wide>, extent: SpanExtent) -> Result<(), PacketError> {
        let f = &self.formats;
        let linear = |name: fmt::Arguments<'_>, linear: &Linear<Wide>| {
            extent.linear(name, linear, f.linear_accumulator, (-1, 1))
        };
        extent.quadratic(
            format_args!("denominator"),
            &inputs.span.denominator,
            f.accumulator,
            (0, 1),
        )?;
        inputs.span.view.iter().try_for_each(|view| linear(format_args!("view"), view))?;
        inputs.lights.iter().enumerate().try_for_each(|(index, inputs)| {
            let light = &inputs.light;
            linear(format_args!("light{index}_p"), &light.cosine)?;
            light
                .halfway
                .iter()
                .try_for_each(|halfway| linear(format_args!("light{index}_halfway"), halfway))?;
            let name = format_args!("light{index}_numerator");
            light
                .numerator
                .iter()
                .try_for_each(|numerator| extent.quadratic(name, numerator, f.accumulator, (-1, 1)))
        })
    }

    fn pixel(&self, span: &DuffSpan<Wide>, (): (), i: u32, observer: &mut impl Observer) -> Pixel {
        self.common(span, i, observer)
    }

    fn light(
        &self,
        pixel: &Pixel,
        light: &DuffLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let p = self.linear().linear(observer, "p", &light.cosine, pixel.i);
        let c = cosine(observer, "cosine", p * pixel.s, self.formats.cosine);
        let diffuse = amount(observer, "diffuse", c, self.formats.diffuse);
        let base = self.base(pixel, light, p, c, observer);
        Intensities { diffuse, specular: self.power.raise(observer, base, pixel.exponent) }
    }
}

impl Duff {
    fn linear(&self) -> Accumulator {
        Accumulator { exact: self.formats.linear_accumulator, rounded: self.formats.operand }
    }

    fn quadratic(&self) -> Accumulator {
        Accumulator { exact: self.formats.accumulator, rounded: self.formats.operand }
    }

    fn common(&self, span: &DuffSpan<Wide>, i: u32, observer: &mut impl Observer) -> Pixel {
        let f = &self.formats;
        let q = self.quadratic().quadratic(observer, "denominator", &span.denominator, i);
        let s = root(observer, q, f.root);
        let (mut view, mut view_cosine) = (Wide::ZERO, Wide::ZERO);
        if let Some(linear) = &span.view {
            view = self.linear().linear(observer, "view", linear, i);
            view_cosine = cosine(observer, "view_cosine", view * s, f.cosine);
        }
        Pixel { i, q, s, view, view_cosine, exponent: span.exponent }
    }

    /// The base of the highlight, 0 to 1.
    fn base(
        &self,
        pixel: &Pixel,
        light: &DuffLight<Wide>,
        p: Wide,
        c: Wide,
        observer: &mut impl Observer,
    ) -> Wide {
        let f = &self.formats;
        let has_direction = pixel.q > Wide::ZERO;
        // An input that is not there is 0.
        let light_dot_view = light.dot_view.unwrap_or(Wide::ZERO);
        match self.highlight {
            Highlight::Blinn => {
                let r = light
                    .halfway
                    .as_ref()
                    .map_or(Wide::ZERO, |r| self.linear().linear(observer, "halfway", r, pixel.i));
                let h = cosine(observer, "halfway_cosine", r * pixel.s, f.cosine);
                amount(observer, "base", h, f.base)
            }
            Highlight::Quotient => {
                let numerator = light.numerator.as_ref();
                let p = numerator.map_or(Wide::ZERO, |p| {
                    self.quadratic().quadratic(observer, "numerator", p, pixel.i)
                });
                quotient(observer, p, pixel.q, f.base)
            }
            Highlight::Eq33 => {
                let (bits, limit) = (f.quotient.fraction_bits, 1 << f.root.integer_bits);
                let t = if has_direction {
                    round_signed_quotient(p, pixel.q, bits, limit)
                } else {
                    Wide::ZERO
                };
                observer.see(format_args!("quotient"), t, f.quotient);
                reflection(
                    observer,
                    has_direction,
                    ((pixel.view * t) << 1) - light_dot_view,
                    f.base,
                )
            }
            Highlight::Eq34 => reflection(
                observer,
                has_direction,
                ((pixel.view_cosine * c) << 1) - light_dot_view,
                f.base,
            ),
        }
    }
}

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
use super::spot::spotted;
use super::ways::{Arrival, Ways};

/// The method in one core's formats.
pub(super) struct Duff {
    highlight: Highlight,
    power: Raised,
    ways: Ways,
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
    /// 1/√(E·E) of an eye at a place.
    eye: Option<Wide>,
    exponent: Wide,
}

impl Duff {
    pub fn new(core: &CoreParameters, duff: &DuffSpec) -> Duff {
        Duff {
            highlight: duff.specular,
            power: Raised::new(core, duff.power_unit()),
            ways: Ways::new(core, duff.ways()),
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
        inputs.span.eye.iter().try_for_each(|eye| self.ways.check_eye(eye, extent))?;
        inputs.lights.iter().enumerate().try_for_each(|(index, inputs)| {
            let light = &inputs.light;
            light.way.iter().try_for_each(|way| self.ways.check_light(index, way, extent))?;
            light
                .cosine
                .iter()
                .try_for_each(|cosine| linear(format_args!("light{index}_p"), cosine))?;
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
        let arrived =
            light.way.as_ref().map(|way| self.ways.light(observer, way, pixel.eye, pixel.i));
        let (p, arrival) = match (&light.cosine, arrived) {
            (_, Some((p, arrival))) => (p, Some(arrival)),
            (Some(cosine), None) => (self.linear().linear(observer, "p", cosine, pixel.i), None),
            // An input that is not there is 0.
            (None, None) => (Wide::ZERO, None),
        };
        let c = cosine(observer, "cosine", p * pixel.s, self.formats.cosine);
        let diffuse = amount(observer, "diffuse", c, self.formats.diffuse);
        let base = match &arrival {
            Some(arrival) => self.base_to_place(pixel, arrival, p, c, observer),
            None => self.base(pixel, light, p, c, observer),
        };
        let specular = self.power.raise(observer, base, pixel.exponent);
        let intensities = Intensities { diffuse, specular };
        match arrival {
            Some(arrival) => spotted(arrival.share, intensities, &self.formats()),
            None => intensities,
        }
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
        let s = root(observer, "root", q, f.root);
        let eye = span.eye.as_ref().map(|eye| self.ways.eye(observer, eye, i));
        let view = match (&span.view, eye) {
            (_, Some((view, _))) => Some(view),
            (Some(linear), None) => Some(self.linear().linear(observer, "view", linear, i)),
            (None, None) => None,
        };
        let view_cosine =
            view.map_or(Wide::ZERO, |view| cosine(observer, "view_cosine", view * s, f.cosine));
        let (view, eye) = (view.unwrap_or(Wide::ZERO), eye.map(|(_, root)| root));
        Pixel { i, q, s, view, view_cosine, eye, exponent: span.exponent }
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
            Highlight::Eq33 => self.eq33(pixel, p, light_dot_view, observer),
            Highlight::Eq34 => self.eq34(pixel, c, light_dot_view, observer),
        }
    }

    /// The same of a light or for an eye at a place.
    fn base_to_place(
        &self,
        pixel: &Pixel,
        arrival: &Arrival,
        p: Wide,
        c: Wide,
        observer: &mut impl Observer,
    ) -> Wide {
        match self.highlight {
            Highlight::Blinn => {
                self.ways.halfway(observer, c + pixel.view_cosine, arrival, pixel.eye)
            }
            Highlight::Quotient => {
                let p = self.ways.reflected(observer, [pixel.view, p], arrival.dot_view, pixel.q);
                quotient(observer, p, pixel.q, self.formats.base)
            }
            Highlight::Eq33 => self.eq33(pixel, p, arrival.dot_view, observer),
            Highlight::Eq34 => self.eq34(pixel, c, arrival.dot_view, observer),
        }
    }

    fn eq33(
        &self,
        pixel: &Pixel,
        p: Wide,
        light_dot_view: Wide,
        observer: &mut impl Observer,
    ) -> Wide {
        let f = &self.formats;
        let has_direction = pixel.q > Wide::ZERO;
        let (bits, limit) = (f.quotient.fraction_bits, 1 << f.root.integer_bits);
        let t =
            if has_direction { round_signed_quotient(p, pixel.q, bits, limit) } else { Wide::ZERO };
        observer.see(format_args!("quotient"), t, f.quotient);
        reflection(observer, has_direction, ((pixel.view * t) << 1) - light_dot_view, f.base)
    }

    fn eq34(
        &self,
        pixel: &Pixel,
        c: Wide,
        light_dot_view: Wide,
        observer: &mut impl Observer,
    ) -> Wide {
        let cosine = ((pixel.view_cosine * c) << 1) - light_dot_view;
        reflection(observer, pixel.q > Wide::ZERO, cosine, self.formats.base)
    }
}

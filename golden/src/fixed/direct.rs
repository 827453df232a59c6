//! `direct`, bit for bit [lecture, eq. 4.3 to 4.6; methods A6, A7; `docs/arithmetic/direct.md`].
use std::fmt;

use specula_spec::direct::{
    DirectFormats, DirectInputs, DirectLight, DirectSpan, DirectSpec, Ends, Root,
};
use specula_spec::{CoreParameters, Format, Increments, Linear};

use super::error::PacketError;
use super::forward::Accumulator;
use super::method::{Intensities, Method};
use super::number::{Wide, round_quotient, round_to};
use super::observer::{Nobody, Observer, narrow};
use super::raised::Raised;
use super::root::reciprocal_square_root;
use super::span_extent::SpanExtent;
use super::spot::spotted;
use super::ways::Ways;

/// The method in one core's formats.
pub(super) struct Direct {
    root: Root,
    newton_steps: u32,
    power: Raised,
    increments: Increments,
    ways: Ways,
    formats: DirectFormats,
}

/// What the lights have in common at one pixel.
pub(super) struct Pixel {
    t: Wide,
    q: Wide,
    s: Wide,
    /// K, which goes with J; with Newton's root K/q, which goes with p_L.
    view: Wide,
    i: u32,
    /// 1/√(E·E) of an eye at a place.
    eye: Option<Wide>,
    exponent: Wide,
}

impl Direct {
    pub fn new(core: &CoreParameters, direct: &DirectSpec) -> Direct {
        Direct {
            root: direct.root,
            newton_steps: direct.newton_steps,
            power: Raised::new(core, direct.power_unit()),
            increments: direct.increments,
            ways: Ways::new(core, direct.ways()),
            formats: direct.formats.clone(),
        }
    }
}

impl Method for Direct {
    type Span = DirectSpan<Wide>;
    type Light = DirectLight<Wide>;
    /// d, the length of the normal by Newton's method.
    type State = Wide;
    type Pixel = Pixel;

    fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.formats.diffuse, specular: self.power.format() }
    }

    /// With t below 2, q, 1/√q and scalars are as small as their formats say, but for a bit or two.
    fn check(&self, inputs: &DirectInputs<Wide>, extent: SpanExtent) -> Result<(), PacketError> {
        let eye = inputs.span.eye.as_ref();
        eye.map_or(Ok(()), |eye| self.ways.check_eye(eye, extent))?;
        self.check_linear(format_args!("view"), inputs.span.view.as_ref(), extent)?;
        inputs.lights.iter().enumerate().try_for_each(|(index, inputs)| {
            let way = inputs.light.way.as_ref();
            way.map_or(Ok(()), |way| self.ways.check_light(index, way, extent))?;
            let light = inputs.light.light.as_ref();
            self.check_linear(format_args!("light{index}"), light, extent)
        })?;
        extent.weight(inputs.span.weight_step, self.formats.weight_accumulator)
    }

    /// d by Newton's steps from that of the pixel before, and from 1 at first; an exact root needs
    /// none.
    fn state(
        &self,
        span: &DirectSpan<Wide>,
        before: Option<Wide>,
        i: u32,
        _observer: &mut impl Observer,
    ) -> Wide {
        let first = before.unwrap_or(Wide::ONE);
        match self.root {
            Root::Exact => first,
            Root::Newton => {
                let (_, q) = self.squared_length(span, i, &mut Nobody);
                (0..self.newton_steps).fold(first, |d, _| self.newton_step(d, q))
            }
        }
    }

    fn pixel(
        &self,
        span: &DirectSpan<Wide>,
        length: Wide,
        i: u32,
        observer: &mut impl Observer,
    ) -> Pixel {
        self.common(span, length, i, observer)
    }

    fn light(
        &self,
        pixel: &Pixel,
        light: &DirectLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let way = light.way.as_ref();
        let arrived = way.map(|way| self.ways.light(observer, way, pixel.eye, pixel.i));
        let linear = match (&light.light, &arrived) {
            (_, Some((cosine, _))) => *cosine,
            (Some(light), None) => self.linear("n_dot_l", light, (pixel.t, pixel.i), observer),
            // An input that is not there is 0.
            (None, None) => Wide::ZERO,
        };
        let given = light.light_dot_view.unwrap_or(Wide::ZERO);
        let dot_view = arrived.as_ref().map_or(given, |(_, arrival)| arrival.dot_view);
        let n_dot_l = self.cosine("n_dot_l", linear, pixel.s, observer);
        let diffuse = round_to(n_dot_l, self.formats.diffuse.fraction_bits).max(Wide::ZERO);
        observer.see(format_args!("diffuse"), diffuse, self.formats.diffuse);
        let along_light = match self.root {
            Root::Exact => n_dot_l,
            Root::Newton => linear,
        };
        let specular = self.highlight(pixel, along_light, dot_view, observer);
        let intensities = Intensities { diffuse, specular };
        match arrived {
            Some((_, arrival)) => spotted(arrival.share, intensities, &self.formats()),
            None => intensities,
        }
    }
}

impl Direct {
    fn common(
        &self,
        span: &DirectSpan<Wide>,
        length: Wide,
        i: u32,
        observer: &mut impl Observer,
    ) -> Pixel {
        let f = &self.formats;
        let (t, q) = self.squared_length(span, i, observer);
        let s = match self.root {
            Root::Exact => {
                reciprocal_square_root(q, f.reciprocal.integer_bits, f.reciprocal.fraction_bits)
            }
            Root::Newton => self.reciprocal_length(length, observer),
        };
        observer.see(format_args!("reciprocal"), s, f.reciprocal);
        let eye = span.eye.as_ref().map(|eye| self.ways.eye(observer, eye, i));
        let linear = match (&span.view, eye) {
            (_, Some((view, _))) => view,
            (Some(view), None) => self.linear("n_dot_v", view, (t, i), observer),
            (None, None) => Wide::ZERO,
        };
        let view = match self.root {
            Root::Exact => self.cosine("n_dot_v", linear, s, observer),
            Root::Newton => self.over_square(linear, q, observer),
        };
        Pixel { t, q, s, view, i, eye: eye.map(|(_, root)| root), exponent: span.exponent }
    }

    /// t and q = 1 - κ t (1 - t).
    fn squared_length(
        &self,
        span: &DirectSpan<Wide>,
        i: u32,
        observer: &mut impl Observer,
    ) -> (Wide, Wide) {
        let f = &self.formats;
        let accumulated = span.weight_step * Wide::from_num(i);
        observer.see(format_args!("weight_accumulator"), accumulated, f.weight_accumulator);
        let t = narrow(observer, format_args!("weight"), accumulated, f.weight);
        let product = narrow(observer, format_args!("product"), t * (Wide::ONE - t), f.product);
        (
            t,
            narrow(
                observer,
                format_args!("length_squared"),
                Wide::ONE - span.spread * product,
                f.length_squared,
            ),
        )
    }

    /// 1/d.
    fn reciprocal_length(&self, d: Wide, observer: &mut impl Observer) -> Wide {
        observer.see(format_args!("length"), d, self.formats.length);
        let reciprocal = self.formats.reciprocal;
        limited_quotient(Wide::ONE, d, reciprocal.integer_bits, reciprocal.fraction_bits)
    }

    /// (d + q/d)/2.
    fn newton_step(&self, d: Wide, q: Wide) -> Wide {
        let fraction_bits = self.formats.length.fraction_bits;
        let quotient = limited_quotient(
            self.limited(q),
            d,
            self.formats.reciprocal.integer_bits,
            fraction_bits,
        );
        round_to((d + quotient) / 2, fraction_bits)
    }

    /// p_V/q, kept within 2^m.
    fn over_square(&self, linear: Wide, q: Wide, observer: &mut impl Observer) -> Wide {
        let Format { integer_bits, fraction_bits, .. } = self.formats.reciprocal;
        let reciprocal =
            limited_quotient(Wide::ONE, self.limited(q), 2 * integer_bits, fraction_bits);
        observer.see(
            format_args!("reciprocal_square"),
            reciprocal,
            Format::unsigned(2 * integer_bits, fraction_bits),
        );
        let (format, limit) = (self.formats.cosine, Wide::ONE << integer_bits);
        let quotient = round_to(linear * reciprocal, format.fraction_bits).clamp(-limit, limit);
        observer.see(format_args!("n_dot_v_over_square"), quotient, format);
        quotient
    }

    /// q, 4^-m at least.
    fn limited(&self, q: Wide) -> Wide {
        q.max(Wide::ONE >> (2 * self.formats.reciprocal.integer_bits))
    }

    /// Whether N·X stays within -1 and 1; between ends that do it does.
    fn check_linear(
        &self,
        name: fmt::Arguments<'_>,
        ends: Option<&Ends<Wide>>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        match (self.increments, ends) {
            (Increments::Added, Some(ends)) => {
                extent.linear(name, &added(ends), self.formats.scalar_accumulator, (-1, 1))
            }
            _ => Ok(()),
        }
    }

    /// N·X, linear along the span, at t and pixel i.
    fn linear(
        &self,
        name: &str,
        ends: &Ends<Wide>,
        (t, i): (Wide, u32),
        observer: &mut impl Observer,
    ) -> Wide {
        let rounded = self.formats.cosine;
        match self.increments {
            Increments::Multiplied => {
                let exact = ends.start + t * ends.change;
                narrow(observer, format_args!("{name}_linear"), exact, rounded)
            }
            Increments::Added => Accumulator { exact: self.formats.scalar_accumulator, rounded }
                .linear(observer, format_args!("{name}_linear"), &added(ends), i),
        }
    }

    /// N·X s, kept within -1 to 1.
    fn cosine(&self, name: &str, linear: Wide, s: Wide, observer: &mut impl Observer) -> Wide {
        let format = self.formats.cosine;
        let cosine = round_to(linear * s, format.fraction_bits).clamp(-Wide::ONE, Wide::ONE);
        observer.see(format_args!("{name}"), cosine, format);
        cosine
    }

    /// max(2 J K - L·V, 0)^n, or with p_L K/q for J K; none for a normal without direction.
    fn highlight(
        &self,
        pixel: &Pixel,
        along_light: Wide,
        light_dot_view: Wide,
        observer: &mut impl Observer,
    ) -> Wide {
        let format = self.formats.base;
        let rounded = round_to(along_light * pixel.view * 2 - light_dot_view, format.fraction_bits);
        let base =
            if pixel.q > Wide::ZERO { rounded.clamp(Wide::ZERO, Wide::ONE) } else { Wide::ZERO };
        observer.see(format_args!("base"), base, format);
        self.power.raise(observer, base, pixel.exponent)
    }
}

/// What grows by its change with each pixel.
fn added(ends: &Ends<Wide>) -> Linear<Wide> {
    Linear { start: ends.start, step: ends.change }
}

/// p/q of positive numbers to `fraction_bits`, 2^`integer_bits` at most.
fn limited_quotient(p: Wide, q: Wide, integer_bits: u32, fraction_bits: u32) -> Wide {
    let limit = Wide::ONE << integer_bits;
    if p >= q * limit { limit } else { round_quotient(p, q, fraction_bits) }
}

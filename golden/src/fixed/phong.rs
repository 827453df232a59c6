//! `phong`, bit for bit [lecture, eq. 2.1, 4.1, 4.2; Lyon, TR 43, appendix; Hast et al., eq. 35 to
//! 38; `docs/arithmetic/phong.md`].
use std::fmt;

use specula_spec::phong::{
    Highlight, PhongFormats, PhongInputs, PhongLight, PhongSpan, PhongSpec, Way,
};
use specula_spec::{CoreParameters, Format};

use super::error::PacketError;
use super::forward::Accumulator;
use super::gaussian::Gaussian;
use super::method::{Intensities, Method};
use super::number::{Wide, round_quotient, round_to};
use super::observer::{Observer, narrow, narrow_vector};
use super::packet;
use super::power::Power;
use super::root::reciprocal_square_root;
use super::span_extent::SpanExtent;
use super::span_vectors::{SpanPixel, SpanVectors};
use super::vector::{Vector, dot};
use super::wrapped::{WrapFormats, Wrapped, wrapped};

/// V = (0, 0, 1).
const EYE: Vector = [Wide::ZERO, Wide::ZERO, Wide::ONE];

/// The method in one core's formats.
pub(super) struct Phong {
    highlight: Highlight,
    formats: PhongFormats,
    vectors: SpanVectors,
    power: Power,
    gaussian: Gaussian,
    /// Of all spots.
    spot_power: Power,
}

/// A vector brought to unit length.
#[derive(Clone, Copy)]
struct Unit {
    vector: Vector,
    wrap: Option<Wrapping>,
}

/// What a wrapped vector is made of.
#[derive(Clone, Copy)]
struct Wrapping {
    /// p = H·w.
    operand: Wide,
    /// v.
    ratio: Wide,
}

impl Unit {
    /// A vector that is not wrapped.
    fn straight(vector: Vector) -> Unit {
        Unit { vector, wrap: None }
    }
}

/// What the lights have in common at one pixel.
pub(super) struct Pixel {
    on_span: SpanPixel,
    normal: Option<Vector>,
    view: Option<Vector>,
    n_dot_v: Wide,
    shininess: Wide,
}

/// A light at a pixel.
struct Arrival<'a> {
    light: &'a PhongLight<Wide>,
    /// L.
    direction: Unit,
    view: Option<Vector>,
    n_dot_l: Wide,
    n_dot_v: Wide,
    shininess: Wide,
}

impl Phong {
    fn check_way(
        &self,
        name: fmt::Arguments<'_>,
        way: Option<&Way<Wide>>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        let Some(way) = way else { return Ok(()) };
        self.check_unit(format_args!("{name}_wrap_axis"), way.axis.as_ref())?;
        let longest = if way.axis.is_some() { 2 } else { 1 };
        self.vectors.check(name, [&way.start, &way.delta], longest, extent)
    }

    fn check_unit(
        &self,
        name: fmt::Arguments<'_>,
        vector: Option<&Vector>,
    ) -> Result<(), PacketError> {
        vector.map_or(Ok(()), |vector| {
            packet::check_length(name, vector, Wide::ONE, self.formats.vector)
        })
    }

    pub fn new(core: &CoreParameters, phong: &PhongSpec) -> Phong {
        let formats = phong.formats.clone();
        let bits = |n: u32| u32::BITS - n.leading_zeros();
        let power = |largest: u32| Power::new(bits(largest), formats.shape.fraction_bits);
        Phong {
            highlight: phong.highlight,
            gaussian: Gaussian::new(formats.shape.fraction_bits),
            power: power(core.largest_shininess * phong.highlight.exponent_factor()),
            spot_power: power(core.largest_spot_exponent()),
            vectors: SpanVectors {
                increments: phong.increments,
                weight_accumulator: formats.weight_accumulator,
                weight: formats.weight,
                components: Accumulator {
                    exact: formats.vector_accumulator,
                    rounded: formats.vector,
                },
            },
            formats,
        }
    }
}

impl Method for Phong {
    type Span = PhongSpan<Wide>;
    type Light = PhongLight<Wide>;
    type State = ();
    type Pixel = Pixel;

    fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.formats.cosine, specular: self.formats.shape }
    }

    /// Interpolated vectors stay within the unit ball, but for rounding; sums of two of them within
    /// twice as much.
    fn check(&self, inputs: &PhongInputs<Wide>, extent: SpanExtent) -> Result<(), PacketError> {
        self.check_way(format_args!("normal"), Some(&inputs.span.normal), extent)?;
        self.check_way(format_args!("eye"), inputs.span.eye.as_ref(), extent)?;
        for (i, light) in inputs.lights.iter().map(|inputs| &inputs.light).enumerate() {
            self.check_way(format_args!("light{i}_way"), light.way.as_ref(), extent)?;
            self.check_unit(format_args!("light{i}_direction"), light.direction.as_ref())?;
            self.check_unit(format_args!("light{i}_axis"), light.axis.as_ref())?;
        }
        self.vectors.check_weight(inputs.span.weight_step, extent)
    }

    fn pixel(&self, span: &PhongSpan<Wide>, (): (), i: u32, observer: &mut impl Observer) -> Pixel {
        let on_span = self.vectors.pixel(observer, i, span.weight_step);
        let normal = self.along("normal", &span.normal, on_span, observer).map(|unit| unit.vector);
        let view = match &span.eye {
            Some(eye) => self.along("eye", eye, on_span, observer).map(|unit| unit.vector),
            None => Some(EYE),
        };
        let n_dot_v = self.cosine("n_dot_v", normal, view, observer);
        Pixel { on_span, normal, view, n_dot_v, shininess: span.shininess }
    }

    fn light(
        &self,
        pixel: &Pixel,
        light: &PhongLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let &Pixel { on_span, normal, view, n_dot_v, shininess } = pixel;
        let direction = self.direction(light, on_span, observer);
        let n_dot_l = self.cosine("n_dot_l", normal, direction.map(|unit| unit.vector), observer);
        let arrival = |direction| Arrival { light, direction, view, n_dot_l, n_dot_v, shininess };
        match (normal, direction.map(arrival)) {
            (Some(_), Some(arrival)) => self.lit(&arrival, observer),
            _ => Intensities { diffuse: Wide::ZERO, specular: Wide::ZERO },
        }
    }
}

impl Phong {
    /// L. A wrap around a spot's axis S serves within 90 degrees of it, where H·S is above 1;
    /// farther from it the spot is dark.
    fn direction(
        &self,
        light: &PhongLight<Wide>,
        on_span: SpanPixel,
        observer: &mut impl Observer,
    ) -> Option<Unit> {
        let direction = match (&light.way, light.direction) {
            (Some(way), _) => self.along("way", way, on_span, observer),
            (None, direction) => direction.map(Unit::straight),
        };
        direction.filter(|unit| {
            light.exponent.is_none() || unit.wrap.is_none_or(|wrap| wrap.operand > Wide::ONE)
        })
    }

    /// A vector along the span, brought to unit length; none if it has no direction.
    fn along(
        &self,
        name: &str,
        way: &Way<Wide>,
        on_span: SpanPixel,
        observer: &mut impl Observer,
    ) -> Option<Unit> {
        let f = &self.formats;
        let vector = self.vectors.at(
            observer,
            format_args!("{name}_interpolated"),
            [&way.start, &way.delta],
            on_span,
        );
        if let Some(axis) = &way.axis {
            let formats =
                WrapFormats { operand: f.wrap_operand, ratio: f.wrap_ratio, vector: f.vector };
            let Wrapped { vector, operand, ratio } =
                wrapped(observer, [&format!("{name}_wrap"), name], &vector, axis, formats);
            return (vector != [Wide::ZERO; 3])
                .then_some(Unit { vector, wrap: Some(Wrapping { operand, ratio }) });
        }
        let z = narrow(
            observer,
            format_args!("{name}_length_squared"),
            dot(&vector, &vector),
            f.length_squared,
        );
        let gain = self.gain(z);
        observer.see(format_args!("{name}_gain"), gain, f.gain);
        let unit = narrow_vector(observer, name, vector.map(|c| gain * c), f.vector);
        (z > Wide::ZERO).then_some(Unit::straight(unit))
    }

    /// 1/√z, 16 for z ≤ 1/256.
    fn gain(&self, z: Wide) -> Wide {
        reciprocal_square_root(z, self.formats.gain.integer_bits, self.formats.gain.fraction_bits)
    }

    fn cosine(
        &self,
        name: &str,
        a: Option<Vector>,
        b: Option<Vector>,
        observer: &mut impl Observer,
    ) -> Wide {
        match (a, b) {
            (Some(a), Some(b)) => {
                narrow(observer, format_args!("{name}"), dot(&a, &b), self.formats.cosine)
            }
            _ => Wide::ZERO,
        }
    }

    /// d and f of a light that arrives from somewhere at a normal that points somewhere.
    fn lit(&self, at: &Arrival, observer: &mut impl Observer) -> Intensities<Wide> {
        let diffuse = at.n_dot_l.max(Wide::ZERO);
        let specular = at.view.map_or(Wide::ZERO, |view| self.specular(at, &view, observer));
        match at.light.exponent {
            Some(exponent) => {
                let shape = self.formats.shape;
                let cosine = self.base(to_axis(at), "spot_base", observer);
                let share = self.spot_power.raise(cosine, exponent.to_num());
                observer.see(format_args!("spot"), share, shape);
                let spotted = |amount| round_to(share * amount, shape.fraction_bits);
                Intensities { diffuse: spotted(diffuse), specular: spotted(specular) }
            }
            None => Intensities { diffuse, specular },
        }
    }

    fn specular(&self, at: &Arrival, view: &Vector, observer: &mut impl Observer) -> Wide {
        let f = &self.formats;
        let exponent = at.shininess.to_num();
        if self.highlight == Highlight::Reflection {
            let l_dot_v =
                at.light.light_dot_view.unwrap_or_else(|| self.l_dot_v(at, view, observer));
            return self.power.raise(
                self.base(((at.n_dot_v * at.n_dot_l) << 1) - l_dot_v, "base", observer),
                exponent,
            );
        }
        let gain = at.light.halfway_gain.unwrap_or_else(|| {
            let squared = Wide::from_num(2) + (self.l_dot_v(at, view, observer) << 1);
            self.gain(narrow(observer, format_args!("halfway_squared"), squared, f.length_squared))
        });
        let cosine = (at.n_dot_l + at.n_dot_v) * gain;
        match self.highlight {
            Highlight::Reflection | Highlight::Blinn => {
                self.power.raise(self.base(cosine, "base", observer), exponent)
            }
            Highlight::TorranceSparrow => {
                self.gaussian.value(self.versine(cosine, observer), exponent)
            }
            Highlight::TrowbridgeReitz => {
                self.trowbridge_reitz(self.base(cosine, "base", observer), at.shininess, observer)
            }
        }
    }

    fn l_dot_v(&self, at: &Arrival, view: &Vector, observer: &mut impl Observer) -> Wide {
        narrow(
            observer,
            format_args!("l_dot_v"),
            dot(view, &at.direction.vector),
            self.formats.cosine,
        )
    }

    fn base(&self, value: Wide, name: &str, observer: &mut impl Observer) -> Wide {
        let base = round_to(value, self.formats.base.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("{name}"), base, self.formats.base);
        base
    }

    /// 1 - H*·N.
    fn versine(&self, cosine: Wide, observer: &mut impl Observer) -> Wide {
        let versine = round_to(Wide::ONE - cosine, self.formats.base.fraction_bits)
            .clamp(Wide::ZERO, Gaussian::largest_versine());
        observer.see(format_args!("base"), versine, self.formats.base);
        versine
    }

    /// (1/(1 + (1 - b²) n))².
    fn trowbridge_reitz(&self, base: Wide, shininess: Wide, observer: &mut impl Observer) -> Wide {
        let f = &self.formats;
        let x = narrow(observer, format_args!("x"), (Wide::ONE - base * base) * shininess, f.base);
        let u = round_quotient(Wide::ONE, Wide::ONE + x, f.shape.fraction_bits);
        observer.see(format_args!("u"), u, f.shape);
        narrow(observer, format_args!("specular"), u * u, f.shape)
    }
}

/// S·L, exact, with S back along the spot's axis: 2 v p - 1 of what is wrapped around it.
fn to_axis(at: &Arrival) -> Wide {
    match (&at.direction.wrap, &at.light.axis) {
        (Some(Wrapping { operand, ratio }), _) => ((operand * ratio) << 1) - Wide::ONE,
        (None, axis) => -dot(&at.direction.vector, &axis.unwrap_or_default()),
    }
}

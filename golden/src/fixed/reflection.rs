//! `reflection`, bit for bit [Hast, Barrera and Bengtsson, eq. 27 to 34; methods C4 to C6 and
//! C12 to C14; `docs/arithmetic.md`].
use std::fmt;

use specula_spec::reflection::{
    Highlight, ReflectedLight, ReflectionFormats, ReflectionInputs, ReflectionLight,
    ReflectionSpan, ReflectionSpec,
};
use specula_spec::{CoreParameters, Format, Linear, Quadratic};

use super::error::PacketError;
use super::forward::Accumulator;
use super::highlight::{amount, cosine, quotient, reflection};
use super::method::{Intensities, Method};
use super::number::{Wide, round_quotient};
use super::observer::Observer;
use super::raised::Raised;
use super::span_extent::SpanExtent;
use super::spot::spotted;
use super::ways::Ways;

/// The largest 1/q.
const LARGEST_RECIPROCAL: Wide = Wide::lit("4");

/// The method in one core's formats.
pub(super) struct Reflection {
    highlight: Highlight,
    power: Raised,
    ways: Ways,
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
    /// H·n and N·V, with ways to places; 0 where nobody asks.
    h_dot_n: Wide,
    normal_view: Wide,
    /// 1/√(E·E) of an eye at a place.
    eye: Option<Wide>,
    exponent: Wide,
}

impl Reflection {
    pub fn new(core: &CoreParameters, spec: &ReflectionSpec) -> Reflection {
        Reflection {
            highlight: spec.specular,
            power: Raised::new(core, spec.power_unit()),
            ways: Ways::new(core, spec.ways()),
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
        let linear = |observer: &mut _, name: &str, linear: Option<&Linear<Wide>>| {
            linear.map_or(Wide::ZERO, |linear| self.ways.linear(observer, name, linear, i))
        };
        let h_dot_n = linear(observer, "h_dot_n", span.h_dot_n.as_ref());
        let mut normal_view = linear(observer, "normal_view", span.normal_view.as_ref());
        let view = self.operand(observer, "view", span.view.as_ref(), i);
        let mut v = cosine(observer, "view_cosine", view * w, self.formats.cosine);
        let mut eye = None;
        if let Some(to) = &span.eye {
            let root = self.ways.root(observer, "eye", &to.squared, i);
            let scalars = (&to.bisecting, &to.fixed);
            v = self.of_way(observer, "view", scalars, [h_dot_n, q, w, root], i);
            if let Some(normal) = &to.normal {
                let normal = self.ways.quadratic(observer, "eye_normal", normal, i);
                normal_view = self.ways.cosine(observer, "normal_view", normal, root);
            }
            eye = Some(root);
        }
        let normal_squared =
            self.operand(observer, "normal_squared", span.normal_squared.as_ref(), i);
        let exponent = span.exponent;
        Pixel { i, q, w, v, normal_squared, h_dot_n, normal_view, eye, exponent }
    }

    /// N'·X over the length of a way X, of H·X and n·X and of H·n, q, 1/q and 1/√(X·X) as `of` has
    /// them.
    fn of_way(
        &self,
        observer: &mut impl Observer,
        name: &str,
        (bisecting, fixed): (&Quadratic<Wide>, &Linear<Wide>),
        [h_dot_n, q, w, root]: [Wide; 4],
        i: u32,
    ) -> Wide {
        let h = self.ways.quadratic(observer, format_args!("{name}_bisecting"), bisecting, i);
        let n = self.ways.linear(observer, format_args!("{name}_fixed"), fixed, i);
        let p = self.ways.reflected(observer, [h, h_dot_n], n, q);
        let along = self.ways.cosine(observer, format_args!("{name}_along"), p, w);
        cosine(observer, format_args!("{name}_cosine"), along * root, self.formats.cosine)
    }

    /// The intensities of a light whose way is followed.
    fn arriving(
        &self,
        pixel: &Pixel,
        way: &ReflectedLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let f = &self.formats;
        let arrival = self.ways.arrival(observer, &way.way, pixel.eye, pixel.i);
        let (scalars, root) = ((&way.bisecting, &way.fixed), arrival.root);
        let of = [pixel.h_dot_n, pixel.q, pixel.w, root];
        let c = self.of_way(observer, "way", scalars, of, pixel.i);
        let diffuse = amount(observer, "diffuse", c, f.diffuse);
        let base = match (self.highlight, &way.normal) {
            (Highlight::Blinn, _) => self.ways.halfway(observer, c + pixel.v, &arrival, pixel.eye),
            (Highlight::Hybrid, Some(normal)) => {
                let normal = self.ways.quadratic(observer, "way_normal", normal, pixel.i);
                let l = self.ways.cosine(observer, "normal_light", normal, root);
                let (of, q) = ([pixel.normal_view, l], pixel.normal_squared);
                let p = self.ways.reflected(observer, of, arrival.dot_view, q);
                quotient(observer, p, q, f.base)
            }
            _ => {
                let base = ((pixel.v * c) << 1) - arrival.dot_view;
                reflection(observer, pixel.q > Wide::ZERO, base, f.base)
            }
        };
        let specular = self.power.raise(observer, base, pixel.exponent);
        spotted(arrival.share, Intensities { diffuse, specular }, &self.formats())
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
        let linear = |name: fmt::Arguments<'_>, linear: Option<&Linear<Wide>>| {
            linear.map_or(Ok(()), |linear| self.ways.check_linear(name, linear, extent))
        };
        linear(format_args!("h_dot_n"), inputs.span.h_dot_n.as_ref())?;
        linear(format_args!("normal_view"), inputs.span.normal_view.as_ref())?;
        if let Some(eye) = &inputs.span.eye {
            check(format_args!("eye_bisecting"), Some(&eye.bisecting), -1)?;
            linear(format_args!("eye_fixed"), Some(&eye.fixed))?;
            check(format_args!("eye_normal"), eye.normal.as_ref(), -1)?;
            check(format_args!("eye_squared"), Some(&eye.squared), 0)?;
        }
        inputs.lights.iter().enumerate().try_for_each(|(index, inputs)| {
            let light = &inputs.light;
            check(format_args!("light{index}_p"), light.cosine.as_ref(), -1)?;
            if let Some(way) = &light.way {
                check(format_args!("light{index}_way_bisecting"), Some(&way.bisecting), -1)?;
                linear(format_args!("light{index}_way_fixed"), Some(&way.fixed))?;
                check(format_args!("light{index}_way_normal"), way.normal.as_ref(), -1)?;
                self.ways.check_way(index, &way.way, extent)?;
            }
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
        if let Some(way) = &light.way {
            return self.arriving(pixel, way, observer);
        }
        let p = self.operand(observer, "p", light.cosine.as_ref(), pixel.i);
        let c = cosine(observer, "cosine", p * pixel.w, self.formats.cosine);
        let diffuse = amount(observer, "diffuse", c, self.formats.diffuse);
        let base = self.base(pixel, light, c, observer);
        Intensities { diffuse, specular: self.power.raise(observer, base, pixel.exponent) }
    }
}

//! `consistent`, bit for bit [Reshetov, Soupikov and Mark; methods D;
//! `docs/arithmetic/consistent.md`].
use specula_spec::consistent::{
    ConsistentFormats, ConsistentInputs, ConsistentLight, ConsistentSpan, ConsistentSpec, Curve,
    Diffuse, Directions, Highlight, LARGEST_ANGLE,
};
use specula_spec::ways::{VectorLight, VectorWay};
use specula_spec::{CoreParameters, Format, Linear};

use super::error::PacketError;
use super::method::{Intensities, Method};
use super::number::{Wide, round_down, round_quotient, round_root, round_to, round_up};
use super::observer::{Observer, narrow, narrow_vector};
use super::packet;
use super::raised::Raised;
use super::root::reciprocal_square_root;
use super::span_extent::SpanExtent;
use super::spot::spotted;
use super::vector::{Vector, dot};
use super::vector_ways::VectorWays;

/// V = (0, 0, 1).
const EYE: Vector = [Wide::ZERO, Wide::ZERO, Wide::ONE];
const FOUR: Wide = Wide::lit("4");
/// κ = 1169/1024, the least multiple of 2^-10 above π - 2.
const KAPPA: Wide = Wide::lit("1.1416015625");
/// s₀ to s₃, in units of 2^-20.
const TANGENT: [u32; 4] = [225_028, 55_803, 13_064, 5_363];
const TANGENT_FRACTION_BITS: u32 = 20;

/// The method in one core's formats.
pub(super) struct Consistent {
    curve: Curve,
    diffuse: Diffuse,
    highlight: Highlight,
    power: Raised,
    ways: VectorWays,
    directions: Directions,
    formats: ConsistentFormats,
}

impl Consistent {
    pub fn new(core: &CoreParameters, consistent: &ConsistentSpec) -> Consistent {
        Consistent {
            curve: consistent.curve,
            diffuse: consistent.diffuse,
            highlight: consistent.highlight,
            power: Raised::new(core, consistent.power_unit()),
            ways: VectorWays::new(
                core,
                consistent.formats.way_accumulator,
                consistent.formats.vector,
                [consistent.formats.base, consistent.formats.shape],
            ),
            directions: consistent.directions,
            formats: consistent.formats.clone(),
        }
    }
}

/// A normal and how strongly directions are reflected about it.
struct Mirror {
    normal: Vector,
    q: Wide,
    has_direction: bool,
}

/// A reflection, with b = n·I and g = n·r.
struct Reflection {
    b: Wide,
    g: Wide,
    r: Vector,
}

/// N_c·I where I is above the horizon.
struct ConsistentCosine {
    cosine: Wide,
    /// Whether it is, and the normal has a direction.
    is_lit: bool,
}

/// What the lights have in common at one pixel.
pub(super) struct Pixel {
    mirror: Mirror,
    /// Of the eye.
    reflection: Reflection,
    i: u32,
    /// V, and whether there is one: an eye at the very pixel has none.
    view: (Vector, bool),
    exponent: Wide,
}

impl Method for Consistent {
    type Span = ConsistentSpan<Wide>;
    type Light = ConsistentLight<Wide>;
    type State = ();
    type Pixel = Pixel;

    fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.formats.diffuse, specular: self.power.format() }
    }

    fn check(
        &self,
        inputs: &ConsistentInputs<Wide>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        let f = &self.formats;
        packet::check_ends(
            format_args!("normal"),
            (&inputs.span.normal_start, &inputs.span.normal_delta),
            Wide::ONE,
            f.vector,
        )?;
        for (i, light) in inputs.lights.iter().map(|inputs| &inputs.light).enumerate() {
            let direction = light.direction.unwrap_or_default();
            packet::check_length(
                format_args!("light{i}_direction"),
                &direction,
                Wide::ONE,
                f.vector,
            )?;
            let way = light.way.as_ref();
            way.map_or(Ok(()), |way| self.ways.check_light(i, way, extent))?;
            let halfway = light.halfway.unwrap_or_default();
            packet::check_length(format_args!("light{i}_halfway"), &halfway, Wide::ONE, f.vector)?;
        }
        let eye = inputs.span.eye.as_ref();
        eye.map_or(Ok(()), |eye| self.ways.check_way(format_args!("eye"), eye, extent))?;
        extent.weight(inputs.span.weight_step, f.weight_accumulator)?;
        let angle = Linear { start: inputs.span.angle_start, step: inputs.span.angle_step };
        extent.rounded_up(
            format_args!("angle"),
            &angle,
            f.angle_accumulator,
            Wide::from_num(LARGEST_ANGLE),
        )
    }

    fn pixel(
        &self,
        span: &ConsistentSpan<Wide>,
        (): (),
        i: u32,
        observer: &mut impl Observer,
    ) -> Pixel {
        let (normal, has_direction) = self.normal(span, i, observer);
        let mirror = Mirror { normal, q: self.contraction(span, i, observer), has_direction };
        let view = match &span.eye {
            Some(eye) => self.direction(["eye_", "eye", "view"], eye, i, observer),
            None => (EYE, true),
        };
        let reflection = self.reflection("", &mirror, &view.0, observer);
        if self.directions.has_normal() {
            self.consistent_normal(&reflection.r, &view.0, observer);
        }
        Pixel { mirror, reflection, i, view, exponent: span.exponent }
    }

    fn light(
        &self,
        pixel: &Pixel,
        light: &ConsistentLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        if let Some(way) = &light.way {
            return self.arriving(pixel, way, observer);
        }
        // An input that is not there is 0.
        let direction = light.direction.unwrap_or_default();
        let diffuse = self.diffuse(&pixel.mirror, &direction, observer);
        let specular = self.specular(pixel, &direction, light.halfway.as_ref(), observer);
        Intensities { diffuse, specular }
    }
}

impl Consistent {
    /// The intensities of a light whose way is followed.
    fn arriving(
        &self,
        pixel: &Pixel,
        light: &VectorLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let (l, exists) =
            self.direction(["way_", "way", "direction"], &light.way, pixel.i, observer);
        let (view, is_seen) = &pixel.view;
        let diffuse = self.diffuse(&pixel.mirror, &l, observer);
        let halfway =
            (self.highlight == Highlight::Blinn).then(|| self.halfway(&l, view, observer));
        let specular = self.specular(pixel, &l, halfway.as_ref(), observer);
        let intensities = Intensities {
            diffuse: if exists { diffuse } else { Wide::ZERO },
            specular: if exists && *is_seen { specular } else { Wide::ZERO },
        };
        let share = self.ways.share(observer, light.spot.as_ref(), &l);
        spotted(share, intensities, &self.formats())
    }

    /// The direction of a way at pixel i, a unit vector, and whether it has one.
    fn direction(
        &self,
        [prefix, of, name]: [&str; 3],
        way: &VectorWay<Wide>,
        i: u32,
        observer: &mut impl Observer,
    ) -> (Vector, bool) {
        let vector = self.ways.at(observer, of, way, i);
        self.normalised([prefix, name], &vector, observer)
    }

    /// (L + V)/|L + V|.
    fn halfway(&self, l: &Vector, v: &Vector, observer: &mut impl Observer) -> Vector {
        let half = std::array::from_fn(|c| (l[c] + v[c]) >> 1);
        self.normalised(["halfway_", "halfway"], &half, observer).0
    }

    /// N_c = (V + r)/|V + r|, which leaves the core and shades nothing in it.
    fn consistent_normal(&self, r: &Vector, v: &Vector, observer: &mut impl Observer) -> Vector {
        let half = std::array::from_fn(|c| (r[c] + v[c]) >> 1);
        self.normalised(["consistent_normal_", "consistent_normal"], &half, observer).0
    }

    /// A vector over its length, and whether it has a direction.
    fn normalised(
        &self,
        [prefix, name]: [&str; 2],
        vector: &Vector,
        observer: &mut impl Observer,
    ) -> (Vector, bool) {
        let f = &self.formats;
        let z = narrow(
            observer,
            format_args!("{prefix}length_squared"),
            dot(vector, vector),
            f.length_squared,
        );
        let gain = reciprocal_square_root(z, f.gain.integer_bits, f.gain.fraction_bits);
        observer.see(format_args!("{prefix}gain"), gain, f.gain);
        let unit = narrow_vector(observer, name, vector.map(|c| gain * c), f.vector);
        (unit, z > Wide::ZERO)
    }

    /// n = N'/|N'| with N' = N0 + a (N1 - N0), and whether N' has a direction.
    fn normal(
        &self,
        span: &ConsistentSpan<Wide>,
        i: u32,
        observer: &mut impl Observer,
    ) -> (Vector, bool) {
        let f = &self.formats;
        let accumulated = Wide::from_num(i) * span.weight_step;
        observer.see(format_args!("weight_accumulator"), accumulated, f.weight_accumulator);
        let weight = narrow(observer, format_args!("weight"), accumulated, f.weight);
        let lerp: Vector =
            std::array::from_fn(|c| span.normal_start[c] + weight * span.normal_delta[c]);
        let interpolated = narrow_vector(observer, "interpolated", lerp, f.vector);
        self.normalised(["", "normal"], &interpolated, observer)
    }

    /// q at t, both on the safe side.
    fn contraction(
        &self,
        span: &ConsistentSpan<Wide>,
        i: u32,
        observer: &mut impl Observer,
    ) -> Wide {
        let f = &self.formats;
        let accumulated = span.angle_start + Wide::from_num(i) * span.angle_step;
        observer.see(format_args!("angle_accumulator"), accumulated, f.angle_accumulator);
        let t = round_up(accumulated, f.angle.fraction_bits).min(Wide::ONE);
        observer.see(format_args!("angle"), t, f.angle);
        let q = match self.curve {
            Curve::Rational => self.rational(t),
            Curve::Trigonometric => {
                let tangent = self.tangent(Wide::ONE - t);
                observer.see(format_args!("tangent"), tangent, f.tangent);
                round_down(tangent * tangent, f.contraction.fraction_bits)
            }
        };
        observer.see(format_args!("contraction"), q, f.contraction);
        q
    }

    /// (1 - t)²/(1 + κt), rounded down; the raw values' common factor cancels.
    fn rational(&self, t: Wide) -> Wide {
        let fraction_bits = self.formats.contraction.fraction_bits;
        let (p, q) = ((Wide::ONE - t) * (Wide::ONE - t), Wide::ONE + KAPPA * t);
        let (p, q) = (p.to_bits(), q.to_bits());
        Wide::from_num((p << fraction_bits) / q) >> fraction_bits
    }

    /// tan(πu/4) = u (1 - (1 - v) S(v)) with v = u².
    fn tangent(&self, u: Wide) -> Wide {
        let fraction_bits = self.formats.tangent.fraction_bits;
        let v = round_down(u * u, fraction_bits);
        let [first @ .., last] = TANGENT.map(|s| Wide::from_num(s) >> TANGENT_FRACTION_BITS);
        let up = |x| round_up(x, fraction_bits);
        let h = first.iter().rev().fold(up(last), |h, s| up(s + v * h));
        let w = up((Wide::ONE - v) * h);
        round_down(u * (Wide::ONE - w), fraction_bits)
    }

    /// r = (g + ρb) n - ρI.
    fn reflection(
        &self,
        of: &str,
        mirror: &Mirror,
        incoming: &Vector,
        observer: &mut impl Observer,
    ) -> Reflection {
        let f = &self.formats;
        let (n, q) = (&mirror.normal, mirror.q);
        let b = round_to(dot(n, incoming), f.cosine.fraction_bits).clamp(-Wide::ONE, Wide::ONE);
        observer.see(format_args!("{of}cos_beta"), b, f.cosine);
        let g = narrow(
            observer,
            format_args!("{of}cos_gamma"),
            Wide::ONE + q * (b - Wide::ONE),
            f.cosine,
        );
        let squared = self.sine_ratio_squared(q * (Wide::ONE + g), Wide::ONE + b);
        observer.see(format_args!("{of}sine_ratio_squared"), squared, f.sine_ratio_squared);
        let rho = round_root(squared, f.sine_ratio.fraction_bits);
        observer.see(format_args!("{of}sine_ratio"), rho, f.sine_ratio);
        let share = narrow(observer, format_args!("{of}normal_share"), g + rho * b, f.cosine);
        let r = narrow_vector(
            observer,
            format_args!("{of}reflection"),
            std::array::from_fn(|c| share * n[c] - rho * incoming[c]),
            f.vector,
        );
        Reflection { b, g, r }
    }

    /// p/q, kept within 0 to 1, and 0 where either is.
    fn sine_ratio_squared(&self, p: Wide, q: Wide) -> Wide {
        if p <= Wide::ZERO || q <= Wide::ZERO {
            Wide::ZERO
        } else if p >= q {
            Wide::ONE
        } else {
            round_quotient(p, q, self.formats.sine_ratio_squared.fraction_bits)
        }
    }

    fn diffuse(&self, mirror: &Mirror, direction: &Vector, observer: &mut impl Observer) -> Wide {
        let format = self.formats.diffuse;
        let intensity = match self.diffuse {
            Diffuse::Lambert => round_to(dot(&mirror.normal, direction), format.fraction_bits)
                .clamp(Wide::ZERO, Wide::ONE),
            Diffuse::Consistent => {
                let of = self.consistent_cosine("", mirror, direction, format, observer);
                if of.is_lit { of.cosine } else { Wide::ZERO }
            }
        };
        observer.see(format_args!("diffuse"), intensity, format);
        intensity
    }

    /// |I + r|/2, and whether I is above the horizon of a normal with a direction.
    fn consistent_cosine(
        &self,
        of: &str,
        mirror: &Mirror,
        incoming: &Vector,
        to: Format,
        observer: &mut impl Observer,
    ) -> ConsistentCosine {
        let Reflection { b, g, r } = self.reflection(of, mirror, incoming, observer);
        let sum: Vector = std::array::from_fn(|c| incoming[c] + r[c]);
        ConsistentCosine {
            cosine: round_root(dot(&sum, &sum).min(FOUR) >> 2, to.fraction_bits),
            is_lit: mirror.has_direction && g + b > Wide::ZERO,
        }
    }

    /// The highlight: a power of r·L or N_c·H, and 0 where the normal has no direction or H is below
    /// the horizon.
    fn specular(
        &self,
        pixel: &Pixel,
        direction: &Vector,
        halfway: Option<&Vector>,
        observer: &mut impl Observer,
    ) -> Wide {
        let Pixel { mirror, reflection, .. } = pixel;
        let format = self.formats.base;
        let base = match (self.highlight, halfway) {
            (Highlight::Blinn, Some(halfway)) => {
                self.consistent_cosine("halfway_", mirror, halfway, format, observer)
            }
            _ => {
                let cosine = round_to(dot(&reflection.r, direction), format.fraction_bits)
                    .clamp(Wide::ZERO, Wide::ONE);
                let is_lit = mirror.has_direction;
                ConsistentCosine { cosine: if is_lit { cosine } else { Wide::ZERO }, is_lit }
            }
        };
        observer.see(format_args!("base"), base.cosine, format);
        let power = self.power.raise(observer, base.cosine, pixel.exponent);
        if base.is_lit { power } else { Wide::ZERO }
    }
}

//! `lyon`, bit for bit [Lyon, TR 43; methods B; `docs/arithmetic.md`].
use specula_spec::lyon::{
    Difference, Halfway, LOG2_LARGEST_GAIN, LyonFormats, LyonInputs, LyonLight, LyonSpan, LyonSpec,
    Normalisation, ShapeDatapath,
};

use specula_spec::ways::{VectorLight, VectorWay};
use specula_spec::{CoreParameters, Format};

use super::error::PacketError;
use super::forward::Accumulator;
use super::highlight::limited_quotient;
use super::method::{Intensities, Method};
use super::number::Wide;
use super::observer::{Observer, narrow, narrow_vector};
use super::packet;
use super::root::reciprocal_square_root;
use super::span_extent::SpanExtent;
use super::span_vectors::SpanVectors;
use super::spot::spotted;
use super::vector::{Vector, dot, truncated_cross, truncated_dot};
use super::vector_ways::VectorWays;
use super::wrapped::{WrapFormats, wrapped};

/// V = (0, 0, 1).
const EYE: Vector = [Wide::ZERO, Wide::ZERO, Wide::ONE];
const TWO: Wide = Wide::lit("2");
const THREE: Wide = Wide::lit("3");
/// A half-way vector that g2 brings near unit length is longer than 1 by 0.00176 at most (methods
/// B9).
const LONGEST_BY_G2: Wide = Wide::lit("1.002");

/// The method in one core's formats.
pub(super) struct Lyon {
    normalisation: Normalisation,
    newton_steps: u32,
    difference: Difference,
    shape: ShapeDatapath,
    squarings: u32,
    odd_power: u32,
    /// h of the root shape.
    root_shift: u32,
    halfway: Halfway,
    normals: SpanVectors,
    ways: VectorWays,
    formats: LyonFormats,
}

impl Lyon {
    pub fn new(core: &CoreParameters, lyon: &LyonSpec) -> Lyon {
        Lyon {
            normalisation: lyon.normalisation,
            newton_steps: lyon.newton_steps,
            difference: lyon.difference,
            shape: lyon.shape,
            squarings: lyon.squarings,
            odd_power: lyon.odd_power,
            root_shift: lyon.root_shift(),
            halfway: lyon.halfway,
            normals: SpanVectors {
                increments: lyon.increments,
                weight_accumulator: lyon.formats.weight_accumulator,
                weight: lyon.formats.weight,
                components: Accumulator {
                    exact: lyon.formats.normal_accumulator,
                    rounded: lyon.formats.vector,
                },
            },
            ways: VectorWays::new(
                core,
                lyon.formats.way_accumulator,
                lyon.formats.vector,
                [lyon.formats.shape; 2],
            ),
            formats: lyon.formats.clone(),
        }
    }
}

/// What the lights have in common at one pixel.
pub(super) struct Pixel {
    normal: Vector,
    has_direction: bool,
    i: u32,
    /// V, and whether the eye is not at the very pixel.
    view: (Vector, bool),
    /// n, n over the odd power, or m of the root shape.
    shininess: Wide,
}

impl Method for Lyon {
    type Span = LyonSpan<Wide>;
    type Light = LyonLight<Wide>;
    /// n, if the next pixel's may be wrapped around it.
    type State = Option<Vector>;
    type Pixel = Pixel;

    fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.formats.diffuse, specular: self.formats.shape }
    }

    /// Whether Newton's steps converge and |n| < 2.
    ///
    /// |N0|, |N1| ≤ 1 + 1/16 in `S1.4`, the coarsest format, and a ≤ 1 + 1/16 give |N'| ≤ 17/16 · (1 + 2/16) + √3/32 < 1.26, so z < 1.6. There z·g1² ≤ 1 and
    /// z·g2² < 1.42, inside the 3 below which g(3 - z g²)/2 goes towards 1/√z, and |n| = g√z < 1.2
    /// at first and 1 after a step, before rounding.
    fn check(&self, inputs: &LyonInputs<Wide>, extent: SpanExtent) -> Result<(), PacketError> {
        let span = &inputs.span;
        let axis = span.wrap_axis.unwrap_or_default();
        packet::check_length(format_args!("wrap_axis"), &axis, Wide::ONE, self.formats.vector)?;
        let longest_halfway = if self.difference.takes_halfway() { TWO } else { LONGEST_BY_G2 };
        for (i, light) in inputs.lights.iter().map(|inputs| &inputs.light).enumerate() {
            let direction = light.direction.unwrap_or_default();
            packet::check_length(
                format_args!("light{i}_direction"),
                &direction,
                Wide::ONE,
                self.formats.vector,
            )?;
            let way = light.way.as_ref();
            way.map_or(Ok(()), |way| self.ways.check_light(i, way, extent))?;
            let halfway = light.halfway.unwrap_or_default();
            packet::check_length(
                format_args!("light{i}_halfway"),
                &halfway,
                longest_halfway,
                self.formats.vector,
            )?;
        }
        let eye = span.eye.as_ref();
        eye.map_or(Ok(()), |eye| self.ways.check_way(format_args!("eye"), eye, extent))?;
        // H of normals wrapped around a fixed vector is the sum of two unit vectors.
        let longest = if span.wrap_axis.is_some() && span.wrap_follows.is_none() { 2 } else { 1 };
        let start = &span.normal_start;
        match &span.normal_delta {
            Some(delta) => {
                self.normals.check(format_args!("normal"), [start, delta], longest, extent)?;
            }
            None => {
                packet::check_length(
                    format_args!("normal"),
                    start,
                    Wide::ONE,
                    self.formats.vector,
                )?;
            }
        }
        self.normals.check_weight(span.weight_step, extent)
    }

    /// n, wrapped around that of the pixel before, or around the axis (methods C7).
    fn state(
        &self,
        span: &LyonSpan<Wide>,
        before: Option<Option<Vector>>,
        i: u32,
        observer: &mut impl Observer,
    ) -> Option<Vector> {
        let (axis, follows) = (span.wrap_axis?, span.wrap_follows? == Wide::ONE);
        let interpolated = self.interpolated(span, i, observer)?;
        let before = before.flatten().filter(|_| follows).unwrap_or(axis);
        Some(self.next(&interpolated, &before, observer))
    }

    fn pixel(
        &self,
        span: &LyonSpan<Wide>,
        followed: Option<Vector>,
        i: u32,
        observer: &mut impl Observer,
    ) -> Pixel {
        let (normal, has_direction) = match followed {
            Some(normal) => (normal, normal != [Wide::ZERO; 3]),
            None => self.normal(span, i, observer),
        };
        let view = match &span.eye {
            Some(eye) => self.direction(["eye_", "eye", "view"], eye, i, observer),
            None => (EYE, true),
        };
        Pixel { normal, has_direction, i, view, shininess: span.shininess }
    }

    fn light(
        &self,
        pixel: &Pixel,
        light: &LyonLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        if let Some(way) = &light.way {
            return self.arriving(pixel, way, observer);
        }
        // An input that is not there is 0.
        let direction = light.direction.unwrap_or_default();
        let diffuse = self.diffuse(&pixel.normal, &direction, observer);
        let difference = match &light.halfway {
            Some(halfway) => self.difference_by_halfway(&pixel.normal, halfway, observer),
            None => self.difference_by_reflection(&pixel.normal, [&direction, &EYE], observer),
        };
        let highlight = self.specular(&difference, pixel.shininess, observer);
        let specular = if pixel.has_direction { highlight } else { Wide::ZERO };
        Intensities { diffuse, specular }
    }
}

impl Lyon {
    /// The intensities of a light whose way is followed.
    fn arriving(
        &self,
        pixel: &Pixel,
        light: &VectorLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let (l, exists) =
            self.direction(["way_", "way", "direction"], &light.way, pixel.i, observer);
        let (v, is_seen) = &pixel.view;
        let diffuse = self.diffuse(&pixel.normal, &l, observer);
        let difference = if self.difference.takes_halfway() {
            let sum = std::array::from_fn(|c| l[c] + v[c]);
            self.difference_by_halfway(&pixel.normal, &sum, observer)
        } else if self.difference.takes_unit_halfway() {
            let halfway = self.unit_halfway(&l, v, observer);
            self.difference_by_halfway(&pixel.normal, &halfway, observer)
        } else {
            self.difference_by_reflection(&pixel.normal, [&l, v], observer)
        };
        let highlight = self.specular(&difference, pixel.shininess, observer);
        let is_lit = pixel.has_direction && exists && *is_seen;
        let specular = if is_lit { highlight } else { Wide::ZERO };
        let intensities = Intensities { diffuse, specular };
        let share = self.ways.share(observer, light.spot.as_ref(), &l);
        spotted(share, intensities, &self.formats())
    }

    /// A way at pixel i, brought near unit length as normals are, and whether it has a direction.
    fn direction(
        &self,
        [prefix, of, name]: [&str; 3],
        way: &VectorWay<Wide>,
        i: u32,
        observer: &mut impl Observer,
    ) -> (Vector, bool) {
        let vector = self.ways.at(observer, of, way, i);
        self.normalised([prefix, name], &vector, self.normalisation(), observer)
    }

    /// h of about unit length, made of L and V (methods B6, B7).
    fn unit_halfway(&self, l: &Vector, v: &Vector, observer: &mut impl Observer) -> Vector {
        let half: Vector = std::array::from_fn(|c| (l[c] + v[c]) >> 1);
        let by = match self.halfway {
            Halfway::Half => return half,
            Halfway::Unit => (Normalisation::Exact, 0),
            Halfway::HalfG2 => (Normalisation::G2, 0),
        };
        self.normalised(["halfway_", "halfway"], &half, by, observer).0
    }

    /// A vector brought near unit length, and whether it has a direction.
    fn normalised(
        &self,
        [prefix, name]: [&str; 2],
        vector: &Vector,
        by: (Normalisation, u32),
        observer: &mut impl Observer,
    ) -> (Vector, bool) {
        let f = &self.formats;
        if by.0 == Normalisation::None {
            return (*vector, *vector != [Wide::ZERO; 3]);
        }
        let square = match by.0 {
            Normalisation::Exact => dot(vector, vector),
            _ => truncated_dot(vector, vector, f.product.fraction_bits),
        };
        let z = narrow(observer, format_args!("{prefix}length_squared"), square, f.length_squared);
        let gain = self.gain(z, by, observer);
        let unit = vector.map(|c| gain * c);
        (narrow_vector(observer, name, unit, f.vector), z != Wide::ZERO)
    }

    /// n = g N', with N' = N0 + a (N1 - N0), and whether N' has a direction.
    fn normal(
        &self,
        span: &LyonSpan<Wide>,
        i: u32,
        observer: &mut impl Observer,
    ) -> (Vector, bool) {
        let f = &self.formats;
        let Some(interpolated) = self.interpolated(span, i, observer) else {
            return (span.normal_start, span.normal_start != [Wide::ZERO; 3]);
        };
        if let Some(axis) = &span.wrap_axis {
            let formats =
                WrapFormats { operand: f.wrap_operand, ratio: f.wrap_ratio, vector: f.vector };
            let normal = wrapped(observer, ["wrap", "normal"], &interpolated, axis, formats).vector;
            return (normal, normal != [Wide::ZERO; 3]);
        }
        self.normalised(["", "normal"], &interpolated, self.normalisation(), observer)
    }

    /// The normalisation of normals and of ways, and its Newton steps.
    fn normalisation(&self) -> (Normalisation, u32) {
        (self.normalisation, self.newton_steps)
    }

    /// N' = N0 + a (N1 - N0), or that by additions; none of flat normals.
    fn interpolated(
        &self,
        span: &LyonSpan<Wide>,
        i: u32,
        observer: &mut impl Observer,
    ) -> Option<Vector> {
        let delta = span.normal_delta?;
        let on_span = self.normals.pixel(observer, i, span.weight_step);
        Some(self.normals.at(observer, "interpolated", [&span.normal_start, &delta], on_span))
    }

    /// n = N' + u H with H = N' + b and u = (1 - z)/H·H, clamped to 0 to 1: 2H (H·b)/(H·H) - b for
    /// a unit vector b.
    fn next(&self, interpolated: &Vector, before: &Vector, observer: &mut impl Observer) -> Vector {
        let f = &self.formats;
        let z = narrow(
            observer,
            format_args!("length_squared"),
            dot(interpolated, interpolated),
            f.length_squared,
        );
        let h: Vector = std::array::from_fn(|c| interpolated[c] + before[c]);
        let q = narrow(observer, format_args!("wrap_q"), dot(&h, &h), f.wrap_operand);
        let ratio = limited_quotient(Wide::ONE - z, q, f.wrap_ratio.fraction_bits);
        observer.see(format_args!("wrap_ratio"), ratio, f.wrap_ratio);
        narrow_vector(
            observer,
            "normal",
            std::array::from_fn(|c| interpolated[c] + ratio * h[c]),
            f.vector,
        )
    }

    /// g, near 1/√z: g1 or g2 (methods B8, B9), then Newton steps.
    fn gain(
        &self,
        z: Wide,
        (normalisation, newton_steps): (Normalisation, u32),
        observer: &mut impl Observer,
    ) -> Wide {
        let y = Wide::ONE - z;
        let first = match normalisation {
            Normalisation::None => return Wide::ONE,
            Normalisation::Exact => {
                let root =
                    reciprocal_square_root(z, LOG2_LARGEST_GAIN, self.formats.gain.fraction_bits);
                observer.see(format_args!("gain"), root, self.formats.gain);
                return root;
            }
            Normalisation::G1 => Wide::ONE + (y >> 1),
            Normalisation::G2 => Wide::ONE + ((y + y * y) >> 1),
        };
        let first = narrow(observer, format_args!("gain"), first, self.formats.gain);
        (0..newton_steps).fold(first, |g, step| self.newton(g, z, step, observer))
    }

    /// g (3 - z g²)/2.
    fn newton(&self, g: Wide, z: Wide, step: u32, observer: &mut impl Observer) -> Wide {
        let format = self.formats.gain;
        let square = narrow(observer, format_args!("newton{step}_square"), g * g, format);
        let factor =
            narrow(observer, format_args!("newton{step}_factor"), THREE - z * square, format);
        narrow(observer, format_args!("newton{step}_gain"), (g * factor) >> 1, format)
    }

    fn diffuse(&self, normal: &Vector, direction: &Vector, observer: &mut impl Observer) -> Wide {
        // Rounding is monotonic and leaves 0 as it is, so that the clamp may come first.
        let cosine = truncated_dot(normal, direction, self.formats.product.fraction_bits);
        let cosine = cosine.max(Wide::ZERO);
        narrow(observer, format_args!("diffuse"), cosine, self.formats.diffuse)
    }

    /// f of x, which is made of D and n or m.
    fn specular(&self, difference: &Vector, shininess: Wide, observer: &mut impl Observer) -> Wide {
        let shape = match self.shape {
            ShapeDatapath::FK => self.shape_of_product(difference, shininess, observer),
            ShapeDatapath::Root => self.shape_of_squares(difference, shininess, observer),
        };
        observer.see(format_args!("shape"), shape, self.formats.shape);
        let odd = self.to_odd_power(shape, observer);
        (0..self.squarings).fold(odd, |f, k| {
            narrow(observer, format_args!("square{k}"), f * f, self.formats.shape)
        })
    }

    /// The base to the odd power: of the power's binary digits behind the first, each squares, and a
    /// 1 then multiplies by the base.
    fn to_odd_power(&self, base: Wide, observer: &mut impl Observer) -> Wide {
        let digits = (0..self.odd_power.ilog2()).rev();
        digits.fold(base, |f, digit| {
            let square =
                narrow(observer, format_args!("odd_square{digit}"), f * f, self.formats.shape);
            match (self.odd_power >> digit) & 1 {
                0 => square,
                _ => {
                    let product = square * base;
                    narrow(
                        observer,
                        format_args!("odd_product{digit}"),
                        product,
                        self.formats.shape,
                    )
                }
            }
        })
    }

    /// max(0, 1 - x) with x = n D·D / 2^(k+1), or 4n for n, and n over the odd power.
    fn shape_of_product(
        &self,
        difference: &Vector,
        shininess: Wide,
        observer: &mut impl Observer,
    ) -> Wide {
        let exponent = shininess << self.difference.log2_exponent_factor();
        let square = truncated_dot(difference, difference, self.formats.product.fraction_bits);
        let argument = (exponent * square) >> (self.squarings + 1);
        let argument =
            narrow(observer, format_args!("shape_argument"), argument, self.formats.shape);
        (Wide::ONE - argument).max(Wide::ZERO)
    }

    /// max(0, 1 - u·u) with u_c = m |D_c| / 2^h, and 0 where a component of u is 1 or more.
    fn shape_of_squares(&self, difference: &Vector, m: Wide, observer: &mut impl Observer) -> Wide {
        let scaled = difference.map(|c| (m * c.abs()) >> self.root_shift);
        let scaled =
            narrow_vector(observer, "scaled_difference", scaled, self.formats.scaled_difference);
        let fraction = scaled.map(Wide::frac);
        let argument = narrow(
            observer,
            format_args!("shape_argument"),
            dot(&fraction, &fraction),
            self.formats.shape,
        );
        if fraction == scaled { (Wide::ONE - argument).max(Wide::ZERO) } else { Wide::ZERO }
    }

    /// D of a reflection of L or V.
    fn difference_by_reflection(
        &self,
        normal: &Vector,
        [l, v]: [&Vector; 2],
        observer: &mut impl Observer,
    ) -> Vector {
        match self.difference {
            Difference::LightReflection => {
                self.reflected_minus(normal, "twice_n_dot_l", l, v, observer)
            }
            _ => self.reflected_minus(normal, "twice_n_dot_v", v, l, observer),
        }
    }

    /// D of a half-way vector.
    fn difference_by_halfway(
        &self,
        normal: &Vector,
        halfway: &Vector,
        observer: &mut impl Observer,
    ) -> Vector {
        match self.difference {
            Difference::HalfwayCrossNormal => self.halfway_cross_normal(halfway, normal, observer),
            Difference::UnitHalfwayMinusNormal => {
                self.halfway_minus_normal(halfway, normal, observer)
            }
            _ => self.halfway_projection(halfway, normal, observer),
        }
    }

    /// D = h - n (methods B6).
    fn halfway_minus_normal(
        &self,
        halfway: &Vector,
        normal: &Vector,
        observer: &mut impl Observer,
    ) -> Vector {
        let difference = std::array::from_fn(|c| halfway[c] - normal[c]);
        narrow_vector(observer, "difference", difference, self.formats.difference)
    }

    /// D = (h·n) n - h (methods B5, B6).
    fn halfway_projection(
        &self,
        halfway: &Vector,
        normal: &Vector,
        observer: &mut impl Observer,
    ) -> Vector {
        let format = self.formats.difference;
        let length = narrow(observer, format_args!("h_dot_n"), dot(halfway, normal), format);
        let difference = std::array::from_fn(|c| length * normal[c] - halfway[c]);
        narrow_vector(observer, "difference", difference, format)
    }

    /// D = H × n (methods B13).
    fn halfway_cross_normal(
        &self,
        halfway: &Vector,
        normal: &Vector,
        observer: &mut impl Observer,
    ) -> Vector {
        let d = truncated_cross(halfway, normal, self.formats.product.fraction_bits);
        narrow_vector(observer, "difference", d, self.formats.difference)
    }

    /// D = 2(n·of) n - of - from (methods B2, B4).
    fn reflected_minus(
        &self,
        normal: &Vector,
        name: &str,
        of: &Vector,
        from: &Vector,
        observer: &mut impl Observer,
    ) -> Vector {
        let format = self.formats.difference;
        let twice = narrow(observer, format_args!("{name}"), dot(normal, of) << 1, format);
        let difference = std::array::from_fn(|c| twice * normal[c] - of[c] - from[c]);
        narrow_vector(observer, "difference", difference, format)
    }
}

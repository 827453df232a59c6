//! `slerp`, bit for bit [lecture, eq. 4.7, 4.9 to 4.12; methods A10, A11;
//! `docs/arithmetic/slerp.md`].
use std::{fmt, iter};

use specula_spec::slerp::{
    Axes, LightAlongArc, OnArc, SlerpFormats, SlerpInputs, SlerpLight, SlerpSpan, SlerpSpec,
    WayAlongArc,
};
use specula_spec::ways::VectorWay;
use specula_spec::{CoreParameters, Format, Linear};

use super::error::PacketError;
use super::method::{Intensities, Method};
use super::number::{Wide, round_to};
use super::observer::{Observer, narrow, narrow_vector};
use super::packet;
use super::raised::Raised;
use super::span_extent::SpanExtent;
use super::spot::spotted;
use super::vector::{Vector, dot};
use super::ways::Ways;

/// The method in one core's formats.
pub(super) struct Slerp {
    /// Of the angles' cosines and sines.
    state: Format,
    power: Raised,
    ways: Ways,
    formats: SlerpFormats,
}

/// A cosine and a sine, times a factor.
type Circling = [Wide; 2];

impl Slerp {
    pub fn new(core: &CoreParameters, slerp: &SlerpSpec) -> Slerp {
        Slerp {
            state: if slerp.between_ends() {
                slerp.formats.scaled_state
            } else {
                slerp.formats.state
            },
            power: Raised::new(core, slerp.power_unit()),
            ways: Ways::new(core, slerp.ways()),
            formats: slerp.formats.clone(),
        }
    }
}

/// What the lights have in common at one pixel.
pub(super) struct Pixel {
    weights: [Wide; 2],
    normal: Option<Vector>,
    n_dot_v: Wide,
    i: u32,
    /// 1/√(E·E) of an eye at a place.
    eye: Option<Wide>,
    exponent: Wide,
}

impl Method for Slerp {
    type Span = SlerpSpan<Wide>;
    type Light = SlerpLight<Wide>;
    /// What the weights of start and end are taken from.
    type State = [Circling; 2];
    type Pixel = Pixel;

    fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.formats.diffuse, specular: self.power.format() }
    }

    /// A turn that stretches would leave every range: its squares add up to 1 but for the host's
    /// rounding. With weights below 8 normals are shorter than 18, before their length is
    /// corrected.
    fn check(&self, inputs: &SlerpInputs<Wide>, extent: SpanExtent) -> Result<(), PacketError> {
        let span = &inputs.span;
        let stretch = span.turn_cosine * span.turn_cosine
            + span.turn_sine * span.turn_back.unwrap_or(span.turn_sine);
        let longest = Wide::ONE + (Wide::ONE >> (self.formats.turn.fraction_bits - 1));
        if let Some(Axes { start, other }) = &span.normal {
            packet::check_length(
                format_args!("normal_start"),
                start,
                Wide::ONE,
                self.formats.vector,
            )?;
            packet::check_length(
                format_args!("normal_other"),
                other,
                Wide::ONE,
                self.formats.vector,
            )?;
        }
        if let Some(eye) = &span.eye {
            self.check_way(format_args!("eye"), &eye.normal, extent)?;
            self.ways.check(format_args!("eye_squared"), &eye.squared, extent, 0)?;
        }
        inputs.lights.iter().enumerate().try_for_each(|(index, inputs)| {
            let Some(light) = &inputs.light.way else { return Ok(()) };
            self.check_way(format_args!("light{index}_way"), &light.normal, extent)?;
            self.ways.check_way(index, &light.way, extent)
        })?;
        let states = iter::successors(Some(first(span)), |&state| Some(self.turned(span, state)));
        let are_small =
            || states.take(extent.length as usize).flatten().flatten().all(|x| x.abs() < 8);
        let fits = stretch <= longest && (span.turn_back.is_none() || are_small());
        if fits { Ok(()) } else { Err(PacketError::Turn) }
    }

    fn state(
        &self,
        span: &SlerpSpan<Wide>,
        before: Option<[Circling; 2]>,
        _i: u32,
        _observer: &mut impl Observer,
    ) -> [Circling; 2] {
        before.map_or_else(|| first(span), |before| self.turned(span, before))
    }

    fn pixel(
        &self,
        span: &SlerpSpan<Wide>,
        state: [Circling; 2],
        i: u32,
        observer: &mut impl Observer,
    ) -> Pixel {
        let weights = self.weights(state, observer);
        let normal = span.normal.as_ref().map(|axes| self.normal(axes, weights, observer));
        let eye = span.eye.as_ref().map(|to| self.ways.root(observer, "eye", &to.squared, i));
        let n_dot_v = match (&span.eye, eye, &normal) {
            (Some(to), Some(root), _) => {
                let way = self.along("eye", &to.normal, (normal.as_ref(), weights), i, observer);
                self.ways.cosine(observer, "n_dot_v", way, root)
            }
            (.., Some(n)) => narrow(observer, format_args!("n_dot_v"), n[2], self.formats.cosine),
            _ => {
                let n_dot_v = on_arc(span.view.as_ref(), weights);
                narrow(observer, format_args!("n_dot_v"), n_dot_v, self.formats.cosine)
            }
        };
        let n_dot_v = match normal {
            Some(_) => n_dot_v,
            None => self.corrected(n_dot_v, weights, observer),
        };
        Pixel { weights, normal, n_dot_v, i, eye, exponent: span.exponent }
    }

    fn light(
        &self,
        pixel: &Pixel,
        light: &SlerpLight<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        if let Some(light) = &light.way {
            return self.arriving(pixel, light, observer);
        }
        let n_dot_l = match (&pixel.normal, &light.direction) {
            (Some(n), Some(direction)) => dot(n, direction),
            _ => on_arc(light.light.as_ref(), pixel.weights),
        };
        let n_dot_l = narrow(observer, format_args!("n_dot_l"), n_dot_l, self.formats.cosine);
        let diffuse = self.diffuse(n_dot_l, observer);
        // An input that is not there is 0.
        let dot_view = light.light_dot_view.unwrap_or(Wide::ZERO);
        let base = self.base(n_dot_l, pixel.n_dot_v, dot_view, observer);
        Intensities { diffuse, specular: self.power.raise(observer, base, pixel.exponent) }
    }
}

/// The state at the first pixel: between the ends both weights have angles of their own; else one
/// rotation has both.
fn first(span: &SlerpSpan<Wide>) -> [Circling; 2] {
    let falling = [Wide::ONE, span.falling_cosine.unwrap_or(Wide::ZERO)];
    let rising = [span.rising_cosine.unwrap_or(Wide::ONE), Wide::ZERO];
    [falling, rising]
}

/// u A·X + v T·X.
fn on_arc(scalars: Option<&OnArc<Wide>>, [u, v]: [Wide; 2]) -> Wide {
    scalars.map_or(Wide::ZERO, |scalars| u * scalars.start + v * scalars.across)
}

impl Slerp {
    fn check_way(
        &self,
        name: fmt::Arguments<'_>,
        way: &WayAlongArc<Wide>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        let components = way.vector.iter().flat_map(|vector| [&vector.x, &vector.y, &vector.z]);
        way.start
            .iter()
            .chain(&way.across)
            .chain(components)
            .try_for_each(|linear| self.ways.check_linear(name, linear, extent))
    }

    /// N·X of a way X, as an operand: of its scalars, or of the way itself where there is a normal.
    fn along(
        &self,
        name: &str,
        way: &WayAlongArc<Wide>,
        (normal, weights): (Option<&Vector>, [Wide; 2]),
        i: u32,
        observer: &mut impl Observer,
    ) -> Wide {
        let linear = |observer: &mut _, part: &str, linear: Option<&Linear<Wide>>| {
            let name = format_args!("{name}_{part}");
            linear.map_or(Wide::ZERO, |linear| self.ways.linear(observer, name, linear, i))
        };
        let exact = match (normal, &way.vector) {
            (Some(normal), Some(VectorWay { x, y, z })) => {
                let way = [("x", x), ("y", y), ("z", z)]
                    .map(|(part, component)| linear(observer, part, Some(component)));
                dot(normal, &way)
            }
            _ => {
                let start = linear(observer, "start", way.start.as_ref());
                let across = linear(observer, "across", way.across.as_ref());
                weights[0] * start + weights[1] * across
            }
        };
        narrow(observer, format_args!("{name}_normal"), exact, self.formats.cosine)
    }

    /// The intensities of a light whose way is followed.
    fn arriving(
        &self,
        pixel: &Pixel,
        light: &LightAlongArc<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let arrival = self.ways.arrival(observer, &light.way, pixel.eye, pixel.i);
        let normal = (pixel.normal.as_ref(), pixel.weights);
        let way = self.along("way", &light.normal, normal, pixel.i, observer);
        let n_dot_l = self.ways.cosine(observer, "n_dot_l", way, arrival.root);
        let diffuse = self.diffuse(n_dot_l, observer);
        let base = self.base(n_dot_l, pixel.n_dot_v, arrival.dot_view, observer);
        let specular = self.power.raise(observer, base, pixel.exponent);
        spotted(arrival.share, Intensities { diffuse, specular }, &self.formats())
    }

    /// The weights of start and end.
    fn weights(&self, [falling, rising]: [Circling; 2], observer: &mut impl Observer) -> [Wide; 2] {
        let [cosine, sine] = [falling[0], rising[1]];
        observer.see(format_args!("state_cosine"), cosine, self.state);
        observer.see(format_args!("state_sine"), sine, self.state);
        let c = narrow(observer, format_args!("weight_cosine"), cosine, self.formats.weight);
        let s = narrow(observer, format_args!("weight_sine"), sine, self.formats.weight);
        [c, s]
    }

    /// A turn further.
    fn turned(&self, span: &SlerpSpan<Wide>, [falling, rising]: [Circling; 2]) -> [Circling; 2] {
        let (cosine, sine) = (span.turn_cosine, span.turn_sine);
        let back = span.turn_back.unwrap_or(sine);
        let turned = |[c, s]: Circling, down: Wide, up: Wide| {
            [c * cosine - s * down, s * cosine + c * up]
                .map(|x| round_to(x, self.state.fraction_bits))
        };
        [turned(falling, sine, back), turned(rising, back, sine)]
    }

    /// K (2 - N·N).
    fn corrected(&self, n_dot_v: Wide, [c, s]: [Wide; 2], observer: &mut impl Observer) -> Wide {
        let format = self.formats.cosine;
        let correction = narrow(
            observer,
            format_args!("correction"),
            Wide::from_num(2) - (c * c + s * s),
            format,
        );
        narrow(observer, format_args!("corrected"), n_dot_v * correction, format)
    }

    /// n = N (3 - N·N)/2.
    fn normal(&self, axes: &Axes<Wide>, [u, v]: [Wide; 2], observer: &mut impl Observer) -> Vector {
        let f = &self.formats;
        let turned: Vector = std::array::from_fn(|c| u * axes.start[c] + v * axes.other[c]);
        let turned = narrow_vector(observer, "turned", turned, f.vector);
        let gain = narrow(
            observer,
            format_args!("gain"),
            (Wide::from_num(3) - dot(&turned, &turned)) / 2,
            f.cosine,
        );
        narrow_vector(observer, "normal", turned.map(|c| gain * c), f.vector)
    }

    /// J, kept within 0 to 1.
    fn diffuse(&self, n_dot_l: Wide, observer: &mut impl Observer) -> Wide {
        let diffuse =
            round_to(n_dot_l, self.formats.diffuse.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("diffuse"), diffuse, self.formats.diffuse);
        diffuse
    }

    /// 2 J K - L·V, kept within 0 to 1.
    fn base(
        &self,
        n_dot_l: Wide,
        n_dot_v: Wide,
        light_dot_view: Wide,
        observer: &mut impl Observer,
    ) -> Wide {
        let base = n_dot_l * n_dot_v * 2 - light_dot_view;
        let base = round_to(base, self.formats.base.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("base"), base, self.formats.base);
        base
    }
}

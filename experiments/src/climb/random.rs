//! Random scenes and cores.
use glam::DVec3;
use specula_scene::limits::{LARGEST_SHININESS, LONGEST_SPAN};
use specula_scene::{Colour, Material};
use specula_spec::{Format, LightPipelines, Method, NarrowingPoint, Specialise};

use super::core::CoreChoice;
use super::genome::Genome;
use crate::stress::draw::Draw;
use crate::stress::scene::{Light, RawSpan, SpanScene};

/// Largest length of most spans in pixels; a few are as long as possible.
pub(super) const LONGEST: u32 = 400;
/// Probability that a span is as long as possible.
const LONG: f64 = 0.02;
/// Largest number of spans of a scene.
pub(super) const MAX_SPANS: usize = 4;
/// Largest number of lights of a scene: what further ones add to a sum is no new arithmetic.
pub(super) const MAX_LIGHTS: usize = 4;

/// How many bits finer than the coarsest formats the coarse ones are.
const COARSE: i64 = 4;

/// Probability that one format of a core is coarse and all others are fine.
const ONE_COARSE: f64 = 0.5;
/// How many bits finer than by default those fine formats are.
const FINER: u32 = 4;

/// True with this probability.
pub(super) fn happens(draw: &mut Draw, probability: f64) -> bool {
    draw.unit() < probability
}

/// A number from `low` to `high`, both above 0, with a uniformly distributed logarithm.
pub(super) fn log_uniform(draw: &mut Draw, low: f64, high: f64) -> f64 {
    libm::exp2(draw.within(low.log2(), high.log2()))
}

/// The choice of a core's formats.
#[derive(Clone, Copy, Debug)]
pub enum Formats {
    /// Any formats.
    Any,
    /// The format of one narrowing point is at most as fine as by default, and all others are
    /// finer, so that the errors come from that point. The number is its relative position, 0 to 1,
    /// in the list of narrowing points.
    OneCoarse(f64),
}

impl Formats {
    /// Draws one of the two choices.
    pub fn draw(draw: &mut Draw) -> Formats {
        if happens(draw, ONE_COARSE) { Formats::OneCoarse(draw.unit()) } else { Formats::Any }
    }
}

/// A scene and a core for it with this method; `None` if no such core can be built.
pub fn genome(draw: &mut Draw, method: Method, of: Formats) -> Option<Genome> {
    let scene = scene(draw);
    let mut core = CoreChoice::default_of(method);
    core.light_pipelines =
        if happens(draw, 0.2) { LightPipelines::Shared } else { LightPipelines::Each };
    core.specialise = if happens(draw, 0.1) { Specialise::General } else { Specialise::Scene };
    for choice in method.option_domains() {
        if happens(draw, 0.4) {
            core.set_option(choice.key, draw.one_of(choice.values));
        }
    }
    let mut genome = Genome { scene, core }.repaired()?;
    match of {
        Formats::Any => formats(draw, &mut genome.core),
        Formats::OneCoarse(share) => one_coarse(draw, &mut genome.core, share),
    }
    genome.repaired()
}

/// Leaves all formats at their defaults, or makes all coarse or random, or some of them.
fn formats(draw: &mut Draw, core: &mut CoreChoice) {
    let share = draw.one_of(&[0.0, 0.3, 1.0]);
    let is_coarse = happens(draw, 0.5);
    for point in core.points.clone() {
        if happens(draw, share) {
            let format =
                if is_coarse { coarse_format(draw, &point) } else { any_format(draw, &point) };
            core.set_format(point.name, format);
        }
    }
}

/// Makes one format coarse and all others finer than by default.
fn one_coarse(draw: &mut Draw, core: &mut CoreChoice, share: f64) {
    let points = core.points.clone();
    let coarse = (share * points.len() as f64) as usize;
    for (number, point) in points.iter().enumerate() {
        let (fewest, most) = (point.fewest_fraction_bits, point.most_fraction_bits);
        let by_default = point.format.fraction_bits;
        let fraction_bits = if number == coarse {
            draw.between(fewest.min(by_default).into(), by_default.into()) as u32
        } else {
            (by_default + FINER).min(most.max(by_default))
        };
        core.set_format(point.name, Format { fraction_bits, ..point.format });
    }
}

/// A format that the narrowing point may have.
pub(super) fn any_format(draw: &mut Draw, point: &NarrowingPoint) -> Format {
    let (fewest, most) =
        (point.fewest_fraction_bits, point.most_fraction_bits.max(point.fewest_fraction_bits));
    Format { fraction_bits: draw.between(fewest.into(), most.into()) as u32, ..point.format }
}

fn coarse_format(draw: &mut Draw, point: &NarrowingPoint) -> Format {
    let fraction_bits = point.fewest_fraction_bits + draw.between(0, COARSE) as u32;
    Format {
        fraction_bits: fraction_bits.min(point.most_fraction_bits.max(point.fewest_fraction_bits)),
        ..point.format
    }
}

fn scene(draw: &mut Draw) -> SpanScene {
    let lights: Vec<Light> =
        (0..draw.one_of(&[1, 1, 1, 2, 2, 3, 4])).map(|_| light(draw)).collect();
    SpanScene {
        ambient: colour(draw),
        colours: lights.iter().map(|_| colour(draw)).collect(),
        lights,
        eye: happens(draw, 0.15).then(|| place(draw)),
        spans: (0..draw.one_of(&[1, 1, 2, 2, 3])).map(|_| span(draw)).collect(),
    }
}

/// A random light, most often at infinity.
pub(super) fn light(draw: &mut Draw) -> Light {
    match draw.one_of(&[0, 0, 0, 0, 0, 1, 2]) {
        1 => Light::At(place(draw)),
        2 => {
            let position = place(draw);
            let target = position + draw.direction();
            Light::Spot { position, target, exponent: exponent(draw) }
        }
        _ => Light::Towards(draw.direction()),
    }
}

/// A point near the picture's middle, or sometimes very near or far.
pub(super) fn place(draw: &mut Draw) -> DVec3 {
    let (nearest, farthest) = if happens(draw, 0.1) { (1e-6, 1e6) } else { (0.05, 20.0) };
    log_uniform(draw, nearest, farthest) * draw.direction()
}

/// The length of a span in pixels.
pub(super) fn length(draw: &mut Draw) -> u32 {
    let longest = if happens(draw, LONG) { LONGEST_SPAN } else { LONGEST };
    draw.length(longest)
}

/// White, grey, black or a random colour.
pub(super) fn colour(draw: &mut Draw) -> Colour {
    match draw.between(0, 5) {
        0 => [1.0; 3],
        1 => [0.0; 3],
        2 => [0, 1, 2].map(|_| draw.unit()),
        3 => [draw.one_of(&[0.1, 0.3, 0.5, 0.9]); 3],
        _ => [draw.unit(); 3],
    }
}

/// An exponent n: a power of two more often than not, and sometimes the largest.
pub(super) fn exponent(draw: &mut Draw) -> u32 {
    match draw.between(0, 19) {
        1..=11 => draw.even_shininess(),
        12 => LARGEST_SHININESS,
        _ => draw.length(LARGEST_SHININESS),
    }
}

/// A random material.
pub(super) fn material(draw: &mut Draw) -> Material {
    let strength = draw.one_of(&[1.0, 1.0, 1.0, 2.5, 4.0]);
    Material {
        ambient: colour(draw),
        diffuse: colour(draw),
        specular: colour(draw).map(|component| strength * component),
        shininess: exponent(draw),
    }
}

/// Three unit vectors. The two of an edge are close to each other, exactly or nearly opposite, or
/// at any angle. Sometimes a vector is 0.
pub(super) fn normals(draw: &mut Draw) -> [DVec3; 3] {
    let degrees = match draw.between(0, 9) {
        1 => 180.0 - log_uniform(draw, 1e-6, 10.0),
        2 => 180.0,
        _ => log_uniform(draw, 0.01, 170.0),
    };
    let [first, last] = draw.ends(degrees, 90.0);
    let mut normals = match draw.between(0, 3) {
        0 => [first; 3],
        1 => [first, last, draw.direction()],
        _ => [first, last, first],
    };
    if happens(draw, 0.05) {
        normals[draw.between(0, 2) as usize] = DVec3::ZERO;
    }
    normals
}

/// The polygon's own normal: most often that of its vertices, or a random one, or none.
pub(super) fn face(draw: &mut Draw) -> Option<DVec3> {
    match draw.between(0, 7) {
        1 => Some(draw.direction()),
        2 => Some(DVec3::ZERO),
        _ => None,
    }
}

/// Weights of three vertices: those of one vertex, or random ones.
pub(super) fn weights(draw: &mut Draw) -> [f64; 3] {
    let corner = draw.between(0, 5) as usize;
    if corner < 3 {
        return std::array::from_fn(|v| f64::from(u8::from(v == corner)));
    }
    let (a, b) = (draw.unit(), draw.unit());
    [a, (1.0 - a) * b, (1.0 - a) * (1.0 - b)]
}

/// Cosines between vertex normals and faces: those of flat faces or random ones.
pub(super) fn cone_cosines(draw: &mut Draw) -> [f64; 3] {
    match draw.between(0, 2) {
        0 => [1.0; 3],
        1 => [draw.within(-1.0, 1.0); 3],
        _ => [0, 1, 2].map(|_| draw.within(-0.2, 1.0)),
    }
}

/// A random span.
pub(super) fn span(draw: &mut Draw) -> RawSpan {
    let normals = normals(draw);
    let is_edge = happens(draw, 0.7);
    let whole = RawSpan::between([normals[0], normals[1]], length(draw), material(draw));
    RawSpan {
        normals,
        face: face(draw),
        positions: [0, 1, 2].map(|_| place(draw)),
        cone_cosines: cone_cosines(draw),
        start: if is_edge { whole.start } else { weights(draw) },
        end: if is_edge { whole.end } else { weights(draw) },
        ..whole
    }
}

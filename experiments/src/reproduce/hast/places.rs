//! Light vectors that are wrapped: around the axis S, or around the vector of the pixel before.
use glam::DVec3;
use specula_golden::exact::formula::point_light::{direction, scaled, wrapped};
use specula_golden::exact::formula::wrap::chained;
use specula_scene::{Frame, LocalLight, Span, Wrap, load, parse};

use super::super::angle::angle_between;
use super::super::claim::{Claim, Ruling, exact};

/// A wall of 65 pixels, four units wide, with a lamp a quarter unit before its middle (extremes row
/// 40).
const WALL: &str = "[[light]]\nkind = \"point\"\nposition = [0, 0, 0.25]\n\
                    [[span]]\nlength = 65\nnormals = [[0, 0, 1], [0, 0, 1]]\n\
                    positions = [[-2, 0, 0], [2, 0, 0], [0, 1, 0]]\n";

/// What the vector to a light is wrapped around.
#[derive(Clone, Copy)]
enum Axis {
    /// S: a spot's own axis, or the bisector of the span's ends.
    Fixed,
    /// The vector of the pixel before; at the first pixel the true one.
    Before,
}

/// L' at every pixel of a span.
fn vectors(axis: Axis, frame: &Frame, span: &Span, light: &LocalLight) -> Vec<DVec3> {
    let parameters = (0..span.length).map(|i| span.parameter(i));
    match axis {
        Axis::Fixed => {
            let wrap = Wrap::to_light(frame, span, light);
            parameters.map(|t| wrapped(wrap.axis, wrap.chord(t))).collect()
        }
        Axis::Before => {
            // A common factor for both ends turns no F - P between them; the vector before is near
            // it already, so that its length hardly counts.
            let [start, end] = scaled(frame.end_vectors_to(span, light.position));
            let ways = parameters.map(|t| start.lerp(end, t));
            chained(start.normalize_or_zero(), ways).collect()
        }
    }
}

/// The largest angle in degrees between L' and the direction to any light at a place.
fn most_off(axis: Axis, frame: &Frame) -> f64 {
    let of_span = |span: &Span, light: &LocalLight| {
        let vectors = vectors(axis, frame, span, light);
        let off = |(i, vector): (u32, DVec3)| {
            let point = frame.position_at(span, span.weights(i));
            direction(light.position, point).map_or(0.0, |truth| angle_between(vector, truth))
        };
        (0..).zip(vectors).map(off).fold(0.0, f64::max)
    };
    let lights = || frame.local_lights.iter();
    let all = frame.spans.iter().flat_map(|span| lights().map(move |light| of_span(span, light)));
    all.fold(0.0, f64::max).to_degrees()
}

/// Of the built-in scene with a lamp and a spot.
fn lamps(axis: Axis) -> f64 {
    load("lamps", Some((160, 120))).map_or(f64::NAN, |scene| most_off(axis, &scene.frame))
}

fn wall(axis: Axis) -> f64 {
    parse("wall.toml", WALL.to_owned()).map_or(f64::NAN, |scene| most_off(axis, &scene.frame))
}

const fn claim(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(
        "light vectors need no normalisation: wrapped around S, or the L' before (within half a degree)",
        quantity,
        expected,
        measure,
        |degrees| {
            Ruling::of(degrees < 0.5, "the chord turns otherwise than F - P does, near a light")
        },
    )
}

/// Claims about (36) and what takes the place of S.
pub const CLAIMS: [Claim; 4] = [
    claim("largest angle in degrees, lamps, around S", (0.0786, 5e-5), || lamps(Axis::Fixed)),
    claim("largest angle in degrees, lamps, around the L' before", (0.0217, 5e-5), || {
        lamps(Axis::Before)
    }),
    claim("largest angle in degrees, lamp at a wall, around S", (38.5, 5e-2), || wall(Axis::Fixed)),
    claim("largest angle in degrees, lamp at a wall, around the L' before", (36.3, 5e-2), || {
        wall(Axis::Before)
    }),
];

//! The needs of a frame: they determine which hardware is built and how wide it is, and whether an
//! existing core can shade the frame.
mod together;

use std::collections::BTreeSet;

use glam::DVec3;
use serde::{Deserialize, Serialize};

use crate::contributions::Contributions;
use crate::frame::{EYE, Frame, LocalLight, Material, Span, Triangle};
use crate::parallel::ParallelSpan;
use crate::wrap::Wrap;
use crate::{shortest_halfway, wrapped_places};

/// The needs of shading a frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Needs {
    /// Number of lights, including those at places.
    pub lights: usize,
    /// Lights at places, which come last.
    pub local_lights: Vec<LocalKind>,
    /// Which of them become weaker with distance, counted from 0.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub attenuated_lights: Vec<usize>,
    /// Whether the eye that sees highlights is at a place.
    pub local_eye: bool,
    /// Length of the longest span in pixels.
    pub longest_span: u32,
    /// Smallest exponent n of a material.
    pub smallest_shininess: u32,
    /// Largest exponent n of a material.
    pub largest_shininess: u32,
    /// A material whose exponent is no power of two, if there is one.
    pub uneven_shininess: Option<u32>,
    /// Number of materials of its spans, those that are alike counted once.
    pub materials: usize,
    /// Largest product of a material's and a light's (or the ambient light's) colour component; 1.0
    /// is full scale.
    pub brightest_coefficient: f64,
    /// The kinds of light that are reflected at all, and how strongly.
    pub contributions: Contributions,
    /// Whether every triangle has only one normal, its polygon's.
    pub flat: bool,
    /// Whether consistent normal interpolation would change any reflection: at some vertex, the
    /// normal differs from that of a face around it.
    pub consistent_normals_differ: bool,
    /// Widest angle between the normals at the two ends of a span, in degrees.
    pub widest_angle: f64,
    /// Length of the shortest interpolated normal, in units of the longer end normal of its span; 0
    /// to 1.
    pub shortest_normal: f64,
    /// Length of the shortest vector from a pixel to a light or an eye at a place, in units of the
    /// longer one at the ends of its span; 0 to 1, and 1 if there are none.
    pub shortest_way: f64,
    /// The same length for vectors that have length 1 at both ends of their span.
    pub shortest_unit_way: f64,
    /// Length of the shortest L + V of any light at any pixel, 0 to 2; 2 if nothing is at a place.
    pub shortest_halfway: f64,
    /// By how much colours are off at most, in LSBs from 0 to 255, where directions to lights and
    /// the eye at places are wrapped rather than true [Hast, Barrera and Bengtsson, eq. 36 to 38].
    pub most_off_by_wraps: f64,
    /// The smallest cosine between a vertex normal and a face around the vertex (extremes row
    /// 48): -1 to 1.
    pub least_cone_cosine: f64,
    /// The smallest cosine between an interpolated normal and the direction to the eye: -1 to 1.
    pub least_view_cosine: f64,
    /// The same where every pixel sees an eye at a place for itself.
    pub least_view_cosine_of_pixels: f64,
    /// Intervals of interpolated quantities at the ends of spans.
    pub ranges: Ranges,
}

/// A closed interval.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Interval {
    /// The smallest value.
    pub low: f64,
    /// The largest value.
    pub high: f64,
}

/// Intervals of interpolated quantities, over both ends of all spans; [0, 0] in a frame without
/// spans. Normals are scaled as by [`Frame::end_normals`].
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Ranges {
    /// Components of the normal.
    pub normal: [Interval; 3],
    /// Components of the change of the normal over a span.
    pub normal_delta: [Interval; 3],
    /// N·V for the eye at infinity.
    pub normal_dot_eye: Interval,
    /// N·L for each light at infinity.
    pub normal_dot_light: Vec<Interval>,
    /// 1/S.
    pub weight_step: Interval,
}

impl Interval {
    /// The smallest interval that contains all `values`; [0, 0] if there are none.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Interval {
        let points = values.into_iter().map(|x| Interval { low: x, high: x });
        points.reduce(Interval::hull).unwrap_or_default()
    }

    /// The smallest interval that contains both.
    pub fn hull(self, other: Interval) -> Interval {
        Interval { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
}

impl Ranges {
    fn of(frame: &Frame) -> Ranges {
        let ends: Vec<[DVec3; 2]> =
            frame.spans.iter().map(|span| frame.end_normals(span)).collect();
        let of = |value: &dyn Fn(DVec3) -> f64| {
            Interval::of(ends.iter().flatten().map(|&normal| value(normal)))
        };
        let axes = [0, 1, 2];
        Ranges {
            normal: axes.map(|axis| of(&|normal| normal[axis])),
            normal_delta: axes.map(|axis| Interval::of(ends.iter().map(|[a, b]| (*b - *a)[axis]))),
            normal_dot_eye: of(&|normal| normal.dot(EYE)),
            normal_dot_light: frame
                .lights
                .iter()
                .map(|light| of(&|normal| normal.dot(light.direction)))
                .collect(),
            weight_step: Interval::of(frame.spans.iter().map(Span::weight_step)),
        }
    }
}

/// The kind of a light at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum LocalKind {
    /// It shines in all directions alike.
    Point,
    /// It shines most strongly along its axis.
    Spot {
        /// Warn's exponent, 1 to 8191.
        exponent: u32,
    },
}

impl LocalKind {
    fn of(light: &LocalLight) -> LocalKind {
        light
            .spot
            .as_ref()
            .map_or(LocalKind::Point, |spot| LocalKind::Spot { exponent: spot.exponent })
    }
}

impl Needs {
    /// Computes the needs of a frame from all of its spans.
    pub fn of(frame: &Frame) -> Needs {
        let used = || frame.spans.iter().map(|span| frame.material(span));
        let shininess = || used().map(|m| m.shininess);
        Needs {
            lights: frame.lights.len() + frame.local_lights.len(),
            local_lights: frame.local_lights.iter().map(LocalKind::of).collect(),
            attenuated_lights: attenuated_lights(frame),
            local_eye: frame.eye.is_some(),
            longest_span: frame.spans.iter().map(|s| s.length).max().unwrap_or(1),
            smallest_shininess: shininess().min().unwrap_or(1),
            largest_shininess: shininess().max().unwrap_or(1),
            uneven_shininess: shininess().find(|n| !n.is_power_of_two()),
            materials: different(frame),
            brightest_coefficient: brightest_coefficient(frame),
            contributions: Contributions::of(frame),
            flat: seen(frame).all(is_flat),
            consistent_normals_differ: seen(frame)
                .flat_map(|triangle| triangle.cones)
                .any(|cone| cone.cosine < 1.0 - ROUNDING),
            widest_angle: frame
                .spans
                .iter()
                .flat_map(|s| ends(frame, s))
                .map(angle)
                .fold(0.0, f64::max),
            shortest_normal: frame
                .spans
                .iter()
                .flat_map(|s| ends(frame, s))
                .map(shortest)
                .fold(1.0, f64::min),
            least_cone_cosine: frame
                .triangles
                .iter()
                .flat_map(|t| t.cones)
                .map(|cone| cone.cosine)
                .fold(1.0, f64::min),
            least_view_cosine: least(frame, least_view_cosine_of),
            least_view_cosine_of_pixels: least(frame, least_view_cosine_of_pixels),
            shortest_way: ways(frame).map(shortest).fold(1.0, f64::min),
            shortest_unit_way: ways(frame)
                .map(|ends| shortest(Wrap::around(None, ends).ends))
                .fold(1.0, f64::min),
            shortest_halfway: shortest_halfway::of(frame),
            most_off_by_wraps: wrapped_places::most_off(frame),
            ranges: Ranges::of(frame),
        }
    }

    /// Whether lights or the eye are at places, so that pixels see them in different directions.
    pub fn has_places(&self) -> bool {
        self.local_eye || !self.local_lights.is_empty()
    }
}

fn attenuated_lights(frame: &Frame) -> Vec<usize> {
    let lights = frame.local_lights.iter().enumerate();
    lights.filter_map(|(index, light)| light.attenuation.map(|_| index)).collect()
}

/// By how much cosines of equal unit vectors may be below 1.
const ROUNDING: f64 = 1e-12;

/// By how much components of unit normals may differ that count as equal: 255 LSB times this is
/// .00024 LSB.
const FLAT: f64 = 1.0 / (1 << 20) as f64;

/// How many materials of a frame's spans differ from all others.
fn different(frame: &Frame) -> usize {
    let indices = frame.spans.iter().map(|span| frame.triangles[span.triangle].material);
    let indices: BTreeSet<usize> = indices.collect();
    let mut seen: Vec<&Material> = vec![];
    for material in indices.into_iter().map(|index| &frame.materials[index]) {
        if !seen.contains(&material) {
            seen.push(material);
        }
    }
    seen.len()
}

/// The triangles that spans show, one after the other.
fn seen(frame: &Frame) -> impl Iterator<Item = &Triangle> {
    frame.spans.iter().map(|span| &frame.triangles[span.triangle])
}

/// Whether a triangle's vertices have one normal, which is its polygon's.
///
/// Files state normals with few digits, so the polygon's own may differ by their rounding.
fn is_flat(triangle: &Triangle) -> bool {
    let [first, second, third] = triangle.normals;
    let of_polygon = (triangle.facet.normal - first).abs().max_element() <= FLAT;
    first == second && first == third && of_polygon
}

/// The vectors at the ends of a span that methods interpolate: its normals, and the axes of its
/// cones.
fn ends(frame: &Frame, span: &Span) -> [[DVec3; 2]; 2] {
    [frame.end_normals(span), frame.end_axes(span)]
}

fn brightest_coefficient(frame: &Frame) -> f64 {
    let mut brightest: f64 = 0.0;
    for material in &frame.materials {
        for channel in 0..3 {
            brightest = brightest.max(material.ambient[channel] * frame.ambient[channel]);
            for colour in frame.light_colours() {
                let reflectance = material.diffuse[channel].max(material.specular[channel]);
                brightest = brightest.max(reflectance * colour[channel]);
            }
        }
    }
    brightest
}

fn angle([a, b]: [DVec3; 2]) -> f64 {
    // atan2 keeps small angles that acos of a rounded dot product loses (extremes row 15).
    a.cross(b).length().atan2(a.dot(b)).to_degrees()
}

/// Vectors from the ends of every span to every light and eye at a place.
fn ways(frame: &Frame) -> impl Iterator<Item = [DVec3; 2]> {
    let places = || frame.local_lights.iter().map(|light| light.position).chain(frame.eye);
    frame.spans.iter().flat_map(move |span| places().map(|place| frame.end_vectors_to(span, place)))
}

/// The smallest |N| over the span, at the foot of the perpendicular from the origin to the segment
/// between the ends.
fn shortest([a, b]: [DVec3; 2]) -> f64 {
    let delta = b - a;
    let foot =
        if delta.length_squared() > 0.0 { -a.dot(delta) / delta.length_squared() } else { 0.0 };
    (a + delta * foot.clamp(0.0, 1.0)).length()
}

/// The smallest of a number of each span, 1 at most.
fn least(frame: &Frame, of: fn(&Frame, &Span) -> f64) -> f64 {
    frame.spans.iter().map(|span| of(frame, span)).fold(1.0, f64::min)
}

/// The smallest cosine of a span, as its middle sees an eye at a place.
fn least_view_cosine_of(frame: &Frame, span: &Span) -> f64 {
    if frame.eye.is_none() {
        return least_view_cosine(frame.end_axes(span));
    }
    let parallel = ParallelSpan::new(frame, span);
    least_view_cosine(parallel.frame.end_axes(parallel.span()))
}

/// The smallest cosine of a span, as its pixels see an eye at a place.
fn least_view_cosine_of_pixels(frame: &Frame, span: &Span) -> f64 {
    let [start, end] = frame.end_axes(span);
    if frame.eye.is_none() {
        return least_view_cosine([start, end]);
    }
    let at = |i: u32| {
        let axis = start.lerp(end, span.parameter(i)).try_normalize()?;
        Some(axis.dot(frame.view_from(frame.position_at(span, span.weights(i)))?))
    };
    (0..span.length).map(|i| at(i).unwrap_or(-1.0)).fold(1.0, f64::min)
}

/// The smallest cosine between the eye and the normals between two ends, -1 if one has no
/// direction.
///
/// With N = a + t d it is at an end or where the derivative of N·V/|N| vanishes, (d·V)(N·N) =
/// (N·V)(N·d), in which t² cancels: t = ((d·V)(a·a) - (a·V)(a·d)) / ((a·V)(d·d) - (d·V)(a·d)).
fn least_view_cosine([a, b]: [DVec3; 2]) -> f64 {
    let d = b - a;
    let (av, dv, ad) = (a.dot(EYE), d.dot(EYE), a.dot(d));
    let stationary = (dv * a.dot(a) - av * ad) / (av * d.dot(d) - dv * ad);
    let inside = if stationary.is_finite() { stationary.clamp(0.0, 1.0) } else { 0.0 };
    let cosine = |t: f64| (a + d * t).try_normalize().map_or(-1.0, |n| n.dot(EYE));
    [0.0, inside, 1.0].map(cosine).into_iter().fold(1.0, f64::min)
}

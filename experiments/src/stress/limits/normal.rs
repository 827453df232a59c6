//! How far the normal that a method takes at a pixel is from the interpolated one.
use glam::DVec3;
use specula_golden::exact::normalisation::gain;
use specula_golden::exact::slerp;
use specula_golden::exact::wrap;
use specula_scene::{Frame, Span, Wrap};
use specula_spec::lyon::{NormalWrap, Normals};
use specula_spec::{LyonSpec, ReflectionSpec, SlerpSpec};

use super::reason::Reason;

/// A normal that is not quite the interpolated one.
#[derive(Clone, Debug, PartialEq)]
pub struct Normal {
    /// Radians between the two; none where nothing is known of it.
    pub turn: Option<f64>,
    /// Its length.
    pub length: f64,
    /// Why.
    pub reasons: Vec<Reason>,
}

impl Normal {
    fn turned(turn: f64, reason: Reason) -> Normal {
        Normal { turn: Some(turn), length: 1.0, reasons: vec![reason] }
    }

    pub fn unknown(reason: Reason) -> Normal {
        Normal { turn: None, length: 1.0, reasons: vec![reason] }
    }
}

/// Radians between two vectors that have directions.
pub fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// Of a pixel of a span.
pub struct Pixel<'a> {
    pub frame: &'a Frame,
    pub span: &'a Span,
    pub i: u32,
    /// The interpolated normal, a unit vector.
    pub truth: DVec3,
    /// What has come of the pixels before, at each pixel: [`lags`] or [`roots`]; nothing where a
    /// method does not go by them.
    pub walked: &'a [f64],
}

/// Below so many radians opposite ends, and ends that are alike, have no plane between them.
const NO_ANGLE: f64 = 1e-6;

impl Pixel<'_> {
    fn t(&self) -> f64 {
        self.span.parameter(self.i)
    }

    /// What has come of the pixels before.
    pub fn walked(&self) -> f64 {
        self.walked.get(self.i as usize).copied().unwrap_or(0.0)
    }

    /// The chord between unit vectors at the ends.
    pub fn chord(&self) -> DVec3 {
        let [start, end] = self.frame.unit_end_normals(self.span);
        start.lerp(end, self.t())
    }

    /// As interpolated, of any length that is 1 at most.
    pub fn interpolated(&self) -> DVec3 {
        let [start, end] = self.frame.end_normals(self.span);
        start.lerp(end, self.t())
    }

    /// Of methods that interpolate between unit vectors and divide by the length.
    pub fn between_unit_ends(&self) -> Normal {
        Normal::turned(angle(self.chord(), self.truth), Reason::UnitEnds)
    }

    /// Of consistent normals, interpolated between the axes of cones.
    pub fn between_axes(&self) -> Normal {
        let [start, end] = self.frame.end_axes(self.span);
        Normal::turned(angle(start.lerp(end, self.t()), self.truth), Reason::Consistent)
    }

    /// Of methods that take the polygon's own normal for all of it.
    pub fn of_facet(&self) -> Normal {
        match self.frame.facet_normal(self.span) {
            DVec3::ZERO => Normal::unknown(Reason::Facet),
            facet => Normal::turned(angle(facet, self.truth), Reason::Facet),
        }
    }

    /// Of Lyon's.
    pub fn of_lyon(&self, lyon: &LyonSpec) -> Normal {
        match lyon.normals {
            Normals::Flat => self.of_facet(),
            Normals::Linear => {
                let square = self.interpolated().length_squared();
                Normal {
                    turn: Some(0.0),
                    length: gain(lyon, square) * square.sqrt(),
                    reasons: vec![Reason::Length],
                }
            }
            Normals::Wrapped => {
                let NormalWrap { wrap, follows } = lyon.wrap(self.frame, self.span);
                match follows {
                    true => Normal::turned(
                        self.walked()
                            + angle(wrap.ends[0].lerp(wrap.ends[1], self.t()), self.truth),
                        Reason::Chain,
                    ),
                    false => self.wrapped(wrap.ends, Some(wrap.axis)),
                }
            }
        }
    }

    /// Of reflection shading.
    pub fn of_reflection(&self, reflection: &ReflectionSpec) -> Normal {
        self.wrapped(
            self.frame.unit_end_normals(self.span),
            reflection.bisector.of(self.frame, self.span),
        )
    }

    fn wrapped(&self, ends: [DVec3; 2], axis: Option<DVec3>) -> Normal {
        let interpolated = ends[0].lerp(ends[1], self.t());
        match wrap_turn(interpolated, axis) {
            Some(turn) => Normal {
                turn: Some(turn + angle(interpolated, self.truth)),
                length: 1.0,
                reasons: vec![Reason::Wrap],
            },
            None => Normal::unknown(Reason::Wrap),
        }
    }

    /// Of slerp.
    pub fn of_slerp(&self, spec: &SlerpSpec) -> Normal {
        let (chord, course) = (self.chord(), spec.course(self.frame, self.span));
        let off = angle(chord, self.truth);
        if course.is_linear {
            let length = chord.length();
            return Normal {
                turn: Some(off),
                length: length * (3.0 - length * length) / 2.0,
                reasons: vec![Reason::Chord],
            };
        }
        let [start, end] = self.frame.unit_end_normals(self.span);
        let between = angle(start, end);
        if between > std::f64::consts::PI - NO_ANGLE {
            return Normal::unknown(Reason::Arc);
        }
        let of_arc = if between < NO_ANGLE {
            chord
        } else {
            let [a, b] = slerp::weights(between, self.t());
            a * start + b * end
        };
        Normal::turned(angle(of_arc, self.truth), Reason::Arc)
    }
}

/// Shorter than this, H has no direction that is worth having (extremes rows 7 and 9).
const SHORTEST_HALFWAY: f64 = 1e-2;

/// By how much a vector turns when it is wrapped around a unit vector; none where they all but
/// oppose each other, or there is no axis.
pub fn wrap_turn(vector: DVec3, axis: Option<DVec3>) -> Option<f64> {
    let axis =
        axis.filter(|axis| *axis != DVec3::ZERO && (*axis + vector).length() > SHORTEST_HALFWAY)?;
    Some(wrap::error(angle(axis, vector), vector.length()).abs())
}

/// How many radians each normal of a span lags behind what is interpolated if it is wrapped around
/// the one before: all lie in the plane of the ends.
pub fn lags(frame: &Frame, span: &Span, lyon: &LyonSpec) -> Vec<f64> {
    let NormalWrap { wrap: Wrap { ends: [start, end], .. }, follows } = lyon.wrap(frame, span);
    let (mut behind, mut before) = (0.0, start);
    let mut lag = |i: u32| {
        let interpolated = start.lerp(end, span.parameter(i));
        behind = wrap::error(angle(before, interpolated) + behind, interpolated.length());
        before = interpolated;
        f64::abs(behind)
    };
    if follows { (0..span.length).map(&mut lag).collect() } else { Vec::new() }
}

/// How much too long Newton's root is at each pixel, relative to |N|: as much as for the pixel
/// before, and e²/(2(1 + e)) after each of `steps`.
pub fn roots(frame: &Frame, span: &Span, steps: u32) -> Vec<f64> {
    let [start, end] = frame.unit_end_normals(span);
    let length = |i: u32| start.lerp(end, span.parameter(i)).length().max(f64::EPSILON);
    let after = |e: &mut f64, i: u32| {
        let guessed = (1.0 + *e) * length(i - 1) / length(i) - 1.0;
        *e = (0..steps).fold(guessed, |e, _| e * e / (2.0 * (1.0 + e)));
        Some(*e)
    };
    std::iter::once(0.0).chain((1..span.length).scan(0.0, after)).collect()
}

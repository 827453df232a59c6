//! The difference between the normal that a method uses at a pixel and the interpolated one.
use glam::DVec3;
use specula_golden::exact::formula::normalisation::gain;
use specula_golden::exact::formula::slerp;
use specula_golden::exact::formula::wrap;
use specula_scene::{Arc, Frame, Span, Wrap};
use specula_spec::lyon::{NormalWrap, Normals};
use specula_spec::{LyonSpec, ReflectionSpec, SlerpSpec};

use super::reason::Reason;

/// A normal that differs from the interpolated one.
#[derive(Clone, Debug, PartialEq)]
pub struct Normal {
    /// The angle between the two in radians; `None` if nothing is known about it.
    pub turn: Option<f64>,
    /// Its length.
    pub length: f64,
    /// The reasons for the difference.
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

/// The angle in radians between two vectors that have directions.
pub fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}

/// A pixel of a span.
pub struct Pixel<'a> {
    pub frame: &'a Frame,
    pub span: &'a Span,
    pub i: u32,
    /// The interpolated normal, a unit vector.
    pub truth: DVec3,
    /// Accumulated quantities at each pixel: [`lags`] or [`roots`]; empty if the method does not
    /// depend on the previous pixel.
    pub accumulated: &'a [f64],
}

/// If the ends are this close, in radians, to being equal or opposite, there is no plane between
/// them.
const NO_ANGLE: f64 = 1e-6;

impl Pixel<'_> {
    fn t(&self) -> f64 {
        self.span.parameter(self.i)
    }

    /// The accumulated quantity at this pixel.
    pub fn accumulated(&self) -> f64 {
        self.accumulated.get(self.i as usize).copied().unwrap_or(0.0)
    }

    /// The chord between unit vectors at the ends.
    pub fn chord(&self) -> DVec3 {
        let [start, end] = self.frame.unit_end_normals(self.span);
        start.lerp(end, self.t())
    }

    /// The interpolated normal, with its length, which is at most 1.
    pub fn interpolated(&self) -> DVec3 {
        let [start, end] = self.frame.end_normals(self.span);
        start.lerp(end, self.t())
    }

    /// The normal of methods that interpolate between unit vectors and divide by the length.
    pub fn between_unit_ends(&self) -> Normal {
        Normal::turned(angle(self.chord(), self.truth), Reason::UnitEnds)
    }

    /// The normal of consistent normals, interpolated between the axes of cones.
    pub fn between_axes(&self) -> Normal {
        let [start, end] = self.frame.end_axes(self.span);
        Normal::turned(angle(start.lerp(end, self.t()), self.truth), Reason::Consistent)
    }

    /// The normal of methods that use the polygon's own normal everywhere on it.
    pub fn of_facet(&self) -> Normal {
        match self.frame.facet_normal(self.span) {
            DVec3::ZERO => Normal::unknown(Reason::Facet),
            facet => Normal::turned(angle(facet, self.truth), Reason::Facet),
        }
    }

    /// Lyon's normal.
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
                if follows {
                    Normal::turned(
                        self.accumulated()
                            + angle(wrap.ends[0].lerp(wrap.ends[1], self.t()), self.truth),
                        Reason::Chain,
                    )
                } else {
                    self.wrapped(wrap.ends, Some(wrap.axis))
                }
            }
        }
    }

    /// The normal of reflection shading.
    pub fn of_reflection(&self, reflection: &ReflectionSpec) -> Normal {
        self.wrapped(
            self.frame.unit_end_normals(self.span),
            reflection.bisector.fixed_normal(self.frame, self.span),
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

    /// The normal of slerp.
    pub fn of_slerp(&self, spec: &SlerpSpec) -> Normal {
        let rotation = spec.arc_rotation(self.frame, self.span);
        let Arc { start, end, .. } = spec.arc(self.frame, self.span);
        let chord = start.lerp(end, self.t());
        let off = angle(chord, self.truth);
        if rotation.is_linear {
            let length = chord.length();
            return Normal {
                turn: Some(off),
                length: length * (3.0 - length * length) / 2.0,
                reasons: vec![Reason::Chord],
            };
        }
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

/// If H is shorter than this, its direction is useless (extremes rows 7 and 9).
const SHORTEST_HALFWAY: f64 = 1e-2;

/// The angle by which a vector turns when it is wrapped around a unit vector; `None` if they are
/// almost opposite, or if there is no axis.
pub fn wrap_turn(vector: DVec3, axis: Option<DVec3>) -> Option<f64> {
    let axis =
        axis.filter(|axis| *axis != DVec3::ZERO && (*axis + vector).length() > SHORTEST_HALFWAY)?;
    Some(wrap::error(angle(axis, vector), vector.length()).abs())
}

/// The lag in radians of each normal of a span behind the interpolated one, if it is wrapped around
/// the previous one: all lie in the plane of the ends.
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

/// The relative excess of Newton's root over |N| at each pixel: it starts with the excess of the
/// previous pixel, e, which each of `steps` steps turns into e²/(2(1 + e)).
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

//! Which weights the ends of a span get, and how they turn from pixel to pixel [lecture, eq. 4.7 to
//! 4.12; methods A8 to A11].
use glam::DVec3;
use specula_scene::frame::{Frame, Span};

use super::{Basis, Form, SlerpSpec};

/// Below so many degrees interpolation is linear: off by 0.0049 degrees at most (extremes rows 13
/// and 15).
const NARROW: f64 = 10.0;
/// From so many degrees on the frame is orthonormal: sin f would enlarge every error by as much as
/// below 10 (row 14).
const WIDE: f64 = 170.0;

/// 1/sin 10° = 1/sin 170°: no weight between the ends, nor its cosine, is larger.
pub const LARGEST_WEIGHT: f64 = 5.758_770_483_143_634;

/// How the normal goes from the first pixel to the last: N = u P + v Q with u and v of two
/// rotations,
///
/// - v from 0 on: v ← v cos δ + v' sin δ, v' ← v' cos δ - v b,
/// - u from 1 on: u ← u cos δ - u' sin δ, u' ← u' cos δ + u b,
///
/// where b is sin δ too on an arc, and 0 on a chord, which makes u = 1 - t and v = t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcRotation {
    /// P and Q.
    pub axes: [DVec3; 2],
    /// cos δ, sin δ and b.
    pub turn: [f64; 3],
    /// v' at the first pixel.
    pub rising_cosine: f64,
    /// u' at the first pixel.
    pub falling_cosine: f64,
    /// Whether it is the chord, on which N is shorter than 1.
    pub is_linear: bool,
}

impl SlerpSpec {
    /// Whether a normal is put together from the ends themselves.
    pub fn between_ends(&self) -> bool {
        self.form == Form::Vector && self.frame == Basis::Ends
    }

    /// How the normal goes along a span.
    pub fn arc_rotation(&self, frame: &Frame, span: &Span) -> ArcRotation {
        let arc = self.arc(frame, span);
        let step = arc.angle * span.weight_step();
        let (sine, cosine) = (libm::sin(step), libm::cos(step));
        if !self.between_ends() || arc.angle >= WIDE.to_radians() {
            let axes = [arc.start, arc.across];
            return ArcRotation {
                axes,
                turn: [cosine, sine, sine],
                rising_cosine: 1.0,
                falling_cosine: 0.0,
                is_linear: false,
            };
        }
        let axes = [arc.start, arc.end];
        if arc.angle < NARROW.to_radians() {
            let turn = [1.0, span.weight_step(), 0.0];
            return ArcRotation {
                axes,
                turn,
                rising_cosine: 1.0,
                falling_cosine: 1.0,
                is_linear: true,
            };
        }
        let sine_of_all = libm::sin(arc.angle);
        ArcRotation {
            axes,
            turn: [cosine, sine, sine],
            rising_cosine: 1.0 / sine_of_all,
            falling_cosine: libm::cos(arc.angle) / sine_of_all,
            is_linear: false,
        }
    }
}

//! p and q of a scan line as functions of t, without an accumulator [numerics N3b].
use glam::DVec3;

/// κ = |N1 - N0|², the only vector computation for a span's q.
pub fn kappa(ends: [DVec3; 2]) -> f64 {
    ends[0].distance_squared(ends[1])
}

/// q = N·N = (1-t) q0 + t q1 - κ t(1-t), which is 1 - κ t(1-t) between unit normals.
///
/// It is clamped to 0, since rounding could make it negative where it vanishes.
pub fn length_squared(end_squares: [f64; 2], kappa: f64, t: f64) -> f64 {
    (interpolated(end_squares, t) - kappa * t * (1.0 - t)).max(0.0)
}

/// p = N·L or N·V, interpolated between its values at the ends.
pub fn interpolated(ends: [f64; 2], t: f64) -> f64 {
    ends[0] + t * (ends[1] - ends[0])
}

//! Angles between vectors.
use glam::DVec3;

/// The angle between two vectors that have directions, in radians: 0 to pi, the same on every machine.
pub fn angle_between(a: DVec3, b: DVec3) -> f64 {
    libm::atan2(a.cross(b).length(), a.dot(b))
}

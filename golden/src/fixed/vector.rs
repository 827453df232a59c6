//! Vectors of exact numbers.
use super::number::Wide;

/// x, y and z.
pub type Vector = [Wide; 3];

/// Names of the components.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// a·b.
pub fn dot(a: &Vector, b: &Vector) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b.
pub fn cross(a: &Vector, b: &Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

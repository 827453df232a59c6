//! Vectors of exact numbers.
use super::number::{Wide, truncate_to};

/// x, y and z.
pub type Vector = [Wide; 3];

/// Names of the components.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// a·b.
pub fn dot(a: &Vector, b: &Vector) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a·b of products that are truncated to `fraction_bits` before they are added.
pub fn truncated_dot(a: &Vector, b: &Vector, fraction_bits: u32) -> Wide {
    let product = |c: usize| truncate_to(a[c] * b[c], fraction_bits);
    product(0) + product(1) + product(2)
}

/// a × b of products that are truncated to `fraction_bits` before they are subtracted.
pub fn truncated_cross(a: &Vector, b: &Vector, fraction_bits: u32) -> Vector {
    let product = |i: usize, j: usize| truncate_to(a[i] * b[j], fraction_bits);
    let component = |i: usize, j: usize| product(i, j) - product(j, i);
    [component(1, 2), component(2, 0), component(0, 1)]
}

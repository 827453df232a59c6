//! Vectors of three components.
use std::ops::{Add, Sub};

use super::Sig;

/// A vector in view space.
#[derive(Clone)]
pub struct Vector {
    /// To the right.
    pub x: Sig,
    /// Up.
    pub y: Sig,
    /// Towards the eye.
    pub z: Sig,
}

impl Vector {
    /// A vector from its components.
    pub fn new([x, y, z]: [Sig; 3]) -> Vector {
        Vector { x, y, z }
    }

    /// Applies `f` to each component.
    pub fn map(&self, f: impl Fn(&Sig) -> Sig) -> Vector {
        Vector { x: f(&self.x), y: f(&self.y), z: f(&self.z) }
    }

    /// Gives the components names, unless they have some.
    pub fn named(self, name: &str) -> Vector {
        let component = |sig: Sig, axis: &str| sig.named(&format!("{name}_{axis}"));
        Vector { x: component(self.x, "x"), y: component(self.y, "y"), z: component(self.z, "z") }
    }

    /// The dot product.
    pub fn dot(&self, other: &Vector) -> Sig {
        &self.x * &other.x + &self.y * &other.y + &self.z * &other.z
    }

    /// The squared length.
    pub fn length_squared(&self) -> Sig {
        self.x.squared() + self.y.squared() + self.z.squared()
    }

    /// The dot product of vectors no longer than `lengths`, by `fact` no larger than their product.
    ///
    /// With components off by e it is off by √3 (|a| e_b + |b| e_a) + 3 e_a e_b (Cauchy and Schwarz).
    pub fn dot_within(&self, other: &Vector, lengths: (f64, f64), fact: &str) -> Sig {
        let limit = lengths.0 * lengths.1;
        let error = product_error(lengths, (self.largest_error(), other.largest_error()));
        self.dot(other).assumed(-limit, limit, fact).proven_error_value(error)
    }

    /// The squared length of a vector that by `fact` is no longer than `length`; its error as that of a dot product.
    pub fn length_squared_within(&self, length: f64, fact: &str) -> Sig {
        let error = product_error((length, length), (self.largest_error(), self.largest_error()));
        self.length_squared().assumed(0.0, length * length, fact).proven_error_value(error)
    }

    fn largest_error(&self) -> f64 {
        [&self.x, &self.y, &self.z].map(Sig::error_value).into_iter().fold(0.0, f64::max)
    }

    /// Each component times `factor`.
    pub fn scaled(&self, factor: &Sig) -> Vector {
        self.map(|component| component * factor)
    }

    /// The cross product.
    pub fn cross(&self, other: &Vector) -> Vector {
        Vector {
            x: &self.y * &other.z - &self.z * &other.y,
            y: &self.z * &other.x - &self.x * &other.z,
            z: &self.x * &other.y - &self.y * &other.x,
        }
    }

    /// Each component rounded to `fraction_bits`.
    pub fn rounded(&self, fraction_bits: u32) -> Vector {
        self.map(|component| component.rounded(fraction_bits))
    }

    /// States that the vector is no longer than `length`, so that each component lies within it.
    pub fn assumed_within(&self, length: f64, fact: &str) -> Vector {
        self.map(|component| component.assumed(-length, length, fact))
    }
}

fn product_error((a, b): (f64, f64), (error_a, error_b): (f64, f64)) -> f64 {
    3f64.sqrt() * (a * error_b + b * error_a) + 3.0 * error_a * error_b
}

impl Add for &Vector {
    type Output = Vector;
    fn add(self, other: &Vector) -> Vector {
        Vector { x: &self.x + &other.x, y: &self.y + &other.y, z: &self.z + &other.z }
    }
}

impl Sub for &Vector {
    type Output = Vector;
    fn sub(self, other: &Vector) -> Vector {
        Vector { x: &self.x - &other.x, y: &self.y - &other.y, z: &self.z - &other.z }
    }
}

impl Sub<&Vector> for Vector {
    type Output = Vector;
    fn sub(self, other: &Vector) -> Vector {
        &self - other
    }
}

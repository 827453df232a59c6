//! Vectors of three components.
use std::ops::{Add, Sub};

use super::Sig;
use crate::bound::VectorError;
use crate::format::power_of_two;

/// A vector in view space.
#[derive(Clone)]
#[must_use = "a vector that nothing reads is left out of the design"]
pub struct Vector {
    /// To the right.
    pub x: Sig,
    /// Up.
    pub y: Sig,
    /// Towards the eye.
    pub z: Sig,
    /// What has been stated of its length; infinite where nothing has.
    pub(super) longest: f64,
    /// What has been stated of its error.
    pub(super) off: VectorError,
}

impl Vector {
    /// A vector from its components.
    pub fn new([x, y, z]: [Sig; 3]) -> Vector {
        Vector { x, y, z, longest: f64::INFINITY, off: VectorError::UNKNOWN }
    }

    /// States how far the vector is off as a whole. The unit gives the proof above it.
    pub fn proven_off(self, off: VectorError) -> Vector {
        Vector { off, ..self }
    }

    /// States how far the vector is off as a whole, and so each component at most. The unit gives
    /// the proof above it.
    pub fn known_off(self, off: VectorError) -> Vector {
        self.map(|component| component.clone().stated_error_value(off.length))
            .no_longer_than(self.longest)
            .proven_off(off)
    }

    /// As [`Vector::known_off`], where propagation may know more of components.
    pub fn proven_off_by(self, length: f64) -> Vector {
        self.proven_error_value(length).proven_off(VectorError::ball(length))
    }

    /// How far it is off as a whole: what has been stated of it, or the diagonal of the components'
    /// errors.
    pub fn off(&self) -> VectorError {
        let diagonal = [&self.x, &self.y, &self.z]
            .map(|sig| sig.error_value().powi(2))
            .into_iter()
            .sum::<f64>()
            .sqrt();
        self.off.intersection(VectorError::ball(diagonal))
    }

    /// Applies `f` to each component.
    pub fn map(&self, f: impl Fn(&Sig) -> Sig) -> Vector {
        Vector::new([&self.x, &self.y, &self.z].map(f))
    }

    /// States that the vector is no longer than `length`. Components keep their ranges.
    pub fn no_longer_than(self, length: f64) -> Vector {
        Vector { longest: self.longest.min(length), ..self }
    }

    /// The length that it does not exceed: what has been stated of it, or the diagonal of the
    /// components' ranges.
    pub fn longest(&self) -> f64 {
        let reach = |sig: &Sig| sig.range().magnitude() * sig.ulp();
        let diagonal = [&self.x, &self.y, &self.z]
            .map(|sig| reach(sig).powi(2))
            .into_iter()
            .sum::<f64>()
            .sqrt();
        self.longest.min(diagonal)
    }

    /// Gives the components names, unless they have some.
    pub fn named(self, name: &str) -> Vector {
        let component = |sig: Sig, axis: &str| sig.named(&format!("{name}_{axis}"));
        Vector {
            x: component(self.x, "x"),
            y: component(self.y, "y"),
            z: component(self.z, "z"),
            ..self
        }
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
    /// With vectors off by e_a and e_b it is off by |a| e_b + |b| e_a + e_a e_b (Cauchy and
    /// Schwarz).
    pub fn dot_within(&self, other: &Vector, lengths: (f64, f64), fact: &str) -> Sig {
        let limit = lengths.0 * lengths.1;
        let error = product_error(lengths, (self.off().length, other.off().length));
        self.dot(other).assumed(-limit, limit, fact).proven_error_value(error)
    }

    /// The squared length of a vector that by `fact` is no longer than `length`; its error as that
    /// of a dot product.
    pub fn length_squared_within(&self, length: f64, fact: &str) -> Sig {
        let off = self.off().length;
        let error = product_error((length, length), (off, off));
        self.length_squared().assumed(0.0, length * length, fact).proven_error_value(error)
    }

    /// The largest bound on the error of a component, as a value.
    pub fn largest_error(&self) -> f64 {
        [&self.x, &self.y, &self.z].map(Sig::error_value).into_iter().fold(0.0, f64::max)
    }

    /// Each component times `factor`.
    pub fn scaled(&self, factor: &Sig) -> Vector {
        self.map(|component| component * factor)
    }

    /// `yes` where the bit is 1, else `no`; what has been stated of both is true of either.
    pub fn choose(bit: &Sig, yes: &Vector, no: &Vector) -> Vector {
        let [a, b] = [yes.off(), no.off()];
        let off = VectorError {
            length: a.length.max(b.length),
            transverse: a.transverse.max(b.transverse),
            radial: a.radial.max(b.radial),
            isotropic: a.isotropic.min(b.isotropic),
        };
        let component = |yes: &Sig, no: &Sig| bit.choose(yes, no);
        let chosen = Vector::new([
            component(&yes.x, &no.x),
            component(&yes.y, &no.y),
            component(&yes.z, &no.z),
        ]);
        chosen.no_longer_than(yes.longest().max(no.longest())).proven_off(off)
    }

    /// The cross product.
    pub fn cross(&self, other: &Vector) -> Vector {
        Vector::new([
            &self.y * &other.z - &self.z * &other.y,
            &self.z * &other.x - &self.x * &other.z,
            &self.x * &other.y - &self.y * &other.x,
        ])
    }

    /// Each component rounded to `fraction_bits`, which moves the vector by √3/2 units of the last
    /// place at most.
    pub fn rounded(&self, fraction_bits: u32) -> Vector {
        let moved =
            if [&self.x, &self.y, &self.z].iter().any(|sig| sig.fraction_bits() > fraction_bits) {
                0.75f64.sqrt() * power_of_two(-i64::from(fraction_bits))
            } else {
                0.0
            };
        let rounded = self
            .map(|component| component.rounded(fraction_bits))
            .no_longer_than(self.longest + moved);
        rounded.proven_off(self.off().enlarged_by(moved))
    }

    /// States that the vector is no longer than `length`, so that each component lies within it.
    pub fn assumed_within(&self, length: f64, fact: &str) -> Vector {
        self.components_assumed_within(length, fact).no_longer_than(length)
    }

    /// States that each component lies from -`limit` to `limit`.
    pub fn components_assumed_within(&self, limit: f64, fact: &str) -> Vector {
        self.map(|component| component.assumed(-limit, limit, fact))
            .no_longer_than(self.longest)
            .proven_off(self.off)
    }

    /// States a bound on the error of each component, as [`Sig::proven_error_value`] does.
    pub fn proven_error_value(self, error: f64) -> Vector {
        self.map(|component| component.clone().proven_error_value(error))
            .no_longer_than(self.longest)
            .proven_off(self.off)
    }
}

fn product_error((a, b): (f64, f64), (error_a, error_b): (f64, f64)) -> f64 {
    a * error_b + b * error_a + error_a * error_b
}

impl Add for &Vector {
    type Output = Vector;
    fn add(self, other: &Vector) -> Vector {
        Vector::new([&self.x + &other.x, &self.y + &other.y, &self.z + &other.z])
    }
}

impl Sub for &Vector {
    type Output = Vector;
    fn sub(self, other: &Vector) -> Vector {
        Vector::new([&self.x - &other.x, &self.y - &other.y, &self.z - &other.z])
    }
}

impl Sub<&Vector> for Vector {
    type Output = Vector;
    fn sub(self, other: &Vector) -> Vector {
        &self - other
    }
}

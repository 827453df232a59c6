//! Vectors of three components.
use std::ops::{Add, Sub};

use super::Sig;
use super::turns::{Products, ThreeProducts};
use crate::bound::{VectorBound, VectorError};
use crate::graph::{Rule, VectorId, VectorRule};

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
    /// What is known of it as a whole.
    real: VectorId,
}

/// More fraction bits than any product has.
const WHOLE: u32 = u32::MAX;

impl Vector {
    /// A vector from its components.
    pub fn new(components: [Sig; 3]) -> Vector {
        Vector::by_rule(components, VectorRule::Components)
    }

    fn by_rule([x, y, z]: [Sig; 3], rule: VectorRule) -> Vector {
        let components = [&x, &y, &z].map(Sig::real);
        let real = x.builder.state.borrow_mut().vector(components, rule);
        Vector { x, y, z, real }
    }

    /// The same vector with what a rule says besides.
    fn known_by(self, rule: impl FnOnce(VectorId) -> VectorRule) -> Vector {
        let Vector { x, y, z, real } = self;
        Vector::by_rule([x, y, z], rule(real))
    }

    /// The same vector, for whose components others stand.
    pub(super) fn at(&self, components: [Sig; 3]) -> Vector {
        Vector::by_rule(components, VectorRule::Same(self.real))
    }

    fn components(&self) -> [&Sig; 3] {
        [&self.x, &self.y, &self.z]
    }

    /// What is known of it as a whole: what a proof is about.
    pub fn bound(&self) -> VectorBound {
        let state = self.x.builder.state.borrow();
        state.bounds.of_vector(&state.graph, self.real)
    }

    /// States a bound on the error of the vector as a whole, and so of each component, where that
    /// is smaller than what rules say. `proof` is where it stands.
    pub fn tighten_error(self, proof: &'static str, error: VectorError) -> Vector {
        let tightened = |component: &Sig| component.clone().tighten_error(proof, error.length);
        let of = self.real;
        Vector::by_rule(self.components().map(tightened), VectorRule::Proven { of, error, proof })
    }

    /// States the bound on the error of the vector as a whole, and so of each component, where rules
    /// see nothing of it. `proof` is where it stands.
    pub fn override_error(self, proof: &'static str, error: VectorError) -> Vector {
        let overridden = |component: &Sig| component.clone().override_error(proof, error.length);
        let of = self.real;
        Vector::by_rule(self.components().map(overridden), VectorRule::Proven { of, error, proof })
    }

    /// States a bound on the error of each component, as [`Sig::tighten_error`] does.
    pub fn tighten_components(self, proof: &'static str, error: f64) -> Vector {
        self.at(self.components().map(|component| component.clone().tighten_error(proof, error)))
    }

    /// States that the fixed vector is no longer than `length`. Components keep their ranges.
    pub fn no_longer_than(self, length: f64) -> Vector {
        self.known_by(|real| VectorRule::NoLonger(real, length))
    }

    /// States that the real vector is no shorter than `length`, by a fact that rules cannot see.
    pub fn no_shorter_than(self, length: f64, fact: &str) -> Vector {
        self.known_by(|of| VectorRule::NoShorter { of, length, fact: fact.to_owned() })
    }

    /// The length that the fixed vector does not exceed: what has been stated of it, or the diagonal
    /// of the components' ranges.
    pub fn longest(&self) -> f64 {
        self.bound().longest
    }

    /// Applies `f` to each component.
    pub fn map(&self, f: impl Fn(&Sig) -> Sig) -> Vector {
        Vector::new(self.components().map(f))
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
        self.truncated_dot(other, WHOLE).0
    }

    /// The squared length.
    pub fn length_squared(&self) -> Sig {
        self.truncated_length_squared(WHOLE).0
    }

    /// The dot product of vectors no longer than `lengths`, by `fact` no larger than their product.
    ///
    /// With vectors off by e_a and e_b it is off by |a| e_b + |b| e_a + e_a e_b (Cauchy and
    /// Schwarz).
    pub fn dot_within(&self, other: &Vector, lengths: (f64, f64), fact: &str) -> Sig {
        self.truncated_dot_within(other, WHOLE, lengths, fact)
    }

    /// The same of products that are truncated to `fraction_bits` before they are added, each of which
    /// makes it smaller by less than a unit of their last place.
    pub fn truncated_dot_within(
        &self,
        other: &Vector,
        fraction_bits: u32,
        lengths: (f64, f64),
        fact: &str,
    ) -> Sig {
        let (sum, truncated) = self.truncated_dot(other, fraction_bits);
        let (limit, lengths) = (lengths.0 * lengths.1, [lengths.0, lengths.1]);
        let of = sum.assumed(-limit - truncated, limit, fact);
        let vectors = [self.real, other.real];
        of.standing_for(of.id(), Rule::DotProduct { of: of.real(), vectors, lengths, truncated })
    }

    /// The squared length of a vector that by `fact` is no longer than `length`; its error as that
    /// of a dot product.
    pub fn length_squared_within(&self, length: f64, fact: &str) -> Sig {
        self.truncated_length_squared_within(WHOLE, length, fact)
    }

    /// The same of squares that are truncated to `fraction_bits` before they are added.
    pub fn truncated_length_squared_within(
        &self,
        fraction_bits: u32,
        length: f64,
        fact: &str,
    ) -> Sig {
        let (sum, truncated) = self.truncated_length_squared(fraction_bits);
        let of = sum.assumed(0.0, length * length, fact);
        let (vectors, lengths) = ([self.real; 2], [length; 2]);
        of.standing_for(of.id(), Rule::DotProduct { of: of.real(), vectors, lengths, truncated })
    }

    fn truncated_dot(&self, other: &Vector, fraction_bits: u32) -> (Sig, f64) {
        let pairs = std::array::from_fn(|k| [self.components()[k], other.components()[k]]);
        truncated_sum(fraction_bits, &Products::Mixed.of(pairs))
    }

    fn truncated_length_squared(&self, fraction_bits: u32) -> (Sig, f64) {
        let pairs = self.components().map(|component| [component, component]);
        truncated_sum(fraction_bits, &Products::Squares.of(pairs))
    }

    /// Each component times `factor`.
    pub fn scaled(&self, factor: &Sig) -> Vector {
        let products = Products::Mixed.of(self.components().map(|component| [component, factor]));
        Vector::new([0, 1, 2].map(|k| products.get(k)))
    }

    /// `yes` where the bit is 1, else `no`; what has been stated of both is true of either.
    pub fn choose(bit: &Sig, yes: &Vector, no: &Vector) -> Vector {
        let chosen = [(&yes.x, &no.x), (&yes.y, &no.y), (&yes.z, &no.z)]
            .map(|(yes, no)| bit.choose(yes, no));
        Vector::by_rule(chosen, VectorRule::Choice(yes.real, no.real))
    }

    /// The cross product of products that are truncated to `fraction_bits` before they are subtracted:
    /// each component is off by less than a unit of their last place.
    pub fn truncated_cross(&self, other: &Vector, fraction_bits: u32) -> Vector {
        let [a, b] = [self, other];
        let pairs = [[&a.y, &b.z], [&a.z, &b.x], [&a.x, &b.y]];
        let less = [[&a.z, &b.y], [&a.x, &b.z], [&a.y, &b.x]];
        let [products, less] = [pairs, less].map(|pairs| Products::Mixed.of(pairs));
        Vector::new([0, 1, 2].map(|k| {
            let product = products.get(k).truncated(fraction_bits);
            product - less.get(k).truncated(fraction_bits)
        }))
    }

    /// Each component rounded to `fraction_bits`.
    pub fn rounded(&self, fraction_bits: u32) -> Vector {
        let rounded = self.components().map(|component| component.rounded(fraction_bits));
        Vector::by_rule(rounded, VectorRule::Rounded(self.real))
    }

    /// States that the vector is no longer than `length`, so that each component lies within it.
    pub fn assumed_within(&self, length: f64, fact: &str) -> Vector {
        self.components_assumed_within(length, fact).no_longer_than(length)
    }

    /// States that each component lies from -`limit` to `limit`.
    pub fn components_assumed_within(&self, limit: f64, fact: &str) -> Vector {
        self.at(self.components().map(|component| component.assumed(-limit, limit, fact)))
    }
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

/// The sum of three products, each truncated before it is added, and by how much that makes it
/// smaller, at most.
fn truncated_sum(fraction_bits: u32, products: &ThreeProducts) -> (Sig, f64) {
    let mut lost = 0.0;
    let mut truncated = |k| {
        let whole = products.get(k);
        let short = whole.truncated(fraction_bits);
        if short.fraction_bits() < whole.fraction_bits() {
            lost += short.ulp();
        }
        short
    };
    let sum = truncated(0) + truncated(1) + truncated(2);
    (sum, lost)
}

//! What values stand for: the real values of the formula, and how they depend on each other.
//!
//! Values whose raw values are the same are one value in the hardware, whatever they stand for: a
//! constant 0 that the host rounded is another real value than the 0 of a formula. So what is known
//! of errors belongs to the real value, not to the signal (decision 0016), and a pass computes it
//! from the rules here (decision 0022).
use crate::bound::{ErrorBound, Interval, VectorError};
use crate::design::NodeId;

/// A [`RealValue`] of a graph, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RealId(pub u32);

/// A [`RealVector`] of a graph, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VectorId(pub u32);

/// A real value of the formula, and the value of the graph that stands for it.
#[derive(Clone, Debug, PartialEq)]
pub struct RealValue {
    /// The value that stands for it.
    pub value: NodeId,
    /// Where that value's binary point is seen here; doubling and halving move it.
    pub fraction_bits: u32,
    /// What the real value is, and what rounds on the way to it. Other real values that it depends
    /// on have smaller numbers.
    pub rule: Rule,
}

/// What a real value is, and how far from it a fixed-point one may be. Errors and limits are
/// values, not units in the last place.
#[derive(Clone, Debug, PartialEq)]
pub enum Rule {
    /// A constant of the formula, or a bit that a comparison gives.
    Exact,
    /// An input, off by what the host rounds; `real` is where it lies.
    Input {
        /// Bound on what the host rounds by.
        error: f64,
        /// Where the real value lies.
        real: Interval,
    },
    /// An entry of a table, each of which is off by so much.
    Table {
        /// Bound on the error of an entry.
        error: f64,
    },
    /// The other real value: in another unit, at another clock, or in a range that is stated.
    Same(RealId),
    /// The other real value times 2^k.
    Scaled(RealId, i32),
    /// A sum.
    Sum(RealId, RealId),
    /// A difference.
    Difference(RealId, RealId),
    /// A product.
    Product(RealId, RealId),
    /// A square.
    Square(RealId),
    /// The other real value, rounded to nearest here.
    Rounded(RealId),
    /// The other real value, rounded down here.
    Truncated(RealId),
    /// What a multiple of a power of two leaves of the other one.
    Remainder(RealId),
    /// The other real value, or the limit where it is smaller.
    ClampedBelow(RealId, f64),
    /// The other real value, or the limit where it is larger.
    ClampedAbove(RealId, f64),
    /// The other real value without its sign.
    Absolute(RealId),
    /// One or the other real value: fixed-point and real choice are the same, or they meet.
    Choice(RealId, RealId),
    /// Any of these real values, for all of which the same value stands.
    AnyOf(Vec<RealId>),
    /// A real value that begins as `start` and grows by `step`, `steps` times at most.
    Accumulated {
        /// What it begins as.
        start: RealId,
        /// What it grows by.
        step: RealId,
        /// How often at most.
        steps: u32,
    },
    /// A value that goes round a loop, off by so much at most as an invariant of the loop.
    LoopInvariant {
        /// Bound on the error at every step.
        error: f64,
    },
    /// The product of two vectors whose lengths are known, by Cauchy and Schwarz off by
    /// |a| e_b + |b| e_a + e_a e_b, and by what its products were truncated by.
    DotProduct {
        /// The sum of products.
        of: RealId,
        /// The vectors.
        vectors: [VectorId; 2],
        /// Their lengths.
        lengths: [f64; 2],
        /// What truncated products make it smaller, at most.
        truncated: f64,
    },
    /// The other real value, of whose error a proof says more than rules do.
    Tightened {
        /// The same real value.
        of: RealId,
        /// What is proven of its error.
        bound: ErrorBound,
        /// Where the proof stands.
        proof: &'static str,
    },
    /// The other real value, of whose error rules see nothing, or not all: what a proof says of it
    /// counts alone.
    Overridden {
        /// The same real value.
        of: RealId,
        /// What is proven of its error.
        bound: ErrorBound,
        /// Where the proof stands.
        proof: &'static str,
    },
    /// The other real value, of which a fact says where it lies.
    Within {
        /// The same real value.
        of: RealId,
        /// Where it lies.
        real: Interval,
        /// The fact.
        fact: String,
    },
}

/// A vector of the formula.
#[derive(Clone, Debug, PartialEq)]
pub struct RealVector {
    /// Its components.
    pub components: [RealId; 3],
    /// What is known of it besides. Other vectors that it depends on have smaller numbers.
    pub rule: VectorRule,
}

/// What is known of a vector as a whole.
#[derive(Clone, Debug, PartialEq)]
pub enum VectorRule {
    /// What its components say.
    Components,
    /// It is the other vector: in another unit, or with components in ranges that are stated.
    Same(VectorId),
    /// It is the other vector, rounded here.
    Rounded(VectorId),
    /// It is one or the other vector.
    Choice(VectorId, VectorId),
    /// It is the other vector, of which a proof says how far it is off as a whole.
    Proven {
        /// The same vector.
        of: VectorId,
        /// What is proven of its error.
        error: VectorError,
        /// Where the proof stands.
        proof: &'static str,
    },
    /// It is the other vector, whose fixed-point one is no longer than so much.
    NoLonger(VectorId, f64),
    /// It is the other vector, whose real one is by a fact no shorter than so much.
    NoShorter {
        /// The same vector.
        of: VectorId,
        /// What it is no shorter than.
        length: f64,
        /// The fact.
        fact: String,
    },
}

impl Rule {
    /// Real values that it depends on.
    pub fn operands(&self) -> Vec<RealId> {
        match self {
            Rule::Exact | Rule::Input { .. } | Rule::Table { .. } | Rule::LoopInvariant { .. } => {
                vec![]
            }
            Rule::Same(a)
            | Rule::Scaled(a, _)
            | Rule::Square(a)
            | Rule::Rounded(a)
            | Rule::Truncated(a)
            | Rule::Remainder(a)
            | Rule::ClampedBelow(a, _)
            | Rule::ClampedAbove(a, _)
            | Rule::Absolute(a)
            | Rule::DotProduct { of: a, .. }
            | Rule::Tightened { of: a, .. }
            | Rule::Overridden { of: a, .. }
            | Rule::Within { of: a, .. } => vec![*a],
            Rule::Sum(a, b)
            | Rule::Difference(a, b)
            | Rule::Product(a, b)
            | Rule::Choice(a, b)
            | Rule::Accumulated { start: a, step: b, .. } => vec![*a, *b],
            Rule::AnyOf(all) => all.clone(),
        }
    }

    /// Vectors that it depends on.
    pub fn vectors(&self) -> &[VectorId] {
        match self {
            Rule::DotProduct { vectors, .. } => vectors,
            _ => &[],
        }
    }

    /// The proof or the fact that it rests on, if it rests on one.
    pub fn premise(&self) -> Option<&str> {
        match self {
            Rule::Tightened { proof, .. } | Rule::Overridden { proof, .. } => Some(proof),
            Rule::Within { fact, .. } => Some(fact),
            _ => None,
        }
    }
}

impl VectorRule {
    /// Vectors that it depends on.
    pub fn operands(&self) -> Vec<VectorId> {
        match self {
            VectorRule::Components => vec![],
            VectorRule::Same(a)
            | VectorRule::Rounded(a)
            | VectorRule::Proven { of: a, .. }
            | VectorRule::NoLonger(a, _)
            | VectorRule::NoShorter { of: a, .. } => vec![*a],
            VectorRule::Choice(a, b) => vec![*a, *b],
        }
    }

    /// The proof or the fact that it rests on, if it rests on one.
    pub fn premise(&self) -> Option<&str> {
        match self {
            VectorRule::Proven { proof, .. } => Some(proof),
            VectorRule::NoShorter { fact, .. } => Some(fact),
            _ => None,
        }
    }
}

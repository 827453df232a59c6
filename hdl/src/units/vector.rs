//! Vectors: whether they have a direction, and what is known of their lengths.
use specula_datapath::bound::VectorBound;
use specula_datapath::builder::{Builder, Sig, Vector};

/// Whether a vector has a component that is not 0 (extremes row 1).
pub fn has_direction(b: &Builder, n: &Vector) -> Sig {
    b.unit("direction_gate", "N is not 0", (("n", n),), |b, (n,)| {
        let zero = b.integer(0);
        let not_zero = |c: &Sig| c.less_than(&zero).or(&zero.less_than(c));
        not_zero(&n.x).or(&not_zero(&n.y)).or(&not_zero(&n.z)).named("has_direction")
    })
}

/// What is known of a vector no shorter than `shortest` as a real one.
pub(super) fn bounds(vector: &Vector, shortest: f64) -> VectorBound {
    VectorBound { shortest, ..vector.bound() }
}

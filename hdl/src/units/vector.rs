//! Vectors: whether they have a direction, and what depends on that.
use crate::error;
use specula_datapath::builder::{Builder, Sig, Vector};

/// Whether a vector has a component that is not 0 (extremes row 1).
pub fn has_direction(b: &Builder, n: &Vector) -> Sig {
    b.unit("direction_gate", "N is not 0", (("n", n),), |b, (n,)| {
        let zero = b.integer(0);
        let not_zero = |c: &Sig| c.less_than(&zero).or(&zero.less_than(c));
        not_zero(&n.x).or(&not_zero(&n.y)).or(&not_zero(&n.z)).named("has_direction")
    })
}

/// (X + Y)/2, exact.
pub fn half_sum(x: &Vector, y: &Vector) -> Vector {
    let sum = x + y;
    let longest = (x.longest() + y.longest()) / 2.0;
    Vector::new([sum.x.halved(), sum.y.halved(), sum.z.halved()]).no_longer_than(longest)
}

/// A value from 0 to 1 that is 0 where the bit `has_direction` is 0.
pub fn gated(value: Sig, has_direction: &Sig) -> Sig {
    match error::vector::gated(has_direction.bound()) {
        Some(error) => value.override_error("error::vector::gated", error),
        None => value,
    }
}

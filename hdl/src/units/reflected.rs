//! R·L of a view vector that is reflected about the normal.
use super::clamp::to_unit_interval;
use crate::error::unit_vectors::any_base;
use specula_datapath::bound::Angular;
use specula_datapath::builder::{Builder, Sig};

/// What R·L = 2(N·V)(N·L) - V·L is made of.
pub(super) struct Reflected<'a> {
    /// N·V and N·L, or two factors of their product.
    pub factors: [&'a Sig; 2],
    /// Bound on the error of their product, infinite where only propagation knows one.
    pub product_error: f64,
    /// V·L.
    pub light_dot_view: &'a Sig,
    /// Where N has a direction.
    pub direction: Direction<'a>,
    /// Bits right of the binary point of R·L.
    pub fraction_bits: u32,
}

/// Where a normal has a direction.
pub(super) enum Direction<'a> {
    /// At every pixel.
    Always,
    /// Where this bit is 1.
    Where(&'a Sig),
    /// Where this, its squared length, is above 0.
    WherePositive(&'a Sig),
}

/// What a proof says of a value from 0 to 1.
pub(super) enum UnitBound {
    /// What operators propagate.
    Propagated,
    /// It is the cosine of an angle, and where that is proven.
    Cosine(&'static str, Angular),
    /// It may be anything from 0 to 1.
    Unknown,
}

/// R·L, kept within 0 to 1, and 0 where N has no direction. `bound` gives the proof, of what R·L is
/// rounded by.
pub(super) fn reflected(b: &Builder, of: Reflected, bound: impl FnOnce(f64) -> UnitBound) -> Sig {
    let [j, k] = of.factors;
    let product =
        (j * k).tighten_error("error::cosine::InverseLength::quotient_error", of.product_error);
    let cosine = product.doubled() - of.light_dot_view;
    let rounding = cosine.bound().rounding(of.fraction_bits);
    let kept = to_unit_interval(&cosine, of.fraction_bits);
    let or_zero = |bit: &Sig| bit.choose(&kept, &b.integer(0));
    let base = match of.direction {
        Direction::Always => kept.clone(),
        Direction::Where(bit) => or_zero(bit),
        Direction::WherePositive(square) => or_zero(&b.integer(0).less_than(square)),
    };
    bound(rounding).stated_of(base.named("base"))
}

impl UnitBound {
    pub(super) fn stated_of(self, value: Sig) -> Sig {
        match self {
            UnitBound::Propagated => value,
            UnitBound::Cosine(proof, known) => value.tighten_error(proof, known),
            UnitBound::Unknown => value.override_error("error::unit_vectors::any_base", any_base()),
        }
    }
}

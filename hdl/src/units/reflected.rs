//! R·L of a view vector that is reflected about the normal.
use super::clamp::to_unit_interval;
use specula_datapath::bound::Angular;
use specula_datapath::bound::ErrorModel;
use specula_datapath::builder::{Builder, Sig};
use specula_scene::format::power_of_two;

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
    /// It is the cosine of an angle.
    Cosine(Angular),
    /// It may be anything from 0 to 1.
    Unknown,
}

/// R·L, kept within 0 to 1, and 0 where N has no direction. `bound` gives the proof, of what R·L is
/// rounded by.
pub(super) fn reflected(b: &Builder, of: Reflected, bound: impl FnOnce(f64) -> UnitBound) -> Sig {
    let [j, k] = of.factors;
    let product = (j * k).tighten_error("reflected", of.product_error);
    let cosine = product.doubled() - of.light_dot_view;
    let rounding = half_unit_where_narrowed(&cosine, of.fraction_bits);
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
            UnitBound::Cosine(Angular { angle, rest }) => {
                value.tighten_error("reflected", Angular { angle: angle, rest })
            }
            UnitBound::Unknown => value.override_error("reflected", 1.0),
        }
    }
}

/// What is known of a cosine's angle.
pub(super) fn angular(cosine: &Sig) -> Option<Angular> {
    match cosine.bound().model {
        ErrorModel::Angular(Angular { angle, rest }) => Some(Angular { angle, rest }),
        _ => None,
    }
}

/// What rounding to `fraction_bits` adds to an error: nothing where there are no more.
pub(super) fn half_unit_where_narrowed(value: &Sig, fraction_bits: u32) -> f64 {
    if value.fraction_bits() > fraction_bits {
        0.5 * power_of_two(-i64::from(fraction_bits))
    } else {
        0.0
    }
}

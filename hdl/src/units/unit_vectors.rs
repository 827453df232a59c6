//! Highlights from cosines. [methods A3; Lyon, TR 43, appendix]
use super::clamp::to_unit_interval;
use super::divider::divider;
use super::gaussian::kept_versine;
use super::reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
use super::reflected::{Direction, Reflected, UnitBound, reflected};
use crate::error;
use specula_datapath::builder::{Builder, Sig, Vector};

/// The cosine of the angle between unit vectors, rounded to `fraction_bits`. Error:
/// [`error::unit_vectors::cosine`].
pub fn cosine_between(b: &Builder, x: &Vector, y: &Vector, fraction_bits: u32) -> Sig {
    b.unit("cosine", "c = X.Y", (("x", x), ("y", y)), |_, (x, y)| {
        let product = x.dot_within(&y, (x.longest(), y.longest()), "|X.Y| <= |X||Y|");
        let rounding = product.bound().rounding(fraction_bits);
        let known = error::unit_vectors::cosine([x.bound(), y.bound()], rounding);
        product
            .rounded(fraction_bits)
            .tighten_error("error::unit_vectors::cosine", known)
            .named("cosine")
    })
}

/// R·L = 2(N·V)(N·L) - V·L, kept within 0 to 1. Error: [`error::unit_vectors::reflection`]. [methods
/// A3, B1]
pub fn reflected_cosine(
    b: &Builder,
    n_dot_v: &Sig,
    n_dot_l: &Sig,
    l_dot_v: &Sig,
    fraction_bits: u32,
) -> Sig {
    let inputs = (("n_dot_v", n_dot_v), ("n_dot_l", n_dot_l), ("l_dot_v", l_dot_v));
    b.unit(
        "reflected_cosine",
        "R.L = 2(N.V)(N.L) - V.L",
        inputs,
        |b, (n_dot_v, n_dot_l, light_dot_view)| {
            let of = Reflected {
                factors: [&n_dot_v, &n_dot_l],
                product_error: f64::INFINITY,
                light_dot_view: &light_dot_view,
                direction: Direction::Always,
                fraction_bits,
            };
            let known = [&n_dot_v, &n_dot_l, &light_dot_view].map(Sig::bound);
            reflected(b, of, |rounding| match error::unit_vectors::reflection(known, rounding) {
                Some(known) => UnitBound::Cosine("error::unit_vectors::reflection", known),
                None => UnitBound::Propagated,
            })
        },
    )
}

/// H*·N = (N·L + N·V)/|L + V|, kept within 0 to 1; `gain` is 1/|L + V|. [methods B6; Lyon, TR 43,
/// appendix, formulation 5]
pub fn halfway_cosine(
    b: &Builder,
    n_dot_v: &Sig,
    n_dot_l: &Sig,
    gain: &Sig,
    fraction_bits: u32,
) -> Sig {
    let inputs = (("n_dot_v", n_dot_v), ("n_dot_l", n_dot_l), ("gain", gain));
    b.unit("halfway_cosine", "H*.N = (N.L + N.V)/|L + V|", inputs, |_, (n_dot_v, n_dot_l, gain)| {
        to_unit_interval(&((n_dot_l + n_dot_v) * gain), fraction_bits).named("base")
    })
}

/// 1 - H*·N, kept within 0 to 15/8; `gain` is 1/|L + V|. [methods B6; Lyon, TR 43, appendix,
/// formulation 11]
pub fn halfway_versine(
    b: &Builder,
    n_dot_v: &Sig,
    n_dot_l: &Sig,
    gain: &Sig,
    fraction_bits: u32,
) -> Sig {
    let inputs = (("n_dot_v", n_dot_v), ("n_dot_l", n_dot_l), ("gain", gain));
    b.unit(
        "halfway_versine",
        "d = 1 - (N.L + N.V)/|L + V|",
        inputs,
        |b, (n_dot_v, n_dot_l, gain)| {
            let versine = b.integer(1) - (n_dot_l + n_dot_v) * gain;
            kept_versine(&versine.rounded(fraction_bits)).named("base")
        },
    )
}

/// 1/|L + V| = 1/√(2 + 2 V·L). [methods B6]
pub fn halfway_gain(
    b: &Builder,
    l_dot_v: &Sig,
    length_squared_bits: u32,
    to: ReciprocalRoot,
) -> Sig {
    b.unit("halfway_gain", "y = 1/sqrt(2 + 2 V.L)", (("l_dot_v", l_dot_v),), |b, (l_dot_v,)| {
        let squared = (b.integer(2) + l_dot_v.doubled())
            .rounded(length_squared_bits)
            .named("halfway_squared");
        reciprocal_square_root(b, &squared, to)
    })
}

/// -L·A of a spot with axis A, kept within 0 to 1. [Hast et al., after eq. 35]
pub fn spot_cosine(b: &Builder, l: &Vector, axis: &Vector, fraction_bits: u32) -> Sig {
    b.unit("spot_cosine", "s = -L.A", (("l", l), ("axis", axis)), |_, (l, axis)| {
        let cosine = l.dot_within(&axis, (l.longest(), axis.longest()), "|L.A| <= |L||A|");
        to_unit_interval(&-cosine, fraction_bits).named("base")
    })
}

/// Trowbridge and Reitz's (1/(1 + (1 - c²) n))². [Lyon, TR 43, appendix, formulation 12]
///
/// x = (1 - c²) n is rounded to `x_bits` fraction bits; 1 + x ≥ 1, so the reciprocal is off by no
/// more than x is.
pub fn trowbridge_reitz(b: &Builder, base: &Sig, n: &Sig, x_bits: u32, fraction_bits: u32) -> Sig {
    b.unit(
        "trowbridge_reitz",
        "f = (1/(1 + (1 - c^2) n))^2",
        (("base", base), ("n", n)),
        |b, (base, n)| {
            let x =
                ((b.integer(1) - base.squared()) * n).rounded(x_bits).at_least_zero().named("x");
            let reciprocal = divider(b, &b.integer(1), &(b.integer(1) + x), fraction_bits);
            reciprocal.squared().rounded(fraction_bits).named("f")
        },
    )
}

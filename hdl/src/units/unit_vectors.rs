//! Highlights from cosines. [methods A3; Lyon, TR 43, appendix]
use specula_scene::format::power_of_two;

use super::divider::divider;
use super::gaussian::kept_versine;
use super::reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
use crate::builder::{Builder, Sig, Vector};
use crate::design::ErrorForm;

/// The cosine of the angle between unit vectors, rounded to `fraction_bits`.
///
/// # Error
/// It is the cosine of an angle that is off by no more than both vectors are turned, times lengths
/// that are off by ε_x and ε_y: beside the angle it is off by (1 + ε_x)(1 + ε_y) - 1 and half a
/// unit.
pub fn cosine_between(b: &Builder, x: &Vector, y: &Vector, fraction_bits: u32) -> Sig {
    b.unit("cosine", "c = X.Y", (("x", x), ("y", y)), |_, (x, y)| {
        let product = x.dot_within(&y, (x.longest(), y.longest()), "|X.Y| <= |X||Y|");
        let rounding = half_unit_where_narrowed(&product, fraction_bits);
        let angle = x.off().angle() + y.off().angle();
        let rest = (1.0 + x.off().stretch()) * (1.0 + y.off().stretch()) - 1.0 + rounding;
        product.rounded(fraction_bits).known_cosine(angle, rest).named("cosine")
    })
}

/// R·L = 2(N·V)(N·L) - V·L, kept within 0 to 1. [methods A3, B1]
///
/// # Error
/// Let the cosines be those of turned unit vectors, off by r_v, r_l and r beside that. Then this is
/// R·L of those, whose angle is off by no more than both angles with N together, and off by 2(r_v +
/// r_l + r_v r_l) + r beside that. A V·L that the host sends is that of the real vectors, and the
/// eye is exact then: so r is what it is off, and what L is turned by, that is the difference of
/// both angles.
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
        |_, (n_dot_v, n_dot_l, l_dot_v)| {
            let base = (&n_dot_v * &n_dot_l).doubled() - &l_dot_v;
            let rounding = half_unit_where_narrowed(&base, fraction_bits);
            let base = from_0_to_1(&base, fraction_bits);
            match [&n_dot_v, &n_dot_l, &l_dot_v].map(Sig::error_form) {
                [
                    ErrorForm::OfCosine { angle: angle_v, rest: r_v },
                    ErrorForm::OfCosine { angle: angle_l, rest: r_l },
                    form_of_l_dot_v,
                ] => {
                    let r = match form_of_l_dot_v {
                        ErrorForm::OfCosine { rest, .. } => rest,
                        _ => l_dot_v.error_value() + (angle_l - angle_v).max(0.0),
                    };
                    base.known_cosine(
                        angle_v + angle_l,
                        2.0 * (r_v + r_l + r_v * r_l) + r + rounding,
                    )
                }
                _ => base,
            }
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
        from_0_to_1(&((n_dot_l + n_dot_v) * gain), fraction_bits)
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
        // How short H may be depends on the scene: nothing is known of it here.
        reciprocal_square_root(b, &squared, to, 0.0)
    })
}

/// -L·A of a spot with axis A, kept within 0 to 1. [Hast et al., after eq. 35]
pub fn spot_cosine(b: &Builder, l: &Vector, axis: &Vector, fraction_bits: u32) -> Sig {
    b.unit("spot_cosine", "s = -L.A", (("l", l), ("axis", axis)), |_, (l, axis)| {
        let cosine = l.dot_within(&axis, (l.longest(), axis.longest()), "|L.A| <= |L||A|");
        from_0_to_1(&-cosine, fraction_bits)
    })
}

/// What rounding to `fraction_bits` adds to an error: nothing where there are no more.
pub(super) fn half_unit_where_narrowed(value: &Sig, fraction_bits: u32) -> f64 {
    if value.fraction_bits() > fraction_bits {
        0.5 * power_of_two(-i64::from(fraction_bits))
    } else {
        0.0
    }
}

fn from_0_to_1(value: &Sig, fraction_bits: u32) -> Sig {
    value.rounded(fraction_bits).at_least_zero().clamped_above(1).named("base")
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
            let reciprocal = divider(b, &b.integer(1), &(b.integer(1) + x), fraction_bits, 1.0);
            reciprocal.squared().rounded(fraction_bits).named("f")
        },
    )
}

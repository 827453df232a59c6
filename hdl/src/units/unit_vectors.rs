//! Highlights from cosines. [methods A3; Lyon, TR 43, appendix]
use super::clamp::to_unit_interval;
use super::divider::divider;
use super::gaussian::kept_versine;
use super::reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
use super::reflected::{Direction, Reflected, UnitBound, reflected};
use crate::error;
use specula_datapath::bound::Interval;
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

/// 1/|L + V|.
pub struct HalfwayGain {
    /// The gain.
    pub gain: Sig,
    /// What is known of it where L·V is known as a cosine.
    proven: Option<error::unit_vectors::HalfwayGain>,
}

impl HalfwayGain {
    /// One of which no more is known than its bound.
    pub fn given(gain: Sig) -> HalfwayGain {
        HalfwayGain { gain, proven: None }
    }
}

/// H*·N = (N·L + N·V)/|L + V|, kept within 0 to 1. [methods B6; Lyon, TR 43, appendix, formulation
/// 5]
///
/// # Error
/// [`error::unit_vectors::HalfwayGain::cosine`] where N·L, N·V and L·V are known as cosines.
pub fn halfway_cosine(
    b: &Builder,
    [n_dot_v, n_dot_l]: [&Sig; 2],
    HalfwayGain { gain, proven }: &HalfwayGain,
    fraction_bits: u32,
) -> Sig {
    let inputs = (("n_dot_v", n_dot_v), ("n_dot_l", n_dot_l), ("gain", gain));
    b.unit("halfway_cosine", "H*.N = (N.L + N.V)/|L + V|", inputs, |_, (n_dot_v, n_dot_l, gain)| {
        let cosine = (&n_dot_l + &n_dot_v) * gain;
        let rounding = cosine.bound().rounding(fraction_bits);
        let factors = [n_dot_v.bound(), n_dot_l.bound()];
        let known = proven.and_then(|gain| gain.cosine(factors, rounding));
        let base = to_unit_interval(&cosine, fraction_bits);
        match known {
            Some(known) => {
                base.tighten_error("error::unit_vectors::HalfwayGain::cosine", known).named("base")
            }
            None => base.named("base"),
        }
    })
}

/// 1 - H*·N, kept within 0 to 15/8. [methods B6; Lyon, TR 43, appendix,
/// formulation 11]
pub fn halfway_versine(
    b: &Builder,
    [n_dot_v, n_dot_l]: [&Sig; 2],
    HalfwayGain { gain, .. }: &HalfwayGain,
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

/// What a scene's needs say of half-way vectors.
pub const SHORTEST_HALFWAY: &str = "no L + V is shorter than at any pixel";

/// 1/|L + V| = 1/√(2 + 2 V·L) of L + V no shorter than `shortest`. [methods B6]
pub fn halfway_gain(
    b: &Builder,
    l_dot_v: &Sig,
    shortest: f64,
    length_squared_bits: u32,
    to: ReciprocalRoot,
) -> HalfwayGain {
    let formula = "y = 1/sqrt(2 + 2 V.L)";
    let mut rounding = 0.0;
    let gain = b.unit("halfway_gain", formula, (("l_dot_v", l_dot_v),), |b, (l_dot_v,)| {
        let exact = b.integer(2) + l_dot_v.doubled();
        rounding = exact.bound().rounding(length_squared_bits);
        let squared = exact
            .rounded(length_squared_bits)
            .real_within(Interval::at_least(shortest * shortest), SHORTEST_HALFWAY)
            .named("halfway_squared");
        reciprocal_square_root(b, &squared, to)
    });
    let known = [shortest, to.least_operand(), gain.ulp()];
    let proven = error::unit_vectors::HalfwayGain::new(l_dot_v.bound(), rounding, known);
    HalfwayGain { gain, proven }
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

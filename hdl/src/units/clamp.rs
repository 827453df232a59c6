//! Cosines kept within limits: what real ones never leave, and what lights nothing.
use specula_datapath::builder::{Builder, Sig};

/// min(max(c, 0), 1), rounded to `fraction_bits`, of a cosine that may leave -1 to 1 by rounding.
/// Source: Lambert
pub fn clamp_unit(b: &Builder, cosine: &Sig, fraction_bits: u32) -> Sig {
    b.unit("diffuse", "I = max(N.L, 0) [Lambert]", (("cosine", cosine),), |_, (cosine,)| {
        to_unit_interval(&cosine, fraction_bits).named("intensity")
    })
}

/// max(c, 0), rounded to `fraction_bits`, of a cosine within -1 to 1.
pub fn clamp_nonnegative(b: &Builder, cosine: &Sig, fraction_bits: u32) -> Sig {
    b.unit("amount", "I = max(c, 0)", (("cosine", cosine),), |_, (c,)| {
        to_nonnegative(&c, fraction_bits).named("intensity")
    })
}

/// min(max(A, 0), 1), rounded to `fraction_bits`, of what distance leaves of a light. [Hast et al., §1]
pub fn clamp_share(b: &Builder, share: &Sig, fraction_bits: u32) -> Sig {
    b.unit(
        "share",
        "A kept within 0 to 1 [Hast et al., section 1]",
        (("share", share),),
        |_, (a,)| to_unit_interval(&a, fraction_bits).named("arriving"),
    )
}

/// The value, rounded and kept within 0 to 1.
pub(super) fn to_unit_interval(value: &Sig, fraction_bits: u32) -> Sig {
    to_nonnegative(value, fraction_bits).clamped_above(1)
}

/// The value, rounded and kept at 0 or above.
pub(super) fn to_nonnegative(value: &Sig, fraction_bits: u32) -> Sig {
    value.rounded(fraction_bits).at_least_zero()
}

/// The value, rounded and kept within -1 to 1.
pub(super) fn to_cosine(value: &Sig, fraction_bits: u32) -> Sig {
    value.rounded(fraction_bits).clamped_below(-1).clamped_above(1).named("cosine")
}

//! Cosines to a normal of any length, and the base of the highlight from them.
use specula_scene::Format;

use super::reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
use specula_datapath::builder::{Builder, Sig};

/// What divides by the length of a normal: its square q, and s = 1/√q.
pub struct Length {
    /// q.
    pub squared: Sig,
    /// s, and 0 where q ≤ 0.
    pub root: Sig,
    /// Whether q > 0; off by 1 where rounding may decide that.
    pub has_direction: Sig,
    /// Real q is no smaller, and |u·N|² no larger than q for any unit vector u; 0 where that is not
    /// sure of q after rounding.
    smallest: f64,
}

/// s = 1/√max(q, 4^-m) with m the integer bits of `format`, and 0 where q ≤ 0; no real q is smaller
/// than `smallest`.
///
/// What is known of its error is known of products with it, and [`cosine`] says it.
pub fn root(b: &Builder, q: &Sig, format: Format, smallest: f64) -> Length {
    let to = ReciprocalRoot::from(format);
    let positive = b.integer(0).less_than(q);
    let reciprocal = reciprocal_square_root(b, q, to, smallest);
    let root = positive.choose(&reciprocal, &b.integer(0)).named("s");
    let sure = smallest - q.error_value();
    let reached = sure > 0.0 && sure >= to.smallest_operand();
    let unsure = if sure > 0.0 { 0.0 } else { 1.0 };
    Length {
        squared: q.clone(),
        root,
        has_direction: positive.named("has_direction").stated_error_value(unsure),
        smallest: if reached { sure } else { 0.0 },
    }
}

impl Length {
    /// Real and fixed q are both no smaller; 0 where nothing is known.
    pub fn smallest(&self) -> f64 {
        self.smallest
    }

    /// Bound on the error of u·N s, with u·N off by `e`, before its rounding.
    ///
    /// With p = u·N, |p| ≤ √q, and primes for what is off: |p's' - p/√q| ≤ e/√q' + √q |1/√q' -
    /// 1/√q| + (√q + e) e_s, where the second is
    /// |q - q'|/(√q'(√q + √q')) ≤ e_q/2q' and e_s what s is rounded by.
    pub fn cosine_error(&self, e: f64, rounding: f64) -> f64 {
        if self.smallest == 0.0 {
            return 2.0;
        }
        e / self.smallest.sqrt()
            + self.squared.error_value() / (2.0 * self.smallest)
            + (1.0 + e) * rounding
    }

    /// Bound on the error of v p/q, with v and p off by `e_v` and `e_p` and the quotient rounded by
    /// `rounding`; infinite where nothing is known.
    ///
    /// |p'/q' - p/q| ≤ e_p/q' + √q |q - q'|/(q q') and |v| ≤ √q ≤ 1, |p/q| ≤ 1/√q.
    pub fn quotient_error(&self, e_p: f64, e_v: f64, rounding: f64) -> f64 {
        if self.smallest == 0.0 {
            return f64::INFINITY;
        }
        let (q, e_q) = (self.smallest, self.squared.error_value());
        let of_quotient = e_p / q + e_q / (q * q.sqrt()) + rounding;
        (e_p + e_q) / q + rounding + e_v * (1.0 / q.sqrt() + of_quotient)
    }
}

/// c = u·N s, rounded and clamped to [-1, 1], of p = u·N with a unit vector u. [Hast et al., eq. 8]
pub fn cosine(b: &Builder, p: &Sig, length: &Length, fraction_bits: u32) -> Sig {
    let error = length.cosine_error(p.error_value(), 0.5 * length.root.ulp());
    b.unit(
        "cosine",
        "c = p s, clamped to [-1, 1] [Hast et al., eq. 8]",
        (("p", p), ("s", &length.root)),
        |_, (p, s)| clamped_cosine(&(p * s).stated_error_value(error), fraction_bits),
    )
}

/// c = P w, rounded and clamped to [-1, 1], of a numerator P no larger than q and w = 1/q no larger
/// than 1/`smallest`. [Hast et al., eq. 29]
///
/// With real q no smaller than `smallest`, or P and q 0 exactly, and primes for what is off:
/// |P'/q' - P/q| ≤ (e_P + e_q)/q', and the rounding of w adds (1 + e_P) times that; by 2 at most.
pub fn cosine_by_reciprocal(
    b: &Builder,
    p: &Sig,
    q: &Sig,
    w: &Sig,
    smallest: f64,
    fraction_bits: u32,
) -> Sig {
    let sure = smallest - q.error_value();
    let (e_p, e_q) = (p.error_value(), q.error_value());
    let error =
        if sure > 0.0 { ((e_p + e_q) / sure + (1.0 + e_p) * 0.5 * w.ulp()).min(2.0) } else { 2.0 };
    b.unit(
        "cosine_by_reciprocal",
        "c = P w, clamped to [-1, 1] [Hast et al., eq. 29]",
        (("p", p), ("w", w)),
        |_, (p, w)| clamped_cosine(&(p * w).stated_error_value(error), fraction_bits),
    )
}

/// A product rounded and clamped to [-1, 1].
fn clamped_cosine(product: &Sig, fraction_bits: u32) -> Sig {
    product.rounded(fraction_bits).clamped_below(-1).clamped_above(1).named("cosine")
}

/// A cosine as an amount of light, 0 or more.
pub fn amount(b: &Builder, cosine: &Sig, fraction_bits: u32) -> Sig {
    b.unit("amount", "I = max(c, 0)", (("cosine", cosine),), |_, (c,)| {
        c.rounded(fraction_bits).at_least_zero().named("intensity")
    })
}

/// R·L = 2 v c - L·V with v = N·V and c = N·L of a unit normal N, clamped to [0, 1], and 0 where
/// the normal has no direction. [Hast et al., eq. 33 and 34]
///
/// `product_error` bounds the error of v c where it is better known than by propagation.
///
/// # Error
/// Where rounding may decide whether the normal has a direction, nothing is known of the base: v
/// may be 0 exactly, and b then -L·V on one side, and 0 on the other.
pub fn reflected_base(
    b: &Builder,
    (v, c): (&Sig, &Sig),
    dot_view: &Sig,
    has_direction: &Sig,
    to: Base,
) -> Sig {
    let inputs = (("v", v), ("c", c), ("dot_view", dot_view), ("has_direction", has_direction));
    b.unit(
        "reflected_base",
        "b = 2 v c - L.V, clamped to [0, 1] [Hast et al., eq. 33, 34]",
        inputs,
        |b, (v, c, l, positive)| {
            let reflected = (v * c).proven_error_value(to.product_error).doubled() - l;
            let clamped = reflected.rounded(to.fraction_bits).at_least_zero().clamped_above(1);
            let base = positive.choose(&clamped, &b.integer(0)).named("base");
            if positive.error() == 0.0 { base } else { base.stated_error_value(1.0) }
        },
    )
}

/// How a base comes out.
pub struct Base {
    /// Bits right of its binary point.
    pub fraction_bits: u32,
    /// Bound on the error of the product in it, infinite where only propagation knows one.
    pub product_error: f64,
}

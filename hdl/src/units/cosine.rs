//! Cosines to a normal of any length, and the base of the highlight from them.
use specula_spec::Format;

use super::clamp::{to_cosine, to_unit_interval};
use super::reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
use super::reflected::{Direction, Reflected, UnitBound, reflected};
use crate::error;
use crate::error::cosine::InverseLength;
use specula_datapath::bound::Interval;
use specula_datapath::builder::{Builder, Sig};

/// What divides by the length of a normal: its square q, and s = 1/√q.
pub struct Length {
    /// q.
    pub squared: Sig,
    /// s, and 0 where q ≤ 0.
    pub root: Sig,
    /// Whether q > 0; off by 1 where rounding may decide that.
    pub has_direction: Sig,
    /// What is known of q and s.
    pub proven: InverseLength,
}

/// s = 1/√max(q, 4^-m) with m the integer bits of `format`, and 0 where q ≤ 0.
///
/// What is known of its error is known of products with it: [`error::cosine`].
pub fn root(b: &Builder, q: &Sig, format: Format) -> Length {
    let to = ReciprocalRoot::from(format);
    let positive = b.integer(0).less_than(q);
    let reciprocal = reciprocal_square_root(b, q, to);
    let root = positive.choose(&reciprocal, &b.integer(0)).named("s");
    let unsure = error::cosine::direction_error(q.bound());
    Length {
        squared: q.clone(),
        root,
        has_direction: positive
            .named("has_direction")
            .override_error("error::cosine::direction_error", unsure),
        proven: InverseLength::new(q.bound(), to.least_operand()),
    }
}

/// c = u·N s, rounded and clamped to [-1, 1], of p = u·N with a unit vector u. Error:
/// [`InverseLength::cosine_error`]. [Hast et al., eq. 8]
pub fn cosine(b: &Builder, p: &Sig, length: &Length, fraction_bits: u32) -> Sig {
    let error = length.proven.cosine_error(p.bound(), length.root.bound());
    b.unit(
        "cosine",
        "c = p s, clamped to [-1, 1] [Hast et al., eq. 8]",
        (("p", p), ("s", &length.root)),
        |_, (p, s)| to_cosine(&(p * s).override_error(COSINE, error), fraction_bits),
    )
}

/// c = u·N s as [`cosine`], clamped to [0, 1].
pub fn positive_cosine(b: &Builder, p: &Sig, length: &Length, fraction_bits: u32) -> Sig {
    let error = length.proven.cosine_error(p.bound(), length.root.bound());
    b.unit(
        "positive_cosine",
        "c = p s, clamped to [0, 1] [Hast et al., eq. 8]",
        (("p", p), ("s", &length.root)),
        |_, (p, s)| to_unit_interval(&(p * s).override_error(COSINE, error), fraction_bits),
    )
}

/// P = 2 x y - d q of the products x and y of a vector with two others, their product d, and its
/// square q: one of them reflected about the vector, times the other and q, so no larger than q.
/// [Hast et al., eq. 10 and 17]
pub fn reflected_numerator(
    b: &Builder,
    [x, y]: [&Sig; 2],
    d: &Sig,
    q: &Sig,
    fraction_bits: u32,
) -> Sig {
    let inputs = (("x", x), ("y", y), ("d", d), ("q", q));
    b.unit("numerator", "P = 2 x y - d q [Hast et al., eq. 10, 17]", inputs, |_, (x, y, d, q)| {
        ((x * y).doubled() - d * q)
            .real_within(Interval::new(-1.0, 1.0), "a reflection stretches nothing, and q <= 1")
            .rounded(fraction_bits)
            .named("numerator")
    })
}

/// c = P w, rounded and clamped to [-1, 1], of a numerator P no larger than q and w = 1/q.
/// Error: [`error::cosine::by_reciprocal`]. [Hast et al., eq. 29]
pub fn cosine_by_reciprocal(b: &Builder, p: &Sig, q: &Sig, w: &Sig, fraction_bits: u32) -> Sig {
    let error = error::cosine::by_reciprocal([p.bound(), q.bound()], w.bound());
    b.unit(
        "cosine_by_reciprocal",
        "c = P w, clamped to [-1, 1] [Hast et al., eq. 29]",
        (("p", p), ("w", w)),
        |_, (p, w)| {
            to_cosine(&(p * w).override_error("error::cosine::by_reciprocal", error), fraction_bits)
        },
    )
}

/// Where the error of a cosine is proven.
const COSINE: &str = "error::cosine::InverseLength::cosine_error";

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
        |b, (v, c, light_dot_view, has_direction)| {
            let of = Reflected {
                factors: [&v, &c],
                product_error: to.product_error,
                light_dot_view: &light_dot_view,
                direction: Direction::Where(&has_direction),
                fraction_bits: to.fraction_bits,
            };
            let sure = has_direction.bound().is_exact();
            reflected(b, of, |_| if sure { UnitBound::Propagated } else { UnitBound::Unknown })
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

//! Squared length and scalars of a normal between unit ends, from t alone.
use specula_spec::Format;
use specula_spec::direct::DirectFormats;

use super::clamp::to_cosine;
use super::divider::{QuotientFormat, quotient};
use super::reflected::{Direction, Reflected, UnitBound, reflected};
use crate::error::cosine::InverseLength;
use crate::error::direct::{self, Product, Square};
use crate::error::interpolate::{overshoot, slack};
use specula_datapath::bound::Angular;
use specula_datapath::builder::{Builder, Sig};

/// t = i/S of at most `steps` + 1 pixels, 0 to 1 and what rounding of the step leads past it.
pub fn parameter(b: &Builder, first: &Sig, step: &Sig, formats: &DirectFormats, steps: u32) -> Sig {
    b.unit(
        "parameter",
        "t(i) = i/S",
        (("start", first), ("weight_step", step)),
        |b, (first, step)| {
            let most = 1.0 + slack(formats.weight_accumulator, steps);
            let t =
                Sig::accumulated(&first, &b.integer(0), &step, (0.0, most), steps, "0 <= t <= 1");
            let most = 1.0 + overshoot(formats.weight_accumulator, formats.weight, steps);
            t.rounded(formats.weight.fraction_bits).assumed(0.0, most, "0 <= t <= 1").named("t")
        },
    )
}

/// q = 1 - κ t (1 - t), the squared length of (1 - t) A + t B for unit A and B with κ = |B - A|².
/// [lecture, eq. 4.4; methods A6]
///
/// q leaves the range from 0 to 1 by no more than [`Square`] says.
pub fn squared_length(b: &Builder, t: &Sig, spread: &Sig, formats: &DirectFormats) -> Sig {
    b.unit(
        "squared_length",
        "q = 1 - k t (1 - t), k = |B - A|^2 [lecture, eq. 4.4]",
        (("t", t), ("spread", spread)),
        |b, (t, spread)| {
            let ends = Square::new(direct::past(t.bound()), formats);
            let product = (&t * (b.integer(1) - &t))
                .assumed(-ends.below, 0.25, "t (1 - t) <= 1/4")
                .rounded(formats.product.fraction_bits)
                .named("product"); // U1.f
            (b.integer(1) - spread * product)
                .assumed(-ends.slack, ends.most(), "0 <= q <= 1")
                .rounded(formats.length_squared.fraction_bits)
                .named("q") // U1.f
        },
    )
}

/// p = N·X for X = L and V alike, linear in t. [lecture, eq. 4.3]
///
/// Both ends are rounded and t ≤ 1 + o, so N·X is no larger than 1 + 2o.
///
/// # Error
/// [`direct::scalar`].
pub fn direct_scalar(
    b: &Builder,
    t: &Sig,
    [start, delta]: [&Sig; 2],
    formats: &DirectFormats,
) -> Sig {
    let inputs = (("t", t), ("at_start", start), ("delta", delta));
    b.unit(
        "scalar",
        "p = N.X = A.X + t (B.X - A.X) [lecture, eq. 4.3]",
        inputs,
        |_, (t, start, delta)| {
            let error = direct::scalar(t.bound(), start.bound(), delta.bound());
            let limit = direct::largest_scalar(t.bound());
            (&start + t * delta)
                .override_error("error::direct::scalar", error)
                .assumed(-limit, limit, "|N.X| <= 1")
                .rounded(formats.cosine.fraction_bits)
                .named("linear") // S1.f
        },
    )
}

/// p s with s = 1/√q, kept within -1 to 1. [lecture, eq. 4.3]
///
/// # Error
/// [`direct::cosine`].
pub fn direct_cosine(
    b: &Builder,
    p: &Sig,
    s: &Sig,
    formats: &DirectFormats,
    normal: Angular,
) -> Sig {
    b.unit("cosine", "c = p/sqrt(q) [lecture, eq. 4.3]", (("p", p), ("s", s)), |_, (p, s)| {
        let cosine = to_cosine(&(p * s), formats.cosine.fraction_bits);
        match direct::cosine(normal, formats) {
            Some(known) => cosine.tighten_error("error::direct::cosine", known),
            None => cosine.override_error("error::direct::any_cosine", direct::any_cosine()),
        }
    })
}

/// p s with s = 1/√q as [`direct_cosine`], of a p that is off by more than N is. [lecture, eq. 4.3]
///
/// # Error
/// What is `proven` of an s that is correctly rounded, else what is propagated.
pub fn cosine_of_scalar(
    b: &Builder,
    p: &Sig,
    s: &Sig,
    fraction_bits: u32,
    proven: Option<InverseLength>,
) -> Sig {
    b.unit("cosine", "c = p/sqrt(q) [lecture, eq. 4.3]", (("p", p), ("s", s)), |_, (p, s)| {
        let product = &p * &s;
        let product = match proven.map(|proven| proven.cosine_error(p.bound(), s.bound())) {
            Some(error) => {
                product.override_error("error::cosine::InverseLength::cosine_error", error)
            }
            None => product,
        };
        to_cosine(&product, fraction_bits)
    })
}

/// p/q, which with another p makes p p/q of any length of N: |p/q| ≤ 1/√q ≤ 2^m. [lecture, eq. 4.5]
pub fn over_square(b: &Builder, p: &Sig, q: &Sig, formats: &DirectFormats) -> Sig {
    b.unit("over_square", "k = p/q [lecture, eq. 4.5]", (("p", p), ("q", q)), |b, (p, q)| {
        let Format { integer_bits, fraction_bits, .. } = formats.reciprocal;
        let to = QuotientFormat { integer_bits: 2 * integer_bits, fraction_bits };
        let reciprocal = quotient(b, &b.integer(1), &at_least(b, &q, 2 * integer_bits), to);
        let limit = 1 << integer_bits;
        (p * reciprocal)
            .rounded(formats.cosine.fraction_bits)
            .clamped_below(-limit)
            .clamped_above(limit)
            .named("quotient")
    })
}

/// q, and 2^-`exponent` where it is less.
pub(super) fn at_least(b: &Builder, q: &Sig, exponent: u32) -> Sig {
    let smallest = b.integer(1).times_power_of_two(-(exponent as i32));
    q.less_than(&smallest).choose(&smallest, q).named("limited")
}

/// What the base of the highlight is made of.
pub struct DirectedBase<'a> {
    /// J and K, or p_L and p_V/q.
    pub factors: [&'a Sig; 2],
    /// What is known of their product.
    pub known: KnownProduct,
    /// L·V.
    pub light_dot_view: &'a Sig,
    /// q.
    pub q: &'a Sig,
}

/// What is known of the product that a base is made of.
#[derive(Clone, Copy)]
pub enum KnownProduct {
    /// A proof.
    Proven(Product),
    /// What operators propagate.
    Propagated,
    /// Nothing.
    Nothing,
}

impl From<Option<Product>> for KnownProduct {
    fn from(proven: Option<Product>) -> KnownProduct {
        proven.map_or(KnownProduct::Nothing, KnownProduct::Proven)
    }
}

/// 2 J K - L·V, kept within 0 to 1, and 0 where q ≤ 0; a q that may be rounded to 0 though it is
/// not makes all of it unsure. [lecture, eq. 4.5; methods A7]
///
/// # Error
/// [`Product::base`].
pub fn directed_base(b: &Builder, of: DirectedBase, fraction_bits: u32) -> Sig {
    let [j, k] = of.factors;
    let inputs =
        (("n_dot_l", j), ("n_dot_v", k), ("light_dot_view", of.light_dot_view), ("q", of.q));
    b.unit(
        "specular_base",
        "b = max(2 J K - L.V, 0) [lecture, eq. 4.5]",
        inputs,
        |b, (j, k, light_dot_view, q)| {
            let is_positive = direct::is_positive(q.bound());
            let known = if is_positive { of.known } else { KnownProduct::Nothing };
            let of = Reflected {
                factors: [&j, &k],
                product_error: f64::INFINITY,
                light_dot_view: &light_dot_view,
                direction: Direction::WherePositive(&q),
                fraction_bits,
            };
            reflected(b, of, |rounding| match known {
                KnownProduct::Proven(known) => UnitBound::Cosine(
                    "error::direct::Product::base",
                    known.base(light_dot_view.bound(), rounding),
                ),
                KnownProduct::Propagated => UnitBound::Propagated,
                KnownProduct::Nothing => UnitBound::Unknown,
            })
        },
    )
}

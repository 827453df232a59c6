//! Squared length and scalars of a normal between unit ends, from t alone.
use specula_scene::Format;
use specula_scene::format::power_of_two;
use specula_scene::spec::direct::DirectFormats;

use super::HOST_ERROR;
use super::divider::{QuotientFormat, quotient};
use super::interpolate::{chord, overshoot, slack};
use super::newton_root::NewtonRoot;
use super::reflected::half_unit_where_narrowed;
use specula_datapath::builder::{Builder, Sig};
use specula_datapath::design::ErrorForm;

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
/// t (1 - t) ≤ 1/4 and κ ≤ 4, so q ≥ 0 but for what t (1 - t) is rounded by, four times, and q
/// itself.
pub fn squared_length(b: &Builder, t: &Sig, spread: &Sig, formats: &DirectFormats) -> Sig {
    b.unit(
        "squared_length",
        "q = 1 - k t (1 - t), k = |B - A|^2 [lecture, eq. 4.4]",
        (("t", t), ("spread", spread)),
        |b, (t, spread)| {
            let past = t.format().value(t.range().high) - 1.0;
            let below = past.max(0.0) * (1.0 + past.max(0.0));
            let product = (&t * (b.integer(1) - &t)).assumed(-below, 0.25, "t (1 - t) <= 1/4");
            let product = product.rounded(formats.product.fraction_bits).named("product");
            let slack = 4.0 * formats.product.ulp();
            let q = (b.integer(1) - spread * product).assumed(
                -slack,
                1.0 + 4.0 * below + slack,
                "0 <= q <= 1",
            );
            q.rounded(formats.length_squared.fraction_bits).named("q")
        },
    )
}

/// What rounding leaves of N between unit ends: t turns it, and q is that of another.
struct Moved {
    /// |B - A| e_t, by how much N is moved along its line.
    by: f64,
    /// Length of the shortest N as it is.
    least: f64,
    /// By how much its direction is turned: an angle whose chord is |B - A| e_t/√(s m), s for the
    /// shortest N as it should be and m as it is.
    angle: f64,
    /// What t reaches past 1.
    past: f64,
    /// By how much q is off from that of N as it is: the rounding of κ times t (1 - t), which is
    /// 1/4 at most, that of the product times κ, and its own.
    of_square: f64,
}

impl Moved {
    fn new(t: &Sig, spread: &Sig, formats: &DirectFormats, shortest: f64) -> Moved {
        let by = chord(shortest) * t.error_value();
        let least = shortest - by;
        let chord_turned = by / (shortest * least).sqrt();
        let past = (t.format().value(t.range().high) - 1.0).max(0.0);
        let half = |format: Format| 0.5 * format.ulp();
        let spread_range = spread.range().high as f64 * spread.ulp();
        let kappa = spread_range.min(chord(shortest).powi(2) + half(formats.spread));
        let t_by_rest = 0.25 + past * (1.0 + past);
        let of_square = t_by_rest * half(formats.spread)
            + kappa * half(formats.product)
            + half(formats.length_squared);
        Moved { by, least, angle: 2.0 * (chord_turned / 2.0).min(1.0).asin(), past, of_square }
    }

    /// q as it comes is no less, if it is known to be above what 1/√q ends at.
    fn least_square(&self, formats: &DirectFormats) -> Option<f64> {
        let least = self.least * self.least - self.of_square;
        let sure = self.least > 0.0
            && least >= power_of_two(-2 * i64::from(formats.reciprocal.integer_bits));
        (sure && least > self.of_square).then_some(least)
    }

    /// By how much N·X of N as it is is off: the host sends the difference of rounded ends, and it
    /// is rounded itself.
    fn of_scalar(&self, formats: &DirectFormats) -> f64 {
        let half = |format: Format| 0.5 * format.ulp() + HOST_ERROR;
        (1.0 + 2.0 * self.past) * half(formats.component) + half(formats.cosine)
    }
}

/// What is known of the unit normal n = N/√q that cosines are taken of, whatever X.
#[derive(Clone, Copy, Debug)]
pub struct UnitNormal {
    /// By how much it is turned.
    angle: f64,
    /// By how much n·X is off beside that and the rounding of n·X.
    rest: f64,
}

impl UnitNormal {
    const UNKNOWN: UnitNormal = UnitNormal { angle: f64::INFINITY, rest: f64::INFINITY };

    /// Of normals no shorter than `shortest`, with a rounded 1/√q.
    ///
    /// # Error
    /// With ε for what q is off from that of N as it is, and x = ε/(m² - ε), √(1/q) is off by
    /// x/(2 - x) of itself, and by half a unit.
    pub fn new(t: &Sig, spread: &Sig, formats: &DirectFormats, shortest: f64) -> UnitNormal {
        let moved = Moved::new(t, spread, formats, shortest);
        let Some(least_square) = moved.least_square(formats) else { return UnitNormal::UNKNOWN };
        let x = moved.of_square / least_square;
        let stretch = x / (2.0 - x) + (1.0 + 2.0 * moved.past) * 0.5 * formats.reciprocal.ulp();
        UnitNormal {
            angle: moved.angle,
            rest: stretch + moved.of_scalar(formats) * (1.0 + stretch) / moved.least,
        }
    }

    /// With 1/d for 1/√q: the real scalar is r N·X/√q with r = √q/d, and r ≤ 1 since Newton's d is
    /// √q or more.
    ///
    /// # Error
    /// r cos x is itself the cosine of an angle, which turns no faster than x, since r² sin² x ≤
    /// 1 - r² cos² x. What is left is by how much r is off: with d off by e_d and so s - e_d or
    /// more, |N| by what N has moved, it is both over s - e_d, and half a unit of 1/d.
    pub fn by_newton(
        t: &Sig,
        q: &Sig,
        spread: &Sig,
        formats: &DirectFormats,
        newton: NewtonRoot,
    ) -> UnitNormal {
        let moved = Moved::new(t, spread, formats, newton.shortest);
        let Some(error) = newton.bound(q, formats).filter(|_| moved.least > 0.0) else {
            return UnitNormal::UNKNOWN;
        };
        let least_length = newton.shortest - error;
        let half_unit = (1.0 + 2.0 * moved.past) * 0.5 * formats.reciprocal.ulp();
        let stretch = (moved.by + error) / least_length + half_unit;
        UnitNormal {
            angle: moved.angle,
            rest: stretch + moved.of_scalar(formats) * (1.0 / least_length + half_unit),
        }
    }
}

/// p = N·X for X = L and V alike, linear in t. [lecture, eq. 4.3]
///
/// Both ends are rounded and t ≤ 1 + o, so N·X is no larger than 1 + 2o.
///
/// # Error
/// The host sends B·X - A·X of rounded scalars, so with those off by e and t' for what t comes out
/// as N·X is off by |1 - t'| e + t' e, and by what t' is off times the real difference, which is
/// that of the rounded scalars but for 2e.
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
            let past = (t.format().value(t.range().high) - 1.0).max(0.0);
            let (half_unit, apart) = (start.error_value(), delta.range().magnitude() * delta.ulp());
            let error =
                (1.0 + 2.0 * past) * half_unit + (apart + 2.0 * half_unit) * t.error_value();
            let linear = (&start + t * delta).stated_error_value(error).assumed(
                -1.0 - 2.0 * past,
                1.0 + 2.0 * past,
                "|N.X| <= 1",
            );
            linear.rounded(formats.cosine.fraction_bits).named("linear")
        },
    )
}

/// p s with s = 1/√q, kept within -1 to 1. [lecture, eq. 4.3]
///
/// # Error
/// That of [`UnitNormal`], and half a unit.
pub fn direct_cosine(
    b: &Builder,
    p: &Sig,
    s: &Sig,
    formats: &DirectFormats,
    normal: UnitNormal,
) -> Sig {
    b.unit("cosine", "c = p/sqrt(q) [lecture, eq. 4.3]", (("p", p), ("s", s)), |_, (p, s)| {
        let rest = normal.rest + 0.5 * formats.cosine.ulp() + HOST_ERROR;
        let cosine = (p * s)
            .rounded(formats.cosine.fraction_bits)
            .clamped_below(-1)
            .clamped_above(1)
            .named("cosine");
        // Where N may vanish, its real length does not end at 2^-m as 1/√q does, so propagation
        // through that says nothing.
        match rest.is_finite() {
            true => cosine.known_cosine(normal.angle, rest),
            false => cosine.stated_error_value(2.0),
        }
    })
}

/// p/q, which with another p makes p p/q of any length of N: |p/q| ≤ 1/√q ≤ 2^m. [lecture, eq. 4.5]
pub fn over_square(b: &Builder, p: &Sig, q: &Sig, smallest_q: f64, formats: &DirectFormats) -> Sig {
    b.unit("over_square", "k = p/q [lecture, eq. 4.5]", (("p", p), ("q", q)), |b, (p, q)| {
        let Format { integer_bits, fraction_bits, .. } = formats.reciprocal;
        let to = QuotientFormat { integer_bits: 2 * integer_bits, fraction_bits };
        let reciprocal =
            quotient(b, &b.integer(1), &at_least(b, &q, 2 * integer_bits), to, smallest_q);
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

/// What is known of a product that stands for J K of the unit normal.
#[derive(Clone, Copy, Debug)]
pub struct Product {
    /// By how much the normal is turned.
    angle: f64,
    /// By how much twice the product is off beside that.
    rest: f64,
}

impl Product {
    /// Of J and K themselves, if they are known.
    pub fn of_cosines([j, k]: [&Sig; 2]) -> Option<Product> {
        let (ErrorForm::OfCosine { angle, rest: r_j }, ErrorForm::OfCosine { rest: r_k, .. }) =
            (j.error_form(), k.error_form())
        else {
            return None;
        };
        Some(Product { angle, rest: 2.0 * (r_j + r_k + r_j * r_k) })
    }

    /// Of p_L and p_V/q.
    ///
    /// # Error
    /// For N as it is, no shorter than m, p is off by e_p and 1/q by ε/(m² - ε) of itself and half
    /// a unit. So p_V/q is off by e_k = e_p max 1/q + ε/(m² - ε)/m, and these half units, and with
    /// |p_L| ≤ |N| the product by |N| e_k + e_p (1/m + e_k).
    pub fn with_quotient(
        t: &Sig,
        spread: &Sig,
        formats: &DirectFormats,
        shortest: f64,
    ) -> Option<Product> {
        let moved = Moved::new(t, spread, formats, shortest);
        let least_square = moved.least_square(formats)?;
        let (longest, half) = (1.0 + 2.0 * moved.past, |format: Format| 0.5 * format.ulp());
        let e_p = moved.of_scalar(formats);
        let largest = 1.0 / least_square + half(formats.reciprocal);
        let of_reciprocal =
            moved.of_square / least_square / moved.least + longest * half(formats.reciprocal);
        let e_k = e_p * largest + of_reciprocal + half(formats.cosine);
        Some(Product {
            angle: moved.angle,
            rest: 2.0 * (longest * e_k + e_p * (1.0 / moved.least + e_k)),
        })
    }
}

/// What the base of the highlight is made of.
pub struct DirectedBase<'a> {
    /// J and K, or p_L and p_V/q.
    pub factors: [&'a Sig; 2],
    /// What is known of their product.
    pub known: Option<Product>,
    /// L·V.
    pub light_dot_view: &'a Sig,
    /// q.
    pub q: &'a Sig,
    /// No real q is smaller.
    pub smallest_q: f64,
}

/// 2 J K - L·V, kept within 0 to 1, and 0 where q ≤ 0; a q that may be rounded to 0 though it is
/// not makes all of it unsure. [lecture, eq. 4.5; methods A7]
///
/// # Error
/// As that of [`reflected_cosine`](super::reflected_cosine), with V and L as they are.
pub fn directed_base(b: &Builder, of: DirectedBase, fraction_bits: u32) -> Sig {
    let [j, k] = of.factors;
    let inputs =
        (("n_dot_l", j), ("n_dot_v", k), ("light_dot_view", of.light_dot_view), ("q", of.q));
    b.unit(
        "specular_base",
        "b = max(2 J K - L.V, 0) [lecture, eq. 4.5]",
        inputs,
        |b, (j, k, light_dot_view, q)| {
            let base = (&j * &k).doubled() - &light_dot_view;
            let rounding = half_unit_where_narrowed(&base, fraction_bits);
            let base = base.rounded(fraction_bits).at_least_zero().clamped_above(1);
            let error = base.error_value();
            let chosen = b.integer(0).less_than(&q).choose(&base, &b.integer(0)).named("base");
            match of.known.filter(|_| of.smallest_q - q.error_value() > 0.0) {
                Some(Product { angle, rest }) => chosen
                    .stated_error_value(error)
                    .known_cosine(2.0 * angle, rest + light_dot_view.error_value() + rounding),
                None => chosen.stated_error_value(1.0),
            }
        },
    )
}

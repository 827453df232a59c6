//! Squared length and scalars of a normal between unit ends, from t alone.
use specula_scene::Format;
use specula_scene::format::power_of_two;
use specula_scene::spec::direct::DirectFormats;

use super::HOST_ERROR;
use super::interpolate::{chord, overshoot};
use super::unit_vectors::half_unit_where_narrowed;
use crate::builder::{Builder, Sig};
use crate::design::ErrorForm;

/// t = i/S of at most `steps` + 1 pixels, 0 to 1 and what rounding of the step leads past it.
pub fn parameter(b: &Builder, first: &Sig, step: &Sig, formats: &DirectFormats, steps: u32) -> Sig {
    b.unit("parameter", "t(i) = i/S", (("start", first), ("weight_step", step)), |b, (first, step)| {
        let slack = f64::from(steps) * formats.weight_accumulator.ulp();
        let t = Sig::accumulated(&first, &b.integer(0), &step, (0.0, 1.0 + slack), steps, "0 <= t <= 1");
        let most = 1.0 + overshoot(formats.weight_accumulator, formats.weight, steps);
        t.rounded(formats.weight.fraction_bits).assumed(0.0, most, "0 <= t <= 1").named("t")
    })
}

/// q = 1 - κ t (1 - t), the squared length of (1 - t) A + t B for unit A and B with κ = |B - A|². [lecture, eq. 4.4; METHODS A6]
///
/// t (1 - t) ≤ 1/4 and κ ≤ 4, so q ≥ 0 but for what t (1 - t) is rounded by, four times, and q itself.
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
            let q = (b.integer(1) - spread * product).assumed(-slack, 1.0 + 4.0 * below + slack, "0 <= q <= 1");
            q.rounded(formats.length_squared.fraction_bits).named("q")
        },
    )
}

/// What is known of the unit normal n = N/√q that cosines are taken of, whatever X.
///
/// # Error
/// A parameter off by e_t leaves N on its line, |B - A| e_t further. So with s for the shortest N and m = s - |B - A| e_t, n turns by an angle
/// whose chord is |B - A| e_t/√(s m). q is that of this N but for ε, what rounding adds: that of κ times t (1 - t), which is 1/4 at most, that of the
/// product times κ, and its own. With x = ε/(m² - ε), √(1/q) is off by x/(2 - x) of itself, and by half a unit.
#[derive(Clone, Copy, Debug)]
pub struct UnitNormal {
    /// By how much it is turned.
    angle: f64,
    /// By how much 1/√q is off, relative to the length of N as it is.
    stretch: f64,
    /// The largest 1/√q.
    largest_reciprocal: f64,
}

impl UnitNormal {
    /// Of normals no shorter than `shortest`.
    pub fn new(t: &Sig, spread: &Sig, formats: &DirectFormats, shortest: f64) -> UnitNormal {
        const UNKNOWN: UnitNormal = UnitNormal { angle: f64::INFINITY, stretch: f64::INFINITY, largest_reciprocal: f64::INFINITY };
        let moved = chord(shortest) * t.error_value();
        let least = shortest - moved;
        let half = |format: Format| 0.5 * format.ulp();
        let spread_range = spread.range().high as f64 * spread.ulp();
        let kappa = spread_range.min(chord(shortest).powi(2) + half(formats.spread));
        let past = (t.format().value(t.range().high) - 1.0).max(0.0);
        let t_by_rest = 0.25 + past * (1.0 + past);
        let of_q = t_by_rest * half(formats.spread) + kappa * half(formats.product) + half(formats.length_squared);
        let least_q = least * least - of_q;
        if least <= 0.0 || least_q < power_of_two(-2 * i64::from(formats.reciprocal.integer_bits)) || least_q <= of_q {
            return UNKNOWN;
        }
        let x = of_q / least_q;
        let chord = moved / (shortest * least).sqrt();
        let stretch = x / (2.0 - x) + (1.0 + 2.0 * past) * half(formats.reciprocal);
        UnitNormal { angle: 2.0 * (chord / 2.0).min(1.0).asin(), stretch, largest_reciprocal: (1.0 + stretch) / least }
    }
}

/// N·X/√q for X = L and V alike, kept within -1 to 1: linear in t, times s = 1/√q. [lecture, eq. 4.3]
///
/// Both ends are rounded and t ≤ 1 + o, so N·X is no larger than 1 + 2o.
///
/// # Error
/// The host sends the difference of rounded ends, so that N·X of N as it is comes out off by (1 + 2o) times half a unit and half of its
/// own; times 1/√q. What 1/√q is off by and half a unit come on top, beside the angle by which n is turned.
pub fn direct_cosine(b: &Builder, t: &Sig, [start, delta]: [&Sig; 2], s: &Sig, formats: &DirectFormats, normal: UnitNormal) -> Sig {
    let inputs = (("t", t), ("at_start", start), ("delta", delta), ("s", s));
    b.unit("cosine", "N.X/sqrt(q), N.X = A.X + t (B.X - A.X) [lecture, eq. 4.3]", inputs, |_, (t, start, delta, s)| {
        let fraction_bits = formats.cosine.fraction_bits;
        let past = (t.format().value(t.range().high) - 1.0).max(0.0);
        let linear = (start + t * delta).assumed(-1.0 - 2.0 * past, 1.0 + 2.0 * past, "|N.X| <= 1");
        let linear = linear.rounded(fraction_bits).named("linear");
        let half = |format: Format| 0.5 * format.ulp() + HOST_ERROR;
        let of_linear = (1.0 + 2.0 * past) * half(formats.component) + half(formats.cosine);
        let rest = normal.stretch + of_linear * normal.largest_reciprocal + half(formats.cosine);
        let cosine = (linear * s).rounded(fraction_bits).clamped_below(-1).clamped_above(1);
        let cosine = cosine.named("cosine");
        // Where N may vanish, its real length does not end at 2^-m as 1/√q does, so propagation through that says nothing.
        match rest.is_finite() {
            true => cosine.known_cosine(normal.angle, rest),
            false => cosine.stated_error_value(2.0),
        }
    })
}

/// 2 J K - L·V, kept within 0 to 1, and 0 where q ≤ 0; a q that may be rounded to 0 though it is not makes all of it unsure.
/// [lecture, eq. 4.5; METHODS A7]
///
/// # Error
/// As that of [`reflected_cosine`](super::reflected_cosine), with V and L as they are.
pub fn directed_base(b: &Builder, [j, k]: [&Sig; 2], light_dot_view: &Sig, q: &Sig, smallest_q: f64, fraction_bits: u32) -> Sig {
    let inputs = (("n_dot_l", j), ("n_dot_v", k), ("light_dot_view", light_dot_view), ("q", q));
    b.unit("specular_base", "b = max(2 J K - L.V, 0) [lecture, eq. 4.5]", inputs, |b, (j, k, light_dot_view, q)| {
        let sure = smallest_q - q.error_value() > 0.0;
        let base = (&j * &k).doubled() - &light_dot_view;
        let rounding = half_unit_where_narrowed(&base, fraction_bits);
        let base = base.rounded(fraction_bits).at_least_zero().clamped_above(1);
        let error = base.error_value();
        let chosen = b.integer(0).less_than(&q).choose(&base, &b.integer(0)).named("base");
        match [&j, &k].map(Sig::error_form) {
            _ if !sure => chosen.stated_error_value(1.0),
            [ErrorForm::OfCosine { angle, rest: r_j }, ErrorForm::OfCosine { rest: r_k, .. }] => {
                let rest = 2.0 * (r_j + r_k + r_j * r_k) + light_dot_view.error_value() + rounding;
                chosen.stated_error_value(error).known_cosine(2.0 * angle, rest)
            }
            _ => chosen.stated_error_value(error),
        }
    })
}

//! Squared length and scalars of a normal between unit ends, from t alone.
use specula_scene::spec::direct::DirectFormats;

use super::interpolate::overshoot;
use crate::builder::{Builder, Sig};

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

/// N·X/√q for X = L and V alike, kept within -1 to 1: linear in t, times s = 1/√q. [lecture, eq. 4.3]
///
/// Both ends are rounded and t ≤ 1 + o, so N·X is no larger than 1 + 2o.
pub fn direct_cosine(b: &Builder, t: &Sig, [start, delta]: [&Sig; 2], s: &Sig, formats: &DirectFormats) -> Sig {
    let inputs = (("t", t), ("at_start", start), ("delta", delta), ("s", s));
    b.unit("cosine", "N.X/sqrt(q), N.X = A.X + t (B.X - A.X) [lecture, eq. 4.3]", inputs, |_, (t, start, delta, s)| {
        let fraction_bits = formats.cosine.fraction_bits;
        let past = (t.format().value(t.range().high) - 1.0).max(0.0);
        let linear = (start + t * delta).assumed(-1.0 - 2.0 * past, 1.0 + 2.0 * past, "|N.X| <= 1");
        let linear = linear.rounded(fraction_bits).named("linear");
        (linear * s).rounded(fraction_bits).clamped_below(-1).clamped_above(1).named("cosine")
    })
}

/// 2 J K - L·V, kept within 0 to 1, and 0 where q ≤ 0; a q that may be rounded to 0 though it is not makes all of it unsure.
/// [lecture, eq. 4.5; METHODS A7]
pub fn directed_base(b: &Builder, [j, k]: [&Sig; 2], light_dot_view: &Sig, q: &Sig, smallest_q: f64, fraction_bits: u32) -> Sig {
    let inputs = (("n_dot_l", j), ("n_dot_v", k), ("light_dot_view", light_dot_view), ("q", q));
    b.unit("specular_base", "b = max(2 J K - L.V, 0) [lecture, eq. 4.5]", inputs, |b, (j, k, light_dot_view, q)| {
        let sure = smallest_q - q.error_value() > 0.0;
        let base = (j * k).doubled() - light_dot_view;
        let base = base.rounded(fraction_bits).at_least_zero().clamped_above(1);
        let chosen = b.integer(0).less_than(&q).choose(&base, &b.integer(0));
        let error = if sure { base.error_value() } else { 1.0 };
        chosen.stated_error_value(error).named("base")
    })
}

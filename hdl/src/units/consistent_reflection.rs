//! Reflections that never point into the surface.
use specula_scene::Format;
use specula_scene::spec::consistent::ConsistentFormats;

use super::divider::divider;
use super::square_root::square_root;
use crate::builder::{Builder, Off, Sig, Vector};

/// What is known of the real values, for error bounds alone.
#[derive(Clone, Copy, Debug)]
pub struct Consistency {
    /// The smallest q there is.
    pub least_q: f64,
    /// The smallest 1 + N·I for which the reflection counts.
    pub least_divisor: f64,
}

/// r = (g + ρb)N - ρI with b = N·I, g = 1 + q(b - 1) and ρ = √(q(1 + g)/(1 + b)) ≤ 1; and whether I is above the horizon that α leaves,
/// g + b > 0. [Reshetov, Soupikov and Mark; METHODS D]
///
/// # Error
/// r = gN + ρ(bN - I). g n is off by e_n + e_g and ρ(b n - I) by e_n + e_b + e_I with the true ρ; rounding g + ρb and r adds half units, and
/// what ρ is off by counts as often as bN - I is long: see [`of_sine_ratio`].
pub fn consistent_reflection(
    b: &Builder,
    n: &Vector,
    incoming: &Vector,
    q: &Sig,
    formats: &ConsistentFormats,
    known: Consistency,
) -> (Vector, Sig) {
    let inputs = (("n", n), ("incoming", incoming), ("q", q));
    b.unit("consistent_reflection", "r = (g + rho b) N - rho I [Reshetov et al.]", inputs, |b, (n, incoming, q)| {
        let fraction_bits = formats.cosine.fraction_bits;
        let one = b.integer(1);
        let lengths = (n.longest(), 1.0 + formats.vector.ulp());
        let cosine = n.dot_within(&incoming, lengths, "|N.I| <= |N||I|").rounded(fraction_bits);
        let cos_beta = cosine.clamped_below(-1).clamped_above(1).named("cos_beta");
        let cos_gamma = (&one + &q * (&cos_beta - &one)).rounded(fraction_bits).named("cos_gamma");
        let above_horizon = b.integer(0).less_than(&(&cos_gamma + &cos_beta)).named("above_horizon");

        let (dividend, divisor) = (&q * (&one + &cos_gamma), (&one + &cos_beta).named("one_plus_cos_beta"));
        let operands = dividend.error_value() + divisor.error_value();
        let ratio_bits = formats.sine_ratio_squared.fraction_bits;
        let squared = divider(b, &dividend, &divisor, ratio_bits, known.least_divisor);
        let rho = square_root(b, &squared, formats.sine_ratio.fraction_bits).named("rho");

        let e_rho = of_sine_ratio(operands, divisor.error_value(), formats, known);
        let (e_n, e_i) = (n.largest_error(), incoming.largest_error());
        let roundings = 0.5 * formats.cosine.ulp() * lengths.0;
        let error = 2.0 * e_n + cos_gamma.error_value() + cos_beta.error_value() + e_i + e_rho + roundings;

        let share = (&cos_gamma + &rho * &cos_beta).rounded(fraction_bits).named("normal_share");
        let r = &n.scaled(&share) - &incoming.scaled(&rho);
        // Whatever they are, components are no further apart than the longest of both are long.
        let apart = 1.0 + r.longest();
        let off = of_reflection([&n, &incoming], &q, formats, known).unwrap_or(Off::within(3f64.sqrt() * error.min(apart)));
        let r = r.map(|component| component.clone().stated_error_value(error.min(apart).min(off.length))).proven_off(off);
        (r.rounded(formats.vector.fraction_bits).named("r"), above_horizon)
    })
}

/// How far the reflection is off as a whole where it is known to turn with the normal; the last rounding apart.
///
/// Let m and J be the directions of n and I as they come, turned by a and a_I, and σ, σ_I what their lengths are off. r is compared with the
/// reflection of J about m with q as it comes, and that with the real one.
///
/// Roundings: b is off by r_b = (1 + σ)(1 + σ_I) - 1 + u/2, g by r_g = r_b + u/2. With w = 1 + b no less than w_0, and ρ² = q(1 + g)/w, clamped
/// to 1, off by (q r_g + ρ² r_b)/(w - r_b) and half a unit u', the root is off by that over ρ, or less where both are clamped. 1 + g ≥ w makes
/// ρ² ≥ q² and ρ² ≥ q, so q/ρ ≤ 1; and |bm - J| ≤ √(2w). So what ρ is off by moves r by √(2/w_0) (r_g + r_b)/(1 - r_b/w_0) + u'/√q. What
/// n and I are too long adds r_g (1 + σ) + σ and r_b (1 + σ) + σ + σ_I, and rounding g + ρb half a unit.
///
/// Turns: with sin(γ/2) = √q sin(β/2), γ' ≤ √q, so that r turns by 2a and a_I at most, and by dγ/dq = sin(β/2)/(√q cos(γ/2)) ≤ 1/√(q w_0/2).
/// Where ρ is clamped, β is beyond a right angle and g + b ≤ 0: r = (g + b)N - I has |r|² = 1 + g² - b² ≥ 1 - b_0² with -b_0 the least b, and
/// moves by (2 + 2b_0) a + 3 a_I + 2 e_q at most, of which 2 b_0 (a + a_I + e_q) over |r| makes it longer or shorter.
fn of_reflection([n, incoming]: [&Vector; 2], q: &Sig, formats: &ConsistentFormats, known: Consistency) -> Option<Off> {
    let (a, sigma) = (n.off().angle(), n.off().stretch());
    let (a_i, sigma_i) = (incoming.off().angle(), incoming.off().stretch());
    let e_q = q.error_value();
    let (w, least_q) = (known.least_divisor - a - a_i, known.least_q - e_q);
    let half_unit = 0.5 * formats.cosine.ulp();
    let r_b = (1.0 + sigma) * (1.0 + sigma_i) - 1.0 + half_unit;
    let r_g = r_b + half_unit;
    let b_0 = (1.0 - w).max(0.0);
    if !(w > 2.0 * r_b && least_q > 0.0 && b_0 < 0.9) {
        return None;
    }
    let shortest = (1.0 - b_0 * b_0).sqrt();
    let of_square = (2.0 / w).sqrt() * (r_g + r_b) / (1.0 - r_b / w) + formats.sine_ratio_squared.ulp() / least_q.sqrt();
    let of_root = of_square + 0.5 * formats.sine_ratio.ulp();
    let of_lengths = r_g * (1.0 + sigma) + sigma + r_b * (1.0 + sigma) + sigma + sigma_i;
    let along = 2.0 * b_0 * (a + a_i + e_q) / shortest;
    let rest = of_root + of_lengths + half_unit * (1.0 + sigma) + along;
    let turned = (2.0 + 2.0 * b_0) * a + 3.0 * a_i + e_q * (least_q * w / 2.0).sqrt().recip().max(2.0);
    Some(Off { length: turned + rest, across: (turned + rest) / shortest, along: rest + turned * turned / 2.0 })
}

/// What the error of ρ adds to a component of ρ(bN - I), with E for the errors of q(1 + g) and of w = 1 + b together and u for half a unit
/// of the last place of ρ².
///
/// |bN - I| ≤ √(1 - b²) ≤ √(2w), and ρ² is off by δ ≤ E/(w - e_w) + u. So ρ is off by √δ, and by δ/ρ ≤ δ/q at most, since 1 + g ≥ q(1 + b).
/// - Where w ≥ 2 e_w, w - e_w ≥ w/2 and √(2w) √δ ≤ √(4E + 4u); where w is smaller, √(2w) ≤ √(4E) and ρ is off by 1 at most.
/// - Where w is no less than some w_0 > e_w, √(2w) δ/q ≤ (√(2/w_0) E/(1 - e_w/w_0) + 2u)/q.
fn of_sine_ratio(operands: f64, e_w: f64, formats: &ConsistentFormats, known: Consistency) -> f64 {
    let Consistency { least_q: q, least_divisor: w } = known;
    let half_unit = 0.5 * formats.sine_ratio_squared.ulp();
    let anywhere = (4.0 * operands + 4.0 * half_unit).sqrt();
    let far = ((2.0 / w).sqrt() * operands / (1.0 - e_w / w) + 2.0 * half_unit) / q;
    let error = if q > 0.0 && w > 2.0 * e_w { anywhere.min(far) } else { anywhere };
    error + 0.5 * formats.sine_ratio.ulp()
}

/// N_c·I = |I + r|/2 with r the reflection of I, and 0 for an I below the horizon or a normal without direction.
/// [Reshetov, Soupikov and Mark; METHODS D]
///
/// # Error
/// The length of a vector is off by no more than the vector. At the horizon (N_c·L)² ≤ (g + b)/2, so that where rounding decides
/// which side of it I is on, √((e_g + e_b)/2) at most is lost; what g + b is off by is no more than twice q's error and twice b's.
pub fn consistent_cosine(
    b: &Builder,
    mirror: (&Vector, &Sig, &Sig),
    incoming: &Vector,
    (formats, to): (&ConsistentFormats, Format),
    least_q: f64,
) -> Sig {
    let (n, q, has_direction) = mirror;
    let inputs = (("n", n), ("q", q), ("has_direction", has_direction), ("incoming", incoming));
    b.unit("consistent_cosine", "c = |I + r|/2 [Reshetov et al.]", inputs, |b, (n, q, has_direction, incoming)| {
        let e_b = (n.off().length + incoming.off().length) * 2.0 + formats.cosine.ulp();
        let horizon = 2.0 * q.error_value() + 2.0 * e_b + formats.cosine.ulp();
        // Above the horizon 1 + b > 2q/(1 + q) ≥ q.
        let known = Consistency { least_q, least_divisor: (least_q - horizon).max(0.0) };
        let (r, above_horizon) = consistent_reflection(b, &n, &incoming, &q, formats, known);
        let sum = &incoming + &r;
        let gate = if has_direction.error() > 0.0 { 1.0 } else { (horizon / 2.0).sqrt() };
        let error = 0.5 * (incoming.off().length + r.off().length) + 0.5 * to.ulp() + gate;
        let quarter = sum.length_squared().times_power_of_two(-2).clamped_above(1).named("quarter");
        let root = square_root(b, &quarter, to.fraction_bits);
        let lit = above_horizon.and(&has_direction).choose(&root, &b.integer(0)).clamped_above(1);
        lit.stated_error_value(error.min(1.0)).named("cosine")
    })
}

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

/// r = (g + ρb)N - ρI with b = N·I, g = 1 + q(b - 1) and ρ = √(q(1 + g)/(1 + b)) ≤ 1; and whether I
/// is above the horizon that α leaves, g + b > 0. [Reshetov, Soupikov and Mark; methods D]
///
/// # Error
/// r = gN + ρ(bN - I). g n is off by e_n + e_g and ρ(b n - I) by e_n + e_b + e_I with the true ρ;
/// rounding g + ρb and r adds half units, and what ρ is off by counts as often as bN - I is long:
/// see [`of_sine_ratio`].
pub fn consistent_reflection(
    b: &Builder,
    n: &Vector,
    incoming: &Vector,
    q: &Sig,
    formats: &ConsistentFormats,
    known: Consistency,
) -> (Vector, Sig) {
    let inputs = (("n", n), ("incoming", incoming), ("q", q));
    b.unit(
        "consistent_reflection",
        "r = (g + rho b) N - rho I [Reshetov et al.]",
        inputs,
        |b, (n, incoming, q)| {
            let fraction_bits = formats.cosine.fraction_bits;
            let one = b.integer(1);
            let lengths = (n.longest(), 1.0 + formats.vector.ulp());
            let cosine = n.dot_within(&incoming, lengths, "|N.I| <= |N||I|").rounded(fraction_bits);
            let cos_beta = cosine.clamped_below(-1).clamped_above(1).named("cos_beta");
            let cos_gamma =
                (&one + &q * (&cos_beta - &one)).rounded(fraction_bits).named("cos_gamma");
            let above_horizon =
                b.integer(0).less_than(&(&cos_gamma + &cos_beta)).named("above_horizon");

            let (dividend, divisor) =
                (&q * (&one + &cos_gamma), (&one + &cos_beta).named("one_plus_cos_beta"));
            let operands = dividend.error_value() + divisor.error_value();
            let ratio_bits = formats.sine_ratio_squared.fraction_bits;
            let squared = divider(b, &dividend, &divisor, ratio_bits, known.least_divisor);
            let rho = square_root(b, &squared, formats.sine_ratio.fraction_bits).named("rho");

            let e_rho = of_sine_ratio(operands, divisor.error_value(), formats, known);
            let (e_n, e_i) = (n.largest_error(), incoming.largest_error());
            let roundings = 0.5 * formats.cosine.ulp() * lengths.0;
            let error = 2.0 * e_n
                + cos_gamma.error_value()
                + cos_beta.error_value()
                + e_i
                + e_rho
                + roundings;

            let share =
                (&cos_gamma + &rho * &cos_beta).rounded(fraction_bits).named("normal_share");
            let r = &n.scaled(&share) - &incoming.scaled(&rho);
            // Whatever they are, components are no further apart than the longest of both are long.
            let apart = 1.0 + r.longest();
            let off = of_reflection([&n, &incoming], &q, formats, known)
                .unwrap_or(Off::within(3f64.sqrt() * error.min(apart)));
            let r = r
                .map(|component| {
                    component.clone().stated_error_value(error.min(apart).min(off.length))
                })
                .proven_off(off);
            (r.rounded(formats.vector.fraction_bits).named("r"), above_horizon)
        },
    )
}

/// How far the reflection is off as a whole where it is known to turn with the normal; the last
/// rounding apart.
///
/// Let m and J be the directions of n and I as they come, turned by a and a_I, and σ, σ_I what
/// their lengths are off. r is compared with the reflection of J about m with q as it comes, and
/// that with the real one.
///
/// Roundings: [`Rounded`] bounds how far this moves r as a whole, and along r.
///
/// Turns: with sin(γ/2) = √q sin(β/2), γ' ≤ √q, so that r turns by 2a and a_I at most, and by
/// dγ/dq = sin(β/2)/(√q cos(γ/2)) ≤ 1/√(q w_0/2). Where ρ is clamped, β is beyond a right angle and
/// g + b ≤ 0: r = (g + b)N - I has |r|² = 1 + g² - b² ≥ 1 - b_0² with -b_0 the least b, and moves
/// by (2 + 2b_0) a + 3 a_I + 2 e_q at most, of which 2 b_0 (a + a_I + e_q) over |r| makes it longer
/// or shorter. What roundings move along the one reflection is along the other but for the angle
/// between them.
fn of_reflection(
    [n, incoming]: [&Vector; 2],
    q: &Sig,
    formats: &ConsistentFormats,
    known: Consistency,
) -> Option<Off> {
    let (a, a_i) = (n.off().angle(), incoming.off().angle());
    let e_q = q.error_value();
    let half_units = [formats.cosine, formats.sine_ratio_squared, formats.sine_ratio]
        .map(|format| 0.5 * format.ulp());
    let least = [known.least_divisor - a - a_i, known.least_q - e_q];
    let rounded = Rounded::new([n, incoming].map(|v| v.off().stretch()), half_units, least)?;
    let Rounded { w, q: least_q, b_0, shortest, .. } = rounded;
    let clamped = 2.0 * b_0 * (a + a_i + e_q) / shortest;
    let rest = rounded.length() + clamped;
    let turned =
        (2.0 + 2.0 * b_0) * a + 3.0 * a_i + e_q * (least_q * w / 2.0).sqrt().recip().max(2.0);
    let along = rounded.along() + clamped + rest * turned / shortest + turned * turned / 2.0;
    Some(Off {
        length: turned + rest,
        across: (turned + rest) / shortest,
        along: along.min(rest + turned * turned / 2.0),
        free: 0.0,
    })
}

/// What lengths and roundings move the reflection r of J about m by, two unit vectors whose b = m·J
/// is -b_0 or more, with q as it comes.
///
/// Let n and I be longer than m and J by the factors 1 + σ and 1 + σ_I, τ = (1 + σ)(1 + σ_I) - 1,
/// and u half a unit of cosines' last place. What is computed, with primes, is b' off by δ_b, |δ_b|
/// ≤ |b| τ + u; g' off by δ_g = q δ_b + η, |η| ≤ u; the share s' = g' + ρ'b' + ε, |ε| ≤ u; and r' =
/// s'n - ρ'I. So with δ_ρ = ρ' - ρ
///
///   r' - r = (δ_g + ρ'δ_b + ε + σ s') m + δ_ρ (b m - J) - ρ' σ_I J.
///
/// ρ² = q(1 + g)/w with w = 1 + b is off by ((q² - ρ²) δ_b + q η)/(w + δ_b) and by v, half a unit
/// of its last place; since q² and q are ρ² at most, and ρ² 1, that is |δ_b| + u over w - |δ_b|,
/// and relative to ρ² no more than x = (|δ_b| + u)/(w - |δ_b|) + v/q. Clamping both squares to 1
/// brings them no further apart, and for a ρ² beyond 1 the same holds with 1 in its place. The root
/// moves by what its square does over ρ + ρ' ≥ ρ/κ, κ = 1/(1 + √(1 - x)); and by its own rounding.
#[derive(Clone, Copy, Debug)]
struct Rounded {
    /// σ, σ_I and τ.
    sigma: f64,
    sigma_i: f64,
    tau: f64,
    /// u.
    half_unit: f64,
    /// Half a unit of the last place of ρ² and of ρ.
    of_squared: f64,
    of_root: f64,
    /// The smallest w and q there are.
    w: f64,
    q: f64,
    /// -b_0 is the smallest b there is, if that is negative.
    b_0: f64,
    /// √(1 - b_0²), as short as r is at most.
    shortest: f64,
    /// x and κ.
    x: f64,
    kappa: f64,
}

impl Rounded {
    /// None where too little is known of w or q; half units are those of cosines, ρ² and ρ.
    fn new(
        [sigma, sigma_i]: [f64; 2],
        [half_unit, of_squared, of_root]: [f64; 3],
        [w, q]: [f64; 2],
    ) -> Option<Rounded> {
        let tau = (1.0 + sigma) * (1.0 + sigma_i) - 1.0;
        let (e_b, b_0) = (tau + half_unit, (1.0 - w).max(0.0));
        let x = (e_b + half_unit) / (w - e_b) + of_squared / q;
        if !(w > 2.0 * e_b && q > 0.0 && b_0 < 0.9 && x < 1.0) {
            return None;
        }
        let (shortest, kappa) = ((1.0 - b_0 * b_0).sqrt(), 1.0 / (1.0 + (1.0 - x).sqrt()));
        Some(Rounded {
            sigma,
            sigma_i,
            tau,
            half_unit,
            of_squared,
            of_root,
            w,
            q,
            b_0,
            shortest,
            x,
            kappa,
        })
    }

    /// What r is off by as a whole.
    ///
    /// |bm - J| ≤ √(2w) and ρ ≥ √q: what ρ is off by moves r by κ (√(2/w) (|δ_b| + u)/(1 - |δ_b|/w) + 2v/√q) and by 2 times its rounding, as √(2w) ≤ 2.
    fn length(self) -> f64 {
        let Rounded { sigma, sigma_i, tau, half_unit: u, w, q, kappa, .. } = self;
        let e_b = tau + u;
        let of_rho = kappa
            * ((2.0 / w).sqrt() * (e_b + u) / (1.0 - e_b / w) + 2.0 * self.of_squared / q.sqrt())
            + 2.0 * self.of_root;
        (e_b + u) + e_b + u + sigma * (2.0 + self.second_order()) + sigma_i + of_rho
    }

    /// |s'| is no larger than 1 + |b| and this.
    fn second_order(self) -> f64 {
        2.0 * (self.tau + self.half_unit) + 2.0 * self.half_unit + self.x + self.of_root
    }

    /// What r is longer or shorter by, to first order in the turn that roundings are.
    ///
    /// m·r = g, |g| ≤ 1, and (bm - J)·r = ρ(1 - b²): what ρ is off by makes r longer or shorter by
    /// no more than κ (1 - b)(|δ_b| + u)/(1 - |δ_b|/w), κ v and the root's rounding. With λ =
    /// κ/(1 - |δ_b|/w), all that depends on b is no more than
    ///
    ///   τ(1 + 3|b|) + 4u + λ(1 - b)(|b|τ + 2u).
    ///
    /// From b = 0 on b(1 - b) ≤ 1 - b, which leaves something linear in b, largest at 0 or 1; below
    /// 0 it grows with |b|, and r may be shorter than 1.
    fn along(self) -> f64 {
        let Rounded { tau, half_unit: u, b_0, .. } = self;
        let lambda = self.kappa / (1.0 - (tau + u) / self.w);
        let anywhere = self.sigma * self.second_order()
            + self.sigma_i
            + self.kappa * self.of_squared
            + self.of_root;
        let upright = 4.0 * tau + 4.0 * u;
        let level = tau + 4.0 * u + lambda * (tau + 2.0 * u);
        let below =
            tau * (1.0 + 3.0 * b_0) + 4.0 * u + lambda * (1.0 + b_0) * (b_0 * tau + 2.0 * u);
        (upright.max(level) + anywhere).max((below + anywhere) / self.shortest)
    }
}

/// What the error of ρ adds to a component of ρ(bN - I), with E for the errors of q(1 + g) and of
/// w = 1 + b together and u for half a unit of the last place of ρ².
///
/// |bN - I| ≤ √(1 - b²) ≤ √(2w), and ρ² is off by δ ≤ E/(w - e_w) + u. So ρ is off by √δ, and by δ/ρ ≤ δ/q at most, since 1 + g ≥ q(1 + b).
/// - Where w ≥ 2 e_w, w - e_w ≥ w/2 and √(2w) √δ ≤ √(4E + 4u); where w is smaller, √(2w) ≤ √(4E)
///   and ρ is off by 1 at most.
/// - Where w is no less than some w_0 > e_w, √(2w) δ/q ≤ (√(2/w_0) E/(1 - e_w/w_0) + 2u)/q.
fn of_sine_ratio(operands: f64, e_w: f64, formats: &ConsistentFormats, known: Consistency) -> f64 {
    let Consistency { least_q: q, least_divisor: w } = known;
    let half_unit = 0.5 * formats.sine_ratio_squared.ulp();
    let anywhere = (4.0 * operands + 4.0 * half_unit).sqrt();
    let far = ((2.0 / w).sqrt() * operands / (1.0 - e_w / w) + 2.0 * half_unit) / q;
    let error = if q > 0.0 && w > 2.0 * e_w { anywhere.min(far) } else { anywhere };
    error + 0.5 * formats.sine_ratio.ulp()
}

/// N_c·I = |I + r|/2 with r the reflection of I, and 0 for an I below the horizon or a normal
/// without direction. [Reshetov, Soupikov and Mark; methods D]
///
/// # Error
/// The length of a vector is off by no more than the vector. At the horizon (N_c·L)² ≤ (g + b)/2,
/// so that where rounding decides which side of it I is on, √((e_g + e_b)/2) at most is lost; what
/// g + b is off by is no more than twice q's error and twice b's.
pub fn consistent_cosine(
    b: &Builder,
    mirror: (&Vector, &Sig, &Sig),
    incoming: &Vector,
    (formats, to): (&ConsistentFormats, Format),
    least_q: f64,
) -> Sig {
    let (n, q, has_direction) = mirror;
    let inputs = (("n", n), ("q", q), ("has_direction", has_direction), ("incoming", incoming));
    b.unit(
        "consistent_cosine",
        "c = |I + r|/2 [Reshetov et al.]",
        inputs,
        |b, (n, q, has_direction, incoming)| {
            let e_b = (n.off().length + incoming.off().length) * 2.0 + formats.cosine.ulp();
            let horizon = 2.0 * q.error_value() + 2.0 * e_b + formats.cosine.ulp();
            // Above the horizon 1 + b > 2q/(1 + q) ≥ q.
            let known = Consistency { least_q, least_divisor: (least_q - horizon).max(0.0) };
            let (r, above_horizon) = consistent_reflection(b, &n, &incoming, &q, formats, known);
            let sum = &incoming + &r;
            let gate = if has_direction.error() > 0.0 { 1.0 } else { (horizon / 2.0).sqrt() };
            let error = 0.5 * (incoming.off().length + r.off().length) + 0.5 * to.ulp() + gate;
            let quarter =
                sum.length_squared().times_power_of_two(-2).clamped_above(1).named("quarter");
            let root = square_root(b, &quarter, to.fraction_bits);
            let lit =
                above_horizon.and(&has_direction).choose(&root, &b.integer(0)).clamped_above(1);
            lit.stated_error_value(error.min(1.0)).named("cosine")
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// J and its reflection in the plane of both, m along the second axis, computed with every
    /// rounding at its worst.
    fn off(b: f64, q: f64, of: Rounded, signs: [f64; 7]) -> ([f64; 2], [f64; 2]) {
        let [of_n, of_i, of_b, of_g, of_share, of_squared, of_root] = signs;
        let j = [(1.0 - b * b).sqrt(), b];
        let reflected = |b: f64, g: f64, rho: f64, [longer, longer_i]: [f64; 2], rounding: f64| {
            let share = g + rho * b + rounding;
            [-rho * longer_i * j[0], share * longer - rho * longer_i * j[1]]
        };
        let g = 1.0 + q * (b - 1.0);
        let squared = |b: f64, g: f64| (q * (1.0 + g) / (1.0 + b)).clamp(0.0, 1.0);
        let real = reflected(b, g, squared(b, g).sqrt(), [1.0, 1.0], 0.0);
        let (longer, longer_i) = (1.0 + of_n * of.sigma, 1.0 + of_i * of.sigma_i);
        let b = (b * longer * longer_i + of_b * of.half_unit).clamp(-1.0, 1.0);
        let g = 1.0 + q * (b - 1.0) + of_g * of.half_unit;
        let rho = ((squared(b, g) + of_squared * of.of_squared).clamp(0.0, 1.0).sqrt()
            + of_root * of.of_root)
            .min(1.0);
        (real, reflected(b, g, rho, [longer, longer_i], of_share * of.half_unit))
    }

    #[test]
    fn roundings_move_a_reflection_by_no_more_than_stated() {
        let signs =
            |bits: u32| std::array::from_fn(|i| if bits >> i & 1 == 1 { 1.0 } else { -1.0 });
        for (w, least_q) in [(1.0, 0.8), (0.7, 0.3), (0.4, 0.1)] {
            let of = Rounded::new([1e-3, 3e-4], [2e-4, 1e-5, 1e-4], [w, least_q]).unwrap();
            let (mut length, mut along) = (0.0_f64, 0.0_f64);
            for (i, j, bits) in (0..=50)
                .flat_map(|i| (0..=10).flat_map(move |j| (0..128).map(move |bits| (i, j, bits))))
            {
                let (b, q) = (
                    w - 1.0 + (2.0 - w) * f64::from(i) / 50.0,
                    least_q + (1.0 - least_q) * f64::from(j) / 10.0,
                );
                let (real, fixed) = off(b, q, of, signs(bits));
                let moved = [fixed[0] - real[0], fixed[1] - real[1]];
                length = length.max(moved[0].hypot(moved[1]));
                along = along
                    .max((moved[0] * real[0] + moved[1] * real[1]).abs() / real[0].hypot(real[1]));
            }
            println!(
                "w {w}: length {length:.3e} of {:.3e}, along {along:.3e} of {:.3e}",
                of.length(),
                of.along()
            );
            assert!(length <= of.length() && length > 0.4 * of.length());
            assert!(along <= of.along() && along > 0.7 * of.along());
        }
    }
}

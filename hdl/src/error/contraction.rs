//! How far the contraction of a consistent reflection is off.
use specula_datapath::bound::Bound;
use specula_spec::Format;
use specula_spec::consistent::LARGEST_ANGLE;

use super::host::HOST_ERROR;

/// The steepest slope |dq/dt| of both curves, at t = 0.
const STEEPEST: f64 = std::f64::consts::PI;

/// t along a span, which is rounded up so that it is never too small.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    /// The accumulated t is no larger.
    pub largest: f64,
    /// t is off by no more, once it is rounded up.
    pub error: f64,
}

/// t after `steps` steps at most.
///
/// Start and step are up to a unit u of the accumulator's last place too large each:
///
/// ```text
/// 0 ≤ t'(i) - t(i) ≤ (S + 1) u
/// ```
///
/// and rounding up adds less than a unit of its own.
pub fn angle(accumulator: Format, angle: Format, steps: u32) -> Angle {
    let accumulated = f64::from(steps + 1) * accumulator.ulp() + HOST_ERROR;
    Angle {
        largest: LARGEST_ANGLE + accumulator.ulp() + accumulated,
        error: accumulated + angle.ulp(),
    }
}

/// Bound on the error of q = (1 - t)²/(1 + κt), κ = 1169/1024, rounded down, of t
/// as it comes.
///
/// κ exceeds π - 2 by 8.91e-6, and
///
/// ```text
/// |∂q/∂κ| = t(1 - t)²/(1 + κt)² < 0.1
/// |∂q/∂t| ≤ π
/// ```
pub fn rational(t: Bound, contraction: Format) -> f64 {
    const OF_KAPPA: f64 = 8.91e-7;
    (STEEPEST * t.error + OF_KAPPA + contraction.ulp()).min(1.0)
}

/// Bound on the error of q = T² with T = u(1 - (1 - v) S(v)), u = 1 - t and v = u², T and q rounded
/// down, of t as it comes.
///
/// The polynomial is off by 1.45e-5. In units of the last place of T
///
/// ```text
/// v                    1
/// S, four steps        1 and 0.2 of v each     |S'| < 0.1
/// (1 - v) S            1 and 0.3 of v          |d((1 - v) S)/dv| < 0.3
/// T                    1
/// ```
///
/// make less than 7, and q = T² moves twice as far.
pub fn trigonometric(t: Bound, tangent: Format, contraction: Format) -> f64 {
    const OF_POLYNOMIAL: f64 = 1.45e-5;
    let of_tangent = OF_POLYNOMIAL + 7.0 * tangent.ulp();
    (STEEPEST * t.error + 2.0 * of_tangent + contraction.ulp()).min(1.0)
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;
    use std::f64::consts::{FRAC_PI_4, PI};

    use specula_datapath::bound::Interval;

    use super::*;

    /// How far t is off, and fraction bits of T and q.
    const CASES: [(f64, u32, u32); 3] = [(1e-3, 20, 20), (1e-6, 24, 8), (1e-6, 8, 24)];

    fn format(fraction_bits: u32) -> Format {
        Format::unsigned(1, fraction_bits)
    }

    /// The largest error of q over `bound`, t mostly near 0, where curves are steep.
    fn reached(
        t_error: f64,
        bound: f64,
        real: impl Fn(f64) -> f64,
        mut fixed: impl FnMut(f64, &mut Draw) -> f64,
    ) -> f64 {
        let mut draw = Draw::new(1);
        let mut reached = 0.0_f64;
        for _ in 0..50_000 {
            let t = draw.within(0.0, 1.0).powi(4);
            let moved = (t + draw.error(0.5 * t_error) + 0.5 * t_error).min(1.0);
            reached = reached.max((fixed(moved, &mut draw) - real(t)).abs() / bound);
        }
        reached
    }

    /// Some units of the last place, up or down from a value.
    fn up_to(draw: &mut Draw, ulp: f64) -> f64 {
        0.5 * ulp + draw.error(0.5 * ulp)
    }

    /// 99 % of the bound is reached, 78 % where what κ is off counts as much as t.
    #[test]
    fn rational_contractions_stay_within_the_bound_and_reach_it() {
        let curve = |t: f64, kappa: f64| (1.0 - t).powi(2) / (1.0 + kappa * t);
        for (t_error, _, bits) in CASES {
            let contraction = format(bits);
            let bound = rational(Bound::near(Interval::new(0.0, 1.0), t_error), contraction);
            let fixed = |t: f64, draw: &mut Draw| {
                curve(t, 1169.0 / 1024.0) - up_to(draw, contraction.ulp())
            };
            let reached = reached(t_error, bound, |t| curve(t, PI - 2.0), fixed);
            println!("{t_error}, {bits}: {reached}");
            assert!(reached <= 1.0 && reached > 0.75, "{t_error}, {bits}: {reached}");
        }
    }

    /// 98 % of the bound is reached, a third where T is rounded most: its roundings are at their worst
    /// at different t.
    #[test]
    fn trigonometric_contractions_stay_within_the_bound_and_reach_it() {
        const COEFFICIENTS: [i64; 4] = [225_028, 55_803, 13_064, 5_363];
        for ((t_error, bits, q_bits), least) in CASES.into_iter().zip([0.98, 0.98, 0.33]) {
            let (ulp, q_ulp) = (format(bits).ulp(), format(q_bits).ulp());
            let t = Bound::near(Interval::new(0.0, 1.0), t_error);
            let bound = trigonometric(t, format(bits), format(q_bits));
            let fixed = |t: f64, draw: &mut Draw| {
                let [s0, s1, s2, s3] = COEFFICIENTS.map(|s| s as f64 / f64::from(1 << 20));
                let mut up = |x: f64| x + up_to(draw, ulp);
                let u = 1.0 - t;
                let v = up(u * u - ulp);
                let sum = [s2, s1, s0].into_iter().fold(up(s3), |h, s| up(s + v * h));
                let w = up((1.0 - v) * sum);
                let tangent = up(u * (1.0 - w) - ulp);
                tangent * tangent - up_to(draw, q_ulp)
            };
            let real = |t: f64| (FRAC_PI_4 * (1.0 - t)).tan().powi(2);
            let reached = reached(t_error, bound, real, fixed);
            println!("{t_error}, {bits}, {q_bits}: {reached}");
            assert!(reached <= 1.0 && reached > least, "{t_error}, {bits}: {reached}");
        }
    }
}

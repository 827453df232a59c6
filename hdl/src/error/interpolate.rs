//! How far vectors between two ends are off.
use specula_datapath::bound::{Bound, VectorBound};
use specula_spec::Format;

/// How far the ends are apart of a span in the unit ball that comes no nearer to its centre than
/// `shortest`: a chord.
///
/// ```text
/// |X1 - X0|² = 4 (1 - s²)   of unit ends whose middle is s long
/// ```
pub fn chord(shortest: f64) -> f64 {
    2.0 * (1.0 - shortest * shortest).max(0.0).sqrt()
}

/// By how much a weight that is accumulated from 0 on is off after `steps` steps of 1/S, each
/// rounded to half a unit u of the last place.
///
/// ```text
/// |a'(i) - i/S| ≤ i u/2 ≤ S u/2
/// ```
///
/// The host works out 1/S in f64, off by 2^-53 of itself, and so by 2^-53 after S steps. Where the
/// accumulator is no finer than an f64 near 1, that is half a unit at most and never reaches its
/// next number.
fn accumulated_off(accumulator: Format, steps: u32) -> f64 {
    let of_host =
        if accumulator.fraction_bits >= f64::MANTISSA_DIGITS { f64::EPSILON / 2.0 } else { 0.0 };
    0.5 * f64::from(steps) * accumulator.ulp() + of_host
}

/// How far past 1 the accumulated weight is allowed to come: a unit for each step, or more where
/// the host is off by more.
pub fn slack(accumulator: Format, steps: u32) -> f64 {
    (f64::from(steps) * accumulator.ulp()).max(accumulated_off(accumulator, steps))
}

/// o, how far past 1 the weight can come out.
///
/// ```text
/// o = 0            where the accumulator is off by less than half a unit u_a of a's
/// o = S u/2 + u_a/2   elsewhere
/// ```
///
/// By default the accumulator's extra bits keep what it is off by below half a unit of a's, so that
/// a ≤ 1 after rounding; a spec may ask for fewer.
pub fn overshoot(accumulator: Format, weight: Format, steps: u32) -> f64 {
    let accumulated = accumulated_off(accumulator, steps);
    let half = 0.5 * weight.ulp();
    if accumulated < half { 0.0 } else { accumulated + half }
}

/// How often the longer of two ends a vector between them is at most.
///
/// ```text
/// X' = (1 - a) X0 + a X1             0 ≤ a ≤ 1 + o
/// |X'| ≤ (|1 - a| + a) max(|X0|, |X1|)
///      ≤ (1 + 2o) max(|X0|, |X1|)
/// ```
pub fn reach(overshoot: f64) -> f64 {
    1.0 + 2.0 * overshoot
}

/// The ends of a span, as the host sends them.
#[derive(Clone, Copy, Debug)]
struct Ends {
    /// e, how far either end is off.
    pub off: f64,
    /// How far the real ends are apart at most.
    pub apart: f64,
    /// How long their difference is at most, as it comes, and how far it is off.
    pub difference: (f64, f64),
}

impl Ends {
    /// Bound on the error of X = X0 + a (X1 - X0), with the weight a off by `weight`.
    ///
    /// The host sends X1 - X0 of rounded ends. Primes are for what comes:
    ///
    /// ```text
    /// X' - X   = (1 - a') (X0' - X0) + a' (X1' - X1) + (a' - a) (X1 - X0)
    /// |X' - X| ≤ (|1 - a'| + a') e + |a' - a| |X1 - X0|
    ///          ≤ (1 + 2o) e + e_a |X1 - X0|
    /// ```
    ///
    /// |X1 - X0| is no more than is known of it, nor than the one that comes and what that is off
    /// by, twice as much as each of its ends.
    fn between(self, weight: f64, reach: f64) -> f64 {
        let (longest, off) = self.difference;
        self.off * reach + weight * self.apart.min(longest + 2.0 * off)
    }
}

/// How far X0 + a (X1 - X0) is off, of ends `apart` from each other at most, of which the first and
/// the difference are known, with a weight that is known, too.
pub fn between([start, delta]: [VectorBound; 2], weight: Bound, apart: f64, reach: f64) -> f64 {
    let difference = (delta.longest, delta.error.length);
    Ends { off: start.error.length, apart, difference }.between(weight.error, reach)
}

/// Bound on the error of a component of X1 - X0 as the host sends it: both ends are rounded, so it
/// is off by a whole unit, not by half as what is rounded once.
pub fn sent_difference(of: Bound) -> f64 {
    of.ulp
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_fixtures::Draw;

    use super::*;

    /// Of spans of every length: 90 % of the bound is reached.
    #[test]
    fn accumulated_weights_stay_within_the_bound_and_reach_it() {
        for accumulator in [Format::unsigned(1, 8), Format::unsigned(1, 14)] {
            let mut reached = 0.0_f64;
            for steps in 1..1000 {
                let step = accumulator.value(accumulator.quantise(1.0 / f64::from(steps)));
                let off = (f64::from(steps) * step - 1.0).abs();
                reached = reached.max(off / accumulated_off(accumulator, steps));
                assert!(f64::from(steps) * step <= 1.0 + slack(accumulator, steps));
            }
            assert!(reached <= 1.0 && reached > 0.9, "{accumulator}: {reached}");
        }
    }

    /// Of spans of every length whose accumulator is too coarse: 90 % of the bound is reached.
    #[test]
    fn rounded_weights_come_no_further_past_one_than_stated_and_come_near() {
        let (accumulator, weight) = (Format::unsigned(1, 10), Format::unsigned(1, 8));
        let mut reached = 0.0_f64;
        for steps in 1..1000 {
            let step = accumulator.value(accumulator.quantise(1.0 / f64::from(steps)));
            let past = weight.value(weight.quantise(f64::from(steps) * step)) - 1.0;
            let bound = overshoot(accumulator, weight, steps);
            assert!(past <= bound, "{steps} steps: {past} of {bound}");
            if bound > 0.0 {
                reached = reached.max(past / bound);
            }
        }
        assert!(reached > 0.9, "{reached}");
    }

    #[test]
    fn chords_come_as_near_to_the_centre_as_stated() {
        let mut draw = Draw::new(1);
        for _ in 0..1000 {
            let [a, b] = [0; 2].map(|_| draw.direction());
            let wanted = (a - b).length();
            assert!((chord((0.5 * (a + b)).length()) - wanted).abs() < 1e-7, "{a} {b}");
        }
    }

    /// Ends off in any direction, and along their difference: 99 % of the bound is reached.
    #[test]
    fn vectors_between_ends_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (off, weight, past) in [(1e-3, 1e-4, 0.0), (1e-4, 1e-3, 0.0), (1e-3, 2e-3, 0.05)] {
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let ends = [0; 2].map(|_| draw.within(0.3, 1.0) * draw.direction());
                let [x0, x1] = ends;
                let apart = (x1 - x0).length();
                let along = (x1 - x0) / apart;
                let fixed = ends.map(|end| {
                    let direction = draw.one_of(&[along, -along, DVec3::X]);
                    end + draw.error(off) * direction
                });
                let a = draw.within(weight, 1.0 - weight) + draw.one_of(&[0.0, past]);
                let moved = (a + draw.error(weight)).min(1.0 + past);
                let between = |[x0, x1]: [DVec3; 2], a: f64| x0 + a * (x1 - x0);
                let error = (between(fixed, moved) - between(ends, a)).length();
                let of = Ends { off, apart, difference: ((fixed[1] - fixed[0]).length(), off) };
                reached = reached.max(error / of.between(weight, reach(past)));
            }
            assert!(reached <= 1.0 + 1e-9 && reached > 0.99, "{off} {weight} {past}: {reached}");
        }
    }
}

//! How far powers of a cosine are off.
use specula_datapath::bound::{
    Angular, Bound, ErrorBound, ErrorModel, RELATIVE_BOUNDS, RelativeBound,
};
use specula_spec::format::power_of_two;

/// What is known of b^n of a base b from 0 to 1 and n from 1 on.
///
/// Let the base be s cos t, off by an angle a and by r beside that.
///
/// - The angle moves cos^n t by a times a slope σ(v) of it in t, n cos^(n-1) t sin t, at a v =
///   cos^n t between both powers. `Line` says what is known of σ.
/// - For x and y with |x - y| ≤ r and m = max(x, y)
///
///   ```text
///   |x^n - y^n| ≤ n r m^(n-1)
///   n m^(n-1)   ≤ 1 + (n-1) m^n     (weighted means)
///   |x^n - y^n| ≤ r (1 + (n-1) m^n)
///   ```
///
///   and m^n exceeds both powers by no more than their bound.
pub struct PowerError {
    /// n.
    exponent: f64,
    /// a.
    angle: f64,
    /// Bound on what the angle has no part in.
    bound: f64,
    /// Of it, what grows with the power.
    ratio: f64,
    /// Of it, what does not.
    rest: f64,
}

impl PowerError {
    /// Of the exact power of a base as it comes, for whole exponents up to `n`.
    pub fn of(base: Bound, n: f64) -> PowerError {
        let unturned = Angular { angle: 0.0, rest: base.error };
        PowerError::of_angle(base.angular().unwrap_or(unturned), n)
    }

    fn of_angle(base: Angular, n: f64) -> PowerError {
        let Angular { angle, rest: r } = base;
        PowerError { exponent: n, angle, bound: n * r, ratio: (n - 1.0) * r, rest: r }
    }

    /// And off by `error` besides.
    pub fn and(self, error: f64) -> PowerError {
        PowerError { bound: self.bound + error, rest: self.rest + error, ..self }
    }

    /// And each of j squares, 2^j = n, rounded by `half_unit`: the one that is followed by i more
    /// is raised to k = 2^i, and so counts as r does, 1 + (k-1) m^n times. The k add up to n - 1.
    pub fn and_squared(self, log2_n: u32, half_unit: f64) -> PowerError {
        let (squares, all) = (f64::from(log2_n), power_of_two(log2_n.into()) - 1.0);
        PowerError {
            bound: self.bound + all * half_unit,
            ratio: self.ratio + (all - squares) * half_unit,
            rest: self.rest + squares * half_unit,
            ..self
        }
    }

    /// Bound on the error; no power exceeds 1.
    pub fn most(&self) -> f64 {
        self.shares()
            .iter()
            .map(|share| share.ratio + share.rest)
            .fold(self.at_worst_apart(), f64::min)
    }

    /// Both parts at their worst, wherever that is; 1 at most.
    fn at_worst_apart(&self) -> f64 {
        (self.angle * steepest(self.exponent) + self.bound).min(1.0)
    }

    /// What is proven of the power.
    pub fn bound(&self) -> ErrorBound {
        ErrorBound { error: self.most(), model: ErrorModel::Relative(self.shares()) }
    }

    /// Pairs of what grows with the power and what does not, each of which holds.
    fn shares(&self) -> [RelativeBound; RELATIVE_BOUNDS] {
        let level = Line { slope: 0.0, rest: steepest(self.exponent) };
        let lines = [0.95, 0.9, 0.8, 0.7, 0.5, 0.35, 0.2].map(|v| Line::touching(v, self.exponent));
        std::array::from_fn(|i| self.share(if i == 0 { level } else { lines[i - 1] }))
    }

    /// With a line above σ: v and m^n exceed the smaller power by the bound at most, and v falls
    /// short of it by what has no part in the angle at most, which counts where the line falls.
    fn share(&self, line: Line) -> RelativeBound {
        let (most, slope) = (self.at_worst_apart(), self.angle * line.slope);
        let of_turn =
            self.angle * line.rest + slope.max(0.0) * most + (-slope).max(0.0) * self.bound;
        RelativeBound {
            ratio: (slope + self.ratio).max(0.0),
            rest: of_turn + self.rest + self.ratio * most,
        }
    }
}

/// A line that the slope σ(v) = n cos^(n-1) t sin t of v = cos^n t stays below, for any whole
/// exponent from 1 to n.
///
/// σ is concave in v:
///
/// ```text
/// dσ/dv = (n-1) tan t - cot t     grows with t, and v falls
/// ```
///
/// So its tangent at t stays above it, whose value at v = 0 is cos^(n-1) t/sin t.
///
/// With y = -ln v/n
///
/// ```text
/// σ = n v √(e^(2y) - 1)
/// ```
///
/// which grows with n where y ≤ 0.796, since √(e^(2y) - 1)/y falls until there: what holds for n
/// holds for smaller exponents n' where v ≥ e^(-0.796 n'). Below that
///
/// ```text
/// σ < n' v^((n'-1)/n') ≤ n' e^(-0.796 (n'-1)) ≤ 1
/// ```
///
/// It is enough that the line is no lower than 1 up to v = e^(-0.796) < 0.46.
#[derive(Clone, Copy)]
struct Line {
    slope: f64,
    /// At v = 0.
    rest: f64,
}

impl Line {
    fn touching(v: f64, n: f64) -> Line {
        let cosine = v.powf(1.0 / n);
        let sine = (1.0 - cosine * cosine).sqrt();
        let slope = (n - 1.0) * sine / cosine - cosine / sine;
        let rest = v / (cosine * sine);
        let below = rest + 0.46 * slope.min(0.0);
        Line { slope, rest: rest + (1.0 - below).max(0.0) }
    }
}

/// Largest slope of cos^n.
fn steepest(n: f64) -> f64 {
    n.sqrt() * ((n - 1.0) / n).powf((n - 1.0) / 2.0)
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;

    use super::*;

    /// The largest error over what each share and the bound allow.
    #[derive(Clone, Copy, Debug, Default)]
    struct Reached([f64; RELATIVE_BOUNDS + 1]);

    impl Reached {
        fn take(&mut self, of: &PowerError, [real, fixed]: [f64; 2]) {
            let error = (fixed - real).abs();
            let allowed = of.shares().map(|share| share.ratio * fixed.min(real) + share.rest);
            for (reached, allowed) in self.0.iter_mut().zip(allowed.into_iter().chain([of.most()]))
            {
                *reached = f64::max(*reached, error / allowed);
            }
        }

        fn within(&self) -> bool {
            self.0.iter().all(|&reached| reached <= 1.0 + 1e-9)
        }
    }

    /// Powers up to `exponent` of s cos t and s cos (t ± a) ± r.
    fn reached(of: &PowerError, exponents: &[f64], r: f64) -> Reached {
        let mut reached = Reached::default();
        for &n in exponents {
            for (i, length, turn, r) in (0..=1500).flat_map(|i| {
                [1.0, 0.99].into_iter().flat_map(move |s| {
                    [-1.0, 1.0].into_iter().flat_map(move |a| [-r, r].map(|r| (i, s, a, r)))
                })
            }) {
                let t = f64::from(i) / 1500.0 * std::f64::consts::FRAC_PI_2;
                let power = |base: f64| base.clamp(0.0, 1.0).powf(n);
                let real = power(length * t.cos());
                reached.take(of, [real, power(length * (t + turn * of.angle).cos() + r)]);
            }
        }
        reached
    }

    /// 70 % of each share that touches is reached.
    #[test]
    fn every_share_holds_and_comes_near() {
        for n in [1.0, 2.0, 3.0, 16.0, 256.0, 8191.0] {
            for (angle, r) in [(1e-3, 1e-4), (1e-5, 1e-6), (1e-6, 1e-5), (1e-4, 0.0)] {
                let of = PowerError::of_angle(Angular { angle, rest: r }, n);
                let all = [1.0, 2.0, 3.0, 5.0, 16.0, 100.0, 256.0, 8191.0];
                let below: Vec<f64> = all.into_iter().filter(|&exponent| exponent <= n).collect();
                let reached = reached(&of, &below, r);
                assert!(reached.within(), "n {n}, angle {angle}, r {r}: {reached:?}");
                // A line that falls faster than the ratio of r rises touches nothing.
                let touches = of.shares().map(|share| share.ratio > 0.0);
                if n >= 16.0 && n * r < 0.1 {
                    let near = reached
                        .0
                        .iter()
                        .zip(touches.into_iter().chain([true]))
                        .all(|(&reached, touches)| reached > 0.7 || !touches);
                    assert!(near, "n {n}, angle {angle}, r {r}: {reached:?}");
                }
            }
        }
    }

    /// Bases at random, and each square rounded: 90 % of the bound is reached.
    #[test]
    fn rounded_squares_stay_within_every_share_and_come_near() {
        let mut draw = Draw::new(1);
        for (log2_n, half_unit) in [(1, 1e-3), (4, 1e-4), (8, 1e-6)] {
            let n = power_of_two(i64::from(log2_n));
            let base = Angular { angle: 1e-4 / n, rest: half_unit };
            let of = PowerError::of_angle(base, n).and_squared(log2_n, half_unit);
            let mut reached = Reached::default();
            for _ in 0..40_000 {
                let t = draw.within(0.0, 1.0).powi(2) * (20.0 / n).min(1.5);
                let real = t.cos();
                let fixed = (t + draw.error(base.angle)).cos() + draw.error(base.rest);
                let squared =
                    |b: f64, draw: &mut Draw| (b * b + draw.error(half_unit)).clamp(0.0, 1.0);
                let fixed = (0..log2_n).fold(fixed.clamp(0.0, 1.0), |b, _| squared(b, &mut draw));
                reached.take(&of, [real.powf(n), fixed]);
            }
            assert!(reached.within() && reached.0[RELATIVE_BOUNDS] > 0.9, "n {n}: {reached:?}");
        }
    }
}

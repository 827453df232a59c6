//! How far the Gaussian of an angle is off.
use specula_datapath::bound::Bound;
use specula_spec::format::power_of_two;

/// What is left out where 1 - cos α is kept within 15/8, beyond which exp(-2 α²) is less.
const BEYOND_VERSINES: f64 = power_of_two(-20);

/// Bound on the error of exp(-2n α²), to `fraction_bits`, for whole exponents n, of n and d
/// = 1 - cos α as they come.
///
/// ```text
/// f          = exp(-2n α²)
/// |df/dd|    = 4n (α/sin α) exp(-2n α²)     with dd = sin α dα
/// α/sin α    ≤ exp(2 α²)                    but in the last 1e-8 radians before π, where f is 0
/// |df/dd|    ≤ 4n exp(-2(n - 1) α²) ≤ 4n
/// |f' - f|   ≤ 4n |d' - d| + 2^-f + 2^-20
/// ```
///
/// The last two are the unit's own roundings and what is left out of versines.
pub fn bound(n: Bound, versine: Bound, fraction_bits: u32) -> f64 {
    let roundings = power_of_two(-i64::from(fraction_bits)) + BEYOND_VERSINES;
    (4.0 * n.magnitude() * versine.error + roundings).min(1.0)
}

#[cfg(test)]
mod tests {
    use specula_datapath::bound::Interval;
    use specula_fixtures::Draw;

    use super::*;

    /// Versines as they come, kept within what the unit takes, and results rounded to either
    /// neighbour: 95 % of the bound is reached.
    #[test]
    fn gaussians_stay_within_the_bound_and_reach_it() {
        let exact = |d: f64, n: f64| (-8.0 * n * (d / 2.0).sqrt().asin().powi(2)).exp();
        let mut draw = Draw::new(1);
        for (largest, versine, fraction_bits) in [(1, 1e-4, 12), (37, 1e-5, 16), (8191, 1e-7, 12)] {
            let bound = super::bound(
                Bound::near(Interval::new(1.0, f64::from(largest)), 0.0),
                Bound::near(Interval::new(0.0, 2.0), versine),
                fraction_bits,
            );
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let n = draw.within(0.0, 1.0).sqrt() * f64::from(largest);
                let n = n.ceil().max(1.0);
                let d = draw.within(0.0, 2.0) * draw.within(0.0, 1.0).powi(8) / n;
                let kept = (d + draw.error(versine)).clamp(0.0, 1.875);
                let fixed = exact(kept, n) + draw.error(power_of_two(-i64::from(fraction_bits)));
                reached = reached.max((fixed - exact(d, n)).abs() / bound);
            }
            assert!(reached <= 1.0 && reached > 0.95, "n {largest}: {reached}");
        }
    }
}

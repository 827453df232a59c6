//! How far a square root is off.
use specula_datapath::bound::Bound;

/// Bound on the error of √x to half a unit of `ulp`, for x off by e and fixed x no
/// smaller than b ≥ 0.
///
/// ```text
/// |√x' - √x| = |x' - x| / (√x' + √x)
///            ≤ e/√b
/// |√x' - √x| ≤ √|x' - x|
///            ≤ √e
/// ```
pub fn root(x: Bound, ulp: f64) -> f64 {
    // Where both are 0 the quotient is none, and counts for nothing.
    x.error.sqrt().min(x.error / x.fixed.low.sqrt()) + 0.5 * ulp
}

#[cfg(test)]
mod tests {
    use specula_datapath::bound::Interval;
    use specula_fixtures::Draw;

    use super::*;

    /// A fixed value that is no smaller.
    fn from(smallest: f64, error: f64) -> Bound {
        let fixed = Interval::at_least(smallest);
        Bound { fixed, ..Bound::near(Interval::at_least(0.0), error) }
    }

    /// All of the bound is reached near 0, and 56 % far from it, where both roots count.
    #[test]
    fn roots_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (error, smallest, least_reached) in [(1e-4, 0.0, 0.95), (1e-4, 0.25, 0.5)] {
            let ulp = 1.0 / 16384.0;
            let bound = root(from(smallest, error), ulp);
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let fixed = smallest + (1.0 - smallest) * draw.within(0.0, 1.0).powi(6);
                let real = (fixed + draw.error(error)).max(0.0);
                let off = fixed.sqrt() + draw.error(0.5 * ulp) - real.sqrt();
                reached = reached.max(off.abs() / bound);
            }
            println!("{smallest}: {reached}");
            assert!(reached <= 1.0 && reached > least_reached, "{smallest}: {reached}");
        }
        assert_eq!(root(from(0.0, 0.0), 0.5), 0.25);
    }
}

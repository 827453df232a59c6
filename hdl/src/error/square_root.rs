//! How far a square root is off.

/// Bound on the error of √x to half a unit of `ulp`, for x off by e = `x_error` and fixed x no
/// smaller than b = `smallest` ≥ 0.
///
/// ```text
/// |√x' - √x| = |x' - x| / (√x' + √x)
///            ≤ e/√b
/// |√x' - √x| ≤ √|x' - x|
///            ≤ √e
/// ```
pub fn root(x_error: f64, smallest: f64, ulp: f64) -> f64 {
    // Where both are 0 the quotient is none, and counts for nothing.
    x_error.sqrt().min(x_error / smallest.sqrt()) + 0.5 * ulp
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;

    use super::*;

    /// All of the bound is reached near 0, and 56 % far from it, where both roots count.
    #[test]
    fn roots_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (error, smallest, least_reached) in [(1e-4, 0.0, 0.95), (1e-4, 0.25, 0.5)] {
            let ulp = 1.0 / 16384.0;
            let bound = root(error, smallest, ulp);
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
        assert_eq!(root(0.0, 0.0, 0.5), 0.25);
    }
}

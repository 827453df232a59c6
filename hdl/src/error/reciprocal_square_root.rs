//! How far a reciprocal square root is off.

/// Bound on the error of 1/√max(z, l) to half a unit of `ulp`, for z off by e = `z_error` and real
/// z no smaller than `smallest`; l = `least_operand` is a power of four.
///
/// With ξ between z and z', and s = max(`smallest` - e, l):
///
///   |1/√z' - 1/√z| = e/2 ξ^(-3/2)
///                  ≤ e/2 s^(-3/2)
///
/// and no more than 1/√l, since all of them lie from 0 to there.
pub fn reciprocal_root(z_error: f64, smallest: f64, least_operand: f64, ulp: f64) -> f64 {
    let least = (smallest - z_error).max(least_operand);
    let moved = (z_error / (2.0 * least * least.sqrt())).min(1.0 / least_operand.sqrt());
    moved + 0.5 * ulp
}

#[cfg(test)]
mod tests {
    use super::super::draw::Draw;
    use super::*;

    /// Operands from the smallest on: 95 % of the bound is reached.
    #[test]
    fn reciprocal_roots_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (error, smallest, least) in [(1e-3, 0.25, 1.0 / 256.0), (1e-5, 0.0, 1.0 / 64.0)] {
            let ulp = 1.0 / 16384.0;
            let bound = reciprocal_root(error, smallest, least, ulp);
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let z = smallest + (1.0 - smallest) * draw.between(0.0, 1.0).powi(6);
                let root = |z: f64| 1.0 / z.max(least).sqrt();
                let fixed = root(z + draw.error(error)) + draw.error(0.5 * ulp);
                reached = reached.max((fixed - root(z)).abs() / bound);
            }
            println!("{smallest}: {reached}");
            assert!(reached <= 1.0 && reached > 0.95, "{smallest}: {reached}");
        }
    }
}

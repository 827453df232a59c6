//! How far a reciprocal square root is off.
use specula_datapath::bound::Bound;

/// Bound on the error of 1/√max(z, l) to half a unit of `ulp`, for z off by e and real z no
/// smaller than s_0; l = `least_operand` is a power of four.
///
/// With ξ between z and z', and s = max(s_0 - e, l):
///
/// ```text
/// |1/√z' - 1/√z| = e/2 ξ^(-3/2)
///                ≤ e/2 s^(-3/2)
/// ```
///
/// and no more than 1/√l, since all of them lie from 0 to there.
pub fn reciprocal_root(z: Bound, least_operand: f64, ulp: f64) -> f64 {
    let least = (z.real.low - z.error).max(least_operand);
    let moved = (z.error / (2.0 * least * least.sqrt())).min(1.0 / least_operand.sqrt());
    moved + 0.5 * ulp
}

/// How large the numbers of a row get that finds one more bit of R = ⌊√(c/Z)⌋, in whole numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowLimits {
    /// w = c - R² Z is no larger.
    pub residue: f64,
    /// P = R Z is no larger.
    pub product: f64,
}

impl RowLimits {
    /// For c = `square` and Z no larger than `largest`:
    ///
    /// ```text
    /// R² Z ≤ c,  so P = R Z ≤ √(c Z)
    /// (R + 1)² Z > c, so w ≤ 2P + Z, and w ≤ c
    /// ```
    pub fn new(square: f64, largest: f64) -> RowLimits {
        // The factor makes up for rounding here.
        let product = (square * largest).sqrt() * (1.0 + f64::EPSILON);
        RowLimits { residue: square.min(2.0 * product + largest), product }
    }
}

#[cfg(test)]
mod tests {
    use specula_datapath::bound::Interval;
    use specula_fixtures::Draw;

    use super::*;

    /// All small Z: 92 % of the product is reached, and 54 % of the residue.
    #[test]
    fn rows_stay_within_their_limits_and_reach_them() {
        for log2_square in [8, 11, 14] {
            let square = f64::from(1 << log2_square);
            let limits = RowLimits::new(square, 64.0);
            let row = |z: i32| {
                let (z, root) = (f64::from(z), (square / f64::from(z)).sqrt().floor());
                (square - root * root * z, root * z)
            };
            let residue = (1..=64).map(|z| row(z).0).fold(0.0, f64::max) / limits.residue;
            let product = (1..=64).map(|z| row(z).1).fold(0.0, f64::max) / limits.product;
            println!("{square}: {residue} and {product}");
            assert!(residue <= 1.0 && product <= 1.0);
            assert!(residue > 0.54 && product > 0.92, "{square}: {residue} and {product}");
        }
    }

    /// Operands from the smallest on: 95 % of the bound is reached.
    #[test]
    fn reciprocal_roots_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (error, smallest, least) in [(1e-3, 0.25, 1.0 / 256.0), (1e-5, 0.0, 1.0 / 64.0)] {
            let ulp = 1.0 / 16384.0;
            let bound =
                reciprocal_root(Bound::near(Interval::at_least(smallest), error), least, ulp);
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let z = smallest + (1.0 - smallest) * draw.within(0.0, 1.0).powi(6);
                let root = |z: f64| 1.0 / z.max(least).sqrt();
                let fixed = root(z + draw.error(error)) + draw.error(0.5 * ulp);
                reached = reached.max((fixed - root(z)).abs() / bound);
            }
            println!("{smallest}: {reached}");
            assert!(reached <= 1.0 && reached > 0.95, "{smallest}: {reached}");
        }
    }
}

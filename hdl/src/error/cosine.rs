//! How far cosines to a normal of any length are off.
use specula_datapath::bound::Bound;

/// What is known of 1/√q and 1/q, q the squared length of a normal N: |u·N|² ≤ q ≤ 1 for any unit
/// vector u.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InverseLength {
    /// Real and fixed q are both no smaller; 0 where that is not sure.
    smallest: f64,
    /// e_q.
    q_error: f64,
}

impl InverseLength {
    /// Of a q that counts as `least_operand` at least.
    pub fn new(q: Bound, least_operand: f64) -> InverseLength {
        InverseLength::within(q.real.low, q.error, least_operand)
    }

    /// For real q no smaller than `smallest`, off by `q_error`, that counts as `least_operand` at
    /// least.
    fn within(smallest: f64, q_error: f64, least_operand: f64) -> InverseLength {
        let surely = smallest - q_error;
        let known = surely > 0.0 && surely >= least_operand;
        InverseLength { smallest: if known { surely } else { 0.0 }, q_error }
    }

    /// Bound on the error of p/√q of p and of 1/√q as they come.
    pub fn cosine_error(self, p: Bound, root: Bound) -> f64 {
        self.error_of_cosine(p.error, 0.5 * root.ulp)
    }

    /// Bound on the error of p/√q, p = u·N, with p off by e = `p_error` and 1/√q rounded by
    /// e_s = `rounding`.
    ///
    /// ```text
    /// p's' - p/√q = (p' - p)/√q' + p (1/√q' - 1/√q) + p' e_s
    /// |1/√q' - 1/√q| √q = |q - q'| / (√q' (√q + √q')) ≤ e_q / (2 min(q, q'))
    /// |p's' - p/√q|     ≤ e/√q' + e_q/(2q') + (1 + e) e_s
    /// ```
    fn error_of_cosine(self, p_error: f64, rounding: f64) -> f64 {
        if self.smallest == 0.0 {
            return 2.0;
        }
        p_error / self.smallest.sqrt()
            + self.q_error / (2.0 * self.smallest)
            + (1.0 + p_error) * rounding
    }

    /// Bound on the error of v p/q, of p and v as they come, with p/q rounded to units of `ulp`.
    pub fn quotient_error(self, p: Bound, v: Bound, ulp: f64) -> f64 {
        self.error_of_quotient(p.error, v.error, 0.5 * ulp)
    }

    /// Bound on the error of v p/q, v and p both u·N, off by e_v and e_p, with p/q rounded by
    /// e_k = `rounding`; infinite where nothing is known.
    ///
    /// ```text
    /// k = p/q,  |p| ≤ √q,  |v| ≤ √q ≤ 1
    /// |k' - k|  ≤ e_p/q' + √q e_q/(q q') + e_k
    ///           ≤ e_p/q' + e_q/(√q q') + e_k
    /// |v||k' - k| ≤ (e_p + e_q)/q' + e_k
    /// |v'k' - vk| ≤ |v||k' - k| + e_v (1/√q + |k' - k|)
    /// ```
    fn error_of_quotient(self, p_error: f64, v_error: f64, rounding: f64) -> f64 {
        if self.smallest == 0.0 {
            return f64::INFINITY;
        }
        let (q, e_q) = (self.smallest, self.q_error);
        let of_quotient = p_error / q + e_q / (q * q.sqrt()) + rounding;
        (p_error + e_q) / q + rounding + v_error * (1.0 / q.sqrt() + of_quotient)
    }
}

/// Error of the bit q > 0: 1 where rounding may decide it.
pub fn direction_error(q: Bound) -> f64 {
    if q.real.low - q.error > 0.0 { 0.0 } else { 1.0 }
}

/// Bound on the error of P w, clamped to [-1, 1], of P, q and w = 1/q as they come.
pub fn by_reciprocal([p, q]: [Bound; 2], w: Bound) -> f64 {
    product_with_reciprocal([p.error, q.error], q.real.low, 0.5 * w.ulp)
}

/// Bound on the error of P w, clamped to [-1, 1], with w = 1/q rounded by e_w = `rounding` and
/// |P| ≤ q ≤ 1. P is off by e_P and q by e_q; real q is no smaller than `smallest`, or P and q are
/// 0 exactly.
///
/// ```text
/// P'w' - P/q = (P' - P + P (q - q')/q)/q' + P' e_w
/// |·|        ≤ (e_P + e_q)/q' + (1 + e_P) e_w
/// ```
fn product_with_reciprocal([e_p, e_q]: [f64; 2], smallest: f64, rounding: f64) -> f64 {
    let surely = smallest - e_q;
    if surely > 0.0 { ((e_p + e_q) / surely + (1.0 + e_p) * rounding).min(2.0) } else { 2.0 }
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;

    use super::*;

    /// The least q, and how far v, p, q and the root or quotient are off.
    const CASES: [(f64, [f64; 4]); 4] = [
        (0.25, [0.0, 1e-4, 0.0, 1e-6]),
        (0.25, [1e-4, 0.0, 1e-4, 1e-6]),
        (0.04, [1e-4, 1e-4, 1e-4, 1e-4]),
        (0.81, [1e-3, 0.0, 0.0, 1e-3]),
    ];

    /// The largest error over `bound`; `value` makes its result of v, p, q and a rounding.
    fn reached(
        (smallest, errors): (f64, [f64; 4]),
        bound: f64,
        value: impl Fn([f64; 4]) -> f64,
    ) -> f64 {
        let mut draw = Draw::new(1);
        let mut reached = 0.0_f64;
        for _ in 0..20_000 {
            let q = smallest + (1.0 - smallest) * draw.within(0.0, 1.0).powi(6);
            let [v, p] = [0; 2].map(|_| q.sqrt() * draw.error(1.0));
            let real = [v, p, q, 0.0];
            let fixed = std::array::from_fn(|i| real[i] + draw.error(errors[i]));
            reached = reached.max((value(fixed) - value(real)).abs() / bound);
        }
        reached
    }

    /// 95 % is reached of cosines; of products with quotients half where p alone is off, since v
    /// need not be as long as N.
    #[test]
    fn cosines_and_quotients_stay_within_the_bound_and_reach_it() {
        for case in CASES {
            let (smallest, [e_v, e_p, e_q, rounding]) = case;
            let length = InverseLength::within(smallest, e_q, 0.0);
            let all = [
                reached(case, length.error_of_cosine(e_p, rounding), |[_, p, q, rounding]| {
                    p * (1.0 / q.sqrt() + rounding)
                }),
                reached(
                    case,
                    length.error_of_quotient(e_p, e_v, rounding),
                    |[v, p, q, rounding]| v * (p / q + rounding),
                ),
                reached(
                    case,
                    product_with_reciprocal([e_p, e_q], smallest, rounding),
                    |[_, p, q, rounding]| {
                        let p = if p.abs() > q { p.signum() * q } else { p };
                        p * (1.0 / q + rounding)
                    },
                ),
            ];
            println!("{case:?}: {all:?}");
            assert!(all.iter().all(|&share| share <= 1.0 && share > 0.49), "{case:?}: {all:?}");
        }
    }

    #[test]
    fn nothing_is_known_of_normals_that_may_vanish() {
        let unknown = InverseLength::within(0.01, 0.02, 0.0);
        assert_eq!(unknown.error_of_cosine(0.0, 0.0), 2.0);
        assert_eq!(unknown.error_of_quotient(0.0, 0.0, 0.0), f64::INFINITY);
        assert_eq!(product_with_reciprocal([0.0, 0.02], 0.01, 0.0), 2.0);
        assert_eq!(InverseLength::within(0.01, 0.0, 0.0625).smallest, 0.0);
    }
}

//! How far a clamped quotient is off.
use specula_datapath::bound::Bound;

/// What is known of p/q, clamped and rounded.
///
/// Let p' and q' be the operands as they come, r = p/q and r' = p'/q'.
///
/// ```text
/// r' - r   = ((p' - p) - r (q' - q)) / q'
/// |r' - r| ≤ (e_p + |r| e_q) / q'
/// q'       ≥ s - e_q                       with q ≥ s
/// |r' - r| ≤ (e_p + 2^i e_q) / (s - e_q)   with |r| ≤ 2^i
/// ```
///
/// Where r lies beyond 2^i, r counts as 2^i, and p as a p between 2^i q and the real one: p' is
/// further from it on the side alone on which r' is clamped. Rounding adds half a unit.
#[derive(Clone, Copy, Debug)]
pub struct Quotient {
    /// e_p and e_q.
    operands: [f64; 2],
    /// s, the smallest real divisor; 0 or less where nothing is known of it.
    smallest_divisor: f64,
    /// 2^i, the largest magnitude of the quotient.
    limit: f64,
    /// Unit of the last place of the quotient.
    ulp: f64,
}

impl Quotient {
    /// Of p and q as they come.
    pub fn new([p, q]: [Bound; 2], limit: f64, ulp: f64) -> Quotient {
        Quotient { operands: [p.error, q.error], smallest_divisor: q.real.low, limit, ulp }
    }

    /// Bound on the error of a quotient that is clamped to [0, 2^i].
    pub fn unsigned(self) -> f64 {
        self.anywhere().min(self.limit + 0.5 * self.ulp)
    }

    /// Bound on the error of a quotient that is clamped to [-2^i, 2^i].
    pub fn signed(self) -> f64 {
        self.anywhere().min(2.0 * self.limit + 0.5 * self.ulp)
    }

    fn anywhere(self) -> f64 {
        let [e_p, e_q] = self.operands;
        let surely = self.smallest_divisor - e_q;
        if surely > 0.0 {
            (e_p + self.limit * e_q) / surely + 0.5 * self.ulp
        } else {
            f64::INFINITY
        }
    }
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;

    use super::*;

    /// Operands at the ends of their errors, and divisors from the smallest on: 99 % of the bound
    /// is reached.
    #[test]
    fn clamped_quotients_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (smallest_divisor, limit) in [(0.25, 1.0), (1.0, 4.0), (0.01, 16.0)] {
            for low in [0.0, -limit] {
                let of = Quotient {
                    operands: [1e-4, 3e-5 * smallest_divisor],
                    smallest_divisor,
                    limit,
                    ulp: 1.0 / 16384.0,
                };
                let bound = if low == 0.0 { of.unsigned() } else { of.signed() };
                let mut reached = 0.0_f64;
                for _ in 0..20_000 {
                    let q = smallest_divisor * (1.0 + draw.within(0.0, 1.0).powi(8));
                    let p = 1.1 * q * draw.within(low, limit);
                    let real = (p / q).clamp(low, limit);
                    let (p, q) = (p + draw.error(of.operands[0]), q + draw.error(of.operands[1]));
                    let fixed = (p / q).clamp(low, limit) + draw.error(0.5 * of.ulp);
                    reached = reached.max((fixed - real).abs() / bound);
                }
                assert!(reached <= 1.0 && reached > 0.99, "{of:?}: {reached}");
            }
        }
    }
}

//! How far wrapped vectors are off.
use specula_datapath::bound::{Bound, ErrorBound, ErrorModel, RelativeBound, VectorBound};

/// Units of the last place of what a wrap rounds: H·w and H·H, and v.
#[derive(Clone, Copy, Debug)]
pub struct WrapUnits {
    /// u_p, of H·w and H·H.
    pub operand: f64,
    /// u_v, of v.
    pub ratio: f64,
}

/// What n = 2v H - w is made of, v = H·w/H·H, with |H| ≥ 1.
#[derive(Clone, Copy, Debug)]
pub struct Wrapped {
    /// How far H is off.
    pub h: f64,
    /// How far w is off.
    pub w: f64,
    /// How long w is at most.
    pub longest_w: f64,
}

impl Wrapped {
    /// Of H and w as they come.
    pub fn new(h: VectorBound, w: VectorBound) -> Wrapped {
        Wrapped { h: h.error.length, w: w.error.length, longest_w: w.longest }
    }

    /// Bound on the error of n before it is rounded; infinite where rounding is as coarse as H is
    /// long.
    ///
    /// The wrap is an isometry in w, and in H twice the projection on its direction û:
    ///
    /// ```text
    /// |û - û'| ≤ |H - H'|/√(|H||H'|)
    /// |n' - n| ≤ 2|w| e_H/(1 - e_H) + e_w
    /// ```
    ///
    /// n differs from the wrap of the rounded H and w by 2|H| times the error of v, which rounding
    /// makes u_p/|H|² + u_v/2:
    ///
    /// ```text
    /// 2|H| (u_p/|H|² + u_v/2) ≤ 2 u_p/(1 - e_H) + 2.1 u_v
    /// ```
    pub fn error(self, units: WrapUnits) -> f64 {
        let shortest = 1.0 - self.h;
        let of_rounding = 2.0 * units.operand / shortest + 2.1 * units.ratio;
        let error = 2.0 * self.longest_w * self.h / shortest + self.w + of_rounding;
        if shortest > 0.0 { error } else { f64::INFINITY }
    }
}

/// How long n is at most, once it is rounded to units of `vector`.
///
/// n is as long as w but for 2|H| times the error of v, which as in [`Wrapped::error`] is less than
/// 4 u_p + 4 u_v, as |H| ≥ 3/4, and for √3/2 units of its own.
pub fn longest(longest_w: f64, units: WrapUnits, vector: f64) -> f64 {
    longest_w + 2.0 * vector + 4.0 * units.operand + 4.0 * units.ratio
}

/// What decides whether a spot is seen: p = H·S against 1, with H = X + S.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    /// e_p, how far H·S is off.
    pub p: f64,
    /// e_q, how far H·H is off.
    pub q: f64,
    /// s: X is no shorter.
    pub shortest: f64,
}

impl Edge {
    /// Of H·S and H·H as they come.
    pub fn new(p: Bound, q: Bound, shortest: f64) -> Edge {
        Edge { p: p.error, q: q.error, shortest }
    }

    /// S·L' where p may lie on either side of 1, at most.
    ///
    /// Where p ≤ 1, X·S ≤ 0: a spot gives no light there. Where rounding moves p across 1
    ///
    /// ```text
    /// |X·S| ≤ e_p
    /// p     ≤ 1 + e_p
    /// q     = 1 + |X|² + 2X·S ≥ 1 + s² - 2 e_p - e_q
    /// S·L'  = 2 p²/q - 1
    /// ```
    ///
    /// on both sides.
    pub fn strength(self) -> f64 {
        let least_q = 1.0 + self.shortest * self.shortest - 2.0 * self.p - self.q;
        if least_q > 0.0 { (2.0 * (1.0 + self.p).powi(2) / least_q - 1.0).min(1.0) } else { 1.0 }
    }

    /// The same of v as it is rounded to units of `ratio`.
    pub fn rounded_strength(self, ratio: f64) -> f64 {
        self.strength() + 2.0 * ratio
    }
}

/// What is known of an amount of light that is off by `most` where rounding decides whether the spot
/// is seen, and as it is known to be elsewhere.
pub fn at_edge(amount: Bound, most: f64) -> ErrorBound {
    let beyond = |bound: RelativeBound| RelativeBound { rest: bound.rest.max(most), ..bound };
    let model = match amount.model {
        ErrorModel::Relative(bounds) => ErrorModel::Relative(bounds.map(beyond)),
        ErrorModel::Bounded | ErrorModel::Angular(_) | ErrorModel::Exclusive { .. } => {
            ErrorModel::Bounded
        }
    };
    ErrorBound { error: amount.error.max(most), model }
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;

    use super::*;

    /// Vectors of any length from 1 to 2: 90 % of the bound is reached.
    #[test]
    fn wraps_stay_within_the_bound_and_come_near() {
        let mut draw = Draw::new(1);
        for (e_h, e_w, operand, ratio) in
            [(1e-3, 1e-4, 1e-5, 1e-5), (1e-5, 1e-4, 1e-3, 1e-5), (1e-5, 1e-5, 1e-5, 1e-3)]
        {
            let (of, units) =
                (Wrapped { h: e_h, w: e_w, longest_w: 1.0 }, WrapUnits { operand, ratio });
            let bound = of.error(units);
            let mut reached = 0.0_f64;
            for _ in 0..40_000 {
                let w = draw.direction();
                let slope = draw.within(0.0, 1.0);
                let h = draw.within(1.0, 2.0) * (w + slope * draw.across(w)).normalize();
                let real = 2.0 * (h.dot(w) / h.length_squared()).clamp(0.0, 1.0) * h - w;
                let h = h + draw.error(e_h) * draw.across(h.normalize());
                let w = w + draw.error(e_w) * draw.direction();
                let (p, q) = (
                    h.dot(w) + draw.error(0.5 * operand),
                    h.length_squared() + draw.error(0.5 * operand),
                );
                let v = (p / q).clamp(0.0, 1.0) + draw.error(0.5 * ratio);
                let fixed = 2.0 * v * h - w;
                assert!(fixed.length() <= longest(1.0 + e_w, units, 0.0));
                reached = reached.max((fixed - real).length() / bound);
            }
            assert!(reached <= 1.0 && reached > 0.9, "{of:?}, {units:?}: {reached}");
        }
    }

    /// Directions about at right angles to a spot's axis: 90 % of the bound is reached.
    #[test]
    fn spots_at_their_edge_are_no_stronger_than_stated() {
        let mut draw = Draw::new(1);
        for (p, q, shortest) in [(1e-3, 1e-3, 0.1), (0.01, 0.02, 0.9), (1e-4, 1e-3, 0.04)] {
            let edge = Edge { p, q, shortest };
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let along = draw.error(p);
                let length = shortest.max(along.abs()) * draw.within(1.0, 1.1);
                let real = (1.0 + along, 1.0 + 2.0 * along + length * length);
                let fixed = (real.0 + draw.error(p), real.1 + draw.error(q));
                if (real.0 <= 1.0) == (fixed.0 <= 1.0) {
                    continue;
                }
                for (p, q) in [real, fixed] {
                    let strength = (2.0 * p * p / q - 1.0).min(1.0);
                    assert!(strength <= edge.strength(), "{edge:?}: {strength}");
                    reached = reached.max(strength / edge.strength());
                }
            }
            assert!(reached > 0.9, "{edge:?}: {reached}");
        }
    }
}

//! How far cosines between unit vectors are off, and those of reflections.
use specula_datapath::bound::{Angular, Bound, Interval, VectorBound, VectorError};

use super::reciprocal_square_root::reciprocal_root;

/// x·y of real unit vectors, rounded by `rounding`.
pub fn cosine([x, y]: [VectorBound; 2], rounding: f64) -> Angular {
    cosine_of([x.error, y.error], rounding)
}

/// x·y of real unit vectors that are off so far, rounded by `rounding`.
///
/// Fixed x is the length 1 + δ_x times a direction, |δ_x| ≤ ε_x ([`VectorError::stretch`]):
///
/// ```text
/// x'·y' = (1 + δ_x)(1 + δ_y) cos t'
/// |t' - t|         ≤ turn of x + turn of y
/// |x'·y' - cos t'| ≤ (1 + ε_x)(1 + ε_y) - 1
/// ```
fn cosine_of([x, y]: [VectorError; 2], rounding: f64) -> Angular {
    Angular {
        angle: x.angle() + y.angle(),
        rest: (1.0 + x.stretch()) * (1.0 + y.stretch()) - 1.0 + rounding,
    }
}

/// R·L = 2(N·V)(N·L) - V·L, rounded by `rounding`, of N·V, N·L and V·L as they come; nothing where
/// they are not known as cosines.
pub fn reflection([n_dot_v, n_dot_l, l_dot_v]: [Bound; 3], rounding: f64) -> Option<Angular> {
    let known = [n_dot_v.angular()?, n_dot_l.angular()?];
    let of_l_dot_v = match l_dot_v.angular() {
        Some(Angular { rest, .. }) => rest,
        None => sent_light_dot_view(l_dot_v.error, known),
    };
    Some(reflected(known, of_l_dot_v, rounding))
}

/// Bound on the error of a value from 0 to 1 of which nothing is known.
pub const fn any_base() -> f64 {
    1.0
}

/// R·L = 2(N·V)(N·L) - V·L of cosines that are those of turned unit vectors, with V·L off from that
/// of these vectors by `l_dot_v` and the result rounded by `rounding`.
///
/// With r_v and r_l for what both cosines are off beside the turns:
///
/// ```text
/// 2(c_v + r_v)(c_l + r_l) - V·L = R·L + 2(c_v r_l + c_l r_v + r_v r_l)
/// |rest| ≤ 2(r_v + r_l + r_v r_l) + r
/// ```
///
/// where R·L is that of the turned vectors, whose angle is off by no more than both angles with N
/// together.
fn reflected([n_dot_v, n_dot_l]: [Angular; 2], l_dot_v: f64, rounding: f64) -> Angular {
    let (r_v, r_l) = (n_dot_v.rest, n_dot_l.rest);
    Angular {
        angle: n_dot_v.angle + n_dot_l.angle,
        rest: 2.0 * (r_v + r_l + r_v * r_l) + l_dot_v + rounding,
    }
}

/// What is known of 1/|L + V| of turned unit vectors L and V.
#[derive(Clone, Copy, Debug)]
pub struct HalfwayGain {
    /// By how much it is off from that of the turned vectors, times the length of their L + V.
    relative: f64,
    /// It is no larger.
    most: f64,
    /// How far L and V are turned together.
    ends: f64,
    /// How far L + V is turned.
    turn: f64,
}

impl HalfwayGain {
    /// Of z = 2 + 2 L·V, rounded by `rounding`, whose root 1/√z is rounded to `ulp` and clamped as
    /// `least_operand` says, and of real L + V no shorter than s; nothing where L·V is not known as a
    /// cosine.
    ///
    /// L + V of vectors turned by a together is off by a, so turned by asin(a/s), and no shorter than
    /// l = s - a. What z is off by, e, moves the gain by
    ///
    /// ```text
    /// e/2 (h² - e)^(-3/2)   for an L + V of length h
    /// ```
    ///
    /// at most, and h times that falls with h: it is largest for h = l.
    pub fn new(
        l_dot_v: Bound,
        rounding: f64,
        [shortest, least_operand, ulp]: [f64; 3],
    ) -> Option<HalfwayGain> {
        let Angular { angle, rest } = l_dot_v.angular()?;
        let least = shortest - angle;
        let z = Bound::near(Interval::at_least(least * least), 2.0 * rest + rounding);
        let is_known = least > 0.0 && z.real.low - z.error > least_operand;
        is_known.then(|| {
            let (moved, longest) = (reciprocal_root(z, least_operand, 0.0), 2.0);
            HalfwayGain {
                relative: least * moved + longest * 0.5 * ulp,
                most: least.recip() + moved + 0.5 * ulp,
                ends: angle,
                turn: (angle / shortest).min(1.0).asin(),
            }
        })
    }

    /// H*·N = (N·L + N·V)/|L + V|, rounded by `rounding`, of N·V and N·L as they come; nothing where
    /// they are not known as cosines.
    ///
    /// With r_v and r_l for what both are off beside the turns of N, L and V, and g for the gain:
    ///
    /// ```text
    /// angle ≤ turn of N + turn of L + V
    /// rest  ≤ (r_v + r_l) g + |L + V| e_g + r
    /// ```
    ///
    /// The angles of N·V, N·L and L·V are each the turns of two of the vectors: half their sum, of
    /// the first two less the third, is the turn of N.
    pub fn cosine(self, factors: [Bound; 2], rounding: f64) -> Option<Angular> {
        let [n_dot_v, n_dot_l] = [factors[0].angular()?, factors[1].angular()?];
        let of_normal = 0.5 * (n_dot_v.angle + n_dot_l.angle - self.ends).max(0.0);
        Some(Angular {
            angle: of_normal + self.turn,
            rest: (n_dot_v.rest + n_dot_l.rest) * self.most + self.relative + rounding,
        })
    }
}

/// How far a V·L that the host sends is off from that of the turned L. It is that of the real
/// vectors, and V is exact then: so it is what V·L is off, and what L is turned by, the difference
/// of both angles with N.
fn sent_light_dot_view(error: f64, [n_dot_v, n_dot_l]: [Angular; 2]) -> f64 {
    error + (n_dot_l.angle - n_dot_v.angle).max(0.0)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_datapath::bound::ErrorModel;
    use specula_fixtures::Draw;

    use super::*;

    /// Two unit vectors off across and along themselves, in one plane with them: half of what is
    /// allowed is reached.
    #[test]
    fn cosines_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for [across, along, rounding] in [[1e-3, 0.0, 0.0], [0.0, 1e-4, 0.0], [1e-3, 2e-3, 1e-3]] {
            let bound = cosine_of([VectorError::components(across, along); 2], rounding);
            let (mut angle, mut rest) = (0.0_f64, 0.0_f64);
            for _ in 0..50_000 {
                let x = draw.direction();
                let across_x = draw.across(x);
                let sine = draw.within(-1.0, 1.0);
                let y =
                    sine * across_x + (1.0 - sine * sine).sqrt() * draw.one_of(&[1.0, -1.0]) * x;
                let across_y = (across_x - across_x.dot(y) * y).normalize_or_zero();
                let moved_x = x * (1.0 + draw.error(along)) + draw.error(across) * across_x;
                let moved_y = y * (1.0 + draw.error(along)) + draw.error(across) * across_y;
                let turned = moved_x.normalize().dot(moved_y.normalize());
                let fixed = moved_x.dot(moved_y) + draw.error(rounding);
                let off = moved_x.angle_between(moved_y) - x.angle_between(y);
                angle = angle.max(off.abs() / bound.angle.max(1e-9));
                rest = rest.max((fixed - turned).abs() / bound.rest.max(1e-9));
            }
            println!("{across}, {along}, {rounding}: {angle} and {rest}");
            assert!(angle <= 1.0 + 1e-6 && rest <= 1.0 + 1e-6);
            assert!(across == 0.0 || angle > 0.5, "{across}: {angle}");
            assert!(rest > 0.5 || bound.rest < 1e-5, "{along}: {rest}");
        }
    }

    /// Three turned vectors whose cosines are off besides: 60 % of the angle is reached, and of the
    /// rest, for half-way vectors about as short as they may be.
    #[test]
    fn halfway_cosines_stay_within_the_bound_and_come_near() {
        let mut draw = Draw::new(1);
        let (turn, rest, rounding, ulp) = (1e-3, 1e-4, 1e-5, 1e-5);
        let cosine = |turns: f64| {
            let model = ErrorModel::Angular(Angular { angle: turns, rest });
            Bound { model, ..Bound::near(Interval::ANY, turns + rest) }
        };
        let known = cosine(2.0 * turn);
        for shortest in [0.5, 1.5] {
            let gain = HalfwayGain::new(known, rounding, [shortest, 1.0 / 256.0, ulp]).unwrap();
            let bound = gain.cosine([known; 2], rounding).unwrap();
            let mut reached = [0.0_f64; 2];
            for _ in 0..200_000 {
                let v = draw.direction();
                let half = (0.5 * shortest).acos() * (1.0 - draw.within(0.0, 1.0).powi(6));
                let across = draw.across(v);
                let l = (2.0 * half).cos() * v + (2.0 * half).sin() * across;
                let halfway = (l + v).normalize();
                let aside = halfway.cross(across).normalize_or(across);
                let n =
                    (halfway + draw.within(0.0, 1.0) * draw.one_of(&[aside, across])).normalize();
                let axis = draw.one_of(&[aside, across]);
                let mut turned = |x: DVec3| {
                    let axis = (axis - axis.dot(x) * x).normalize_or_zero();
                    (x + draw.error(turn.tan()) * axis).normalize()
                };
                let [n_turned, l_turned, v_turned] = [n, l, v].map(&mut turned);
                let z =
                    2.0 + 2.0 * (l_turned.dot(v_turned) + draw.error(rest)) + draw.error(rounding);
                let g = z.max(1.0 / 256.0).sqrt().recip() + draw.error(0.5 * ulp);
                let sum: f64 =
                    [l_turned, v_turned].map(|x| n_turned.dot(x) + draw.error(rest)).iter().sum();
                let fixed = sum * g + draw.error(rounding);
                let h = (l_turned + v_turned).normalize();
                let moved = h.angle_between(n_turned) - halfway.angle_between(n);
                reached[0] = reached[0].max(moved.abs() / bound.angle);
                reached[1] = reached[1].max((fixed - h.dot(n_turned)).abs() / bound.rest);
            }
            println!("{shortest}: {reached:?}");
            assert!(reached.iter().all(|&share| share <= 1.0 + 1e-3), "{shortest}: {reached:?}");
            assert!(reached.iter().all(|&share| share > 0.6), "{shortest}: {reached:?}");
        }
    }

    /// Any two vectors around a turned normal, with cosines off beside the turn: 90 % of the rest is
    /// reached, and of the angle.
    #[test]
    fn reflections_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        let (turn, rest, rounding) = (1e-3, 1e-4, 1e-5);
        let known = Angular { angle: turn, rest };
        let bound = reflected([known; 2], 0.0, rounding);
        let mut reached = [0.0_f64; 2];
        for _ in 0..50_000 {
            let (n, v, l) = (draw.direction(), draw.direction(), draw.direction());
            let l = draw.one_of(&[l, v, -v, 2.0 * n.dot(v) * n - v]);
            let n_turned = (n + draw.error(turn.tan()) * draw.across(n)).normalize();
            let cosines = [v, l].map(|x| n_turned.dot(x) + draw.error(rest));
            let fixed = 2.0 * cosines[0] * cosines[1] - v.dot(l) + draw.error(rounding);
            let reflection = |n: glam::DVec3| (2.0 * n.dot(v) * n - v).normalize();
            let turned = reflection(n_turned).angle_between(reflection(n));
            reached[0] = reached[0].max(turned / bound.angle);
            reached[1] = reached[1].max((fixed - reflection(n_turned).dot(l)).abs() / bound.rest);
        }
        println!("{reached:?}");
        assert!(reached.iter().all(|&share| share <= 1.0 + 1e-9 && share > 0.9), "{reached:?}");
    }
}

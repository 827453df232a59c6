//! How far a vector is off that turns by the same angle with each pixel.
use specula_spec::slerp::{LARGEST_WEIGHT, SlerpFormats};

use super::host::HOST_ERROR;

/// How far (c, s) can come from (cos iδ, sin iδ), as a distance in the plane.
///
/// Let z and w be the fixed and the real vector as complex numbers, cos δ + i sin δ off by a at
/// most and every state rounded by b: half a unit of the last place in each component.
///
/// ```text
/// a = u_turn/√2
/// b = u_state/√2
/// |z' - w'| ≤ (1 + a) |z - w| + a + b   after one step more
/// |z - w|   ≤ S (a + b) e^(S a)         after S steps
/// ```
pub fn drift(formats: &SlerpFormats, steps: u32) -> f64 {
    let s = f64::from(steps);
    let half_diagonal = 0.5f64.sqrt();
    let (a, b) =
        (half_diagonal * formats.turn.ulp() + HOST_ERROR, half_diagonal * formats.state.ulp());
    s * (a + b) * (s * a).exp()
}

/// As [`drift`], of what is m = 1/sin 10° long at most and begins off by b.
///
/// ```text
/// |z - w| ≤ (S (a m + b) + b) e^(S a)
/// ```
///
/// Where one sine is 0 and cos δ is 1 nothing turns, and what grows is off by half a unit of the
/// sine's and the state's last place for each step, which is less.
pub fn scaled_drift(formats: &SlerpFormats, steps: u32) -> f64 {
    let s = f64::from(steps);
    let half_diagonal = 0.5f64.sqrt();
    let (a, b) = (
        half_diagonal * formats.turn.ulp() + HOST_ERROR,
        half_diagonal * formats.scaled_state.ulp() + HOST_ERROR,
    );
    (s * (a * LARGEST_WEIGHT + b) + b) * (s * a).exp()
}

/// What of the drift turns (c, s), as a length across (cos iδ, sin iδ), of spans that turn by
/// `widest` at most.
///
/// Let u be (c, s) over (cos iδ, sin iδ), both as complex numbers: 1 but for an error within the
/// [`drift`] d. A step multiplies u by 1 + α, |α| ≤ a, and adds the rounding of the state, turned
/// back by (i + 1)δ. A rounding of half a unit in each component has no more than κ half units
/// across a direction within `widest` of an axis, κ as [`sum_of_components`] has it. So what u has
/// across 1 grows with each step by
///
/// ```text
/// a times itself
/// (1 + d) κ u_turn/2   what α has across
/// κ u_state/2          the rounding of the state
/// ```
///
/// at most, and after S steps is no more than S κ ((1 + d) u_turn/2 + u_state/2) e^(S a).
pub fn drift_across(formats: &SlerpFormats, steps: u32, widest: f64) -> f64 {
    let (s, kappa) = (f64::from(steps), sum_of_components(widest));
    let (half_turn, half_state) =
        (0.5 * formats.turn.ulp() + HOST_ERROR, 0.5 * formats.state.ulp());
    let a = 2f64.sqrt() * half_turn;
    s * kappa * ((1.0 + drift(formats, steps)) * half_turn + half_state) * (s * a).exp()
}

/// Largest cos t + sin t for t from 0 to `widest`, and so |cos t| + |sin t| of any t that is as
/// near to an axis.
pub fn sum_of_components(widest: f64) -> f64 {
    let (sine, cosine) = widest.min(std::f64::consts::FRAC_PI_4).sin_cos();
    sine + cosine
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;
    use specula_fixtures::formats::slerp_formats;

    use super::*;

    /// Every rounding at its worst, which turns further in each step: 70 % of the bound is reached.
    #[test]
    fn turns_drift_across_by_no_more_than_stated() {
        let formats = slerp_formats(12, 11);
        let (half_turn, half_state) = (0.5 * formats.turn.ulp(), 0.5 * formats.state.ulp());
        for (steps, widest) in [(1, 0.1), (7, 0.16), (20, 0.5), (50, 2.0)] {
            let step = widest / f64::from(steps);
            let (cosine, sine) = (step.cos() - half_turn, step.sin() + half_turn);
            let (mut c, mut s) = (1.0_f64, 0.0_f64);
            let mut across: f64 = 0.0;
            for i in 1..=steps {
                let t = f64::from(i) * step;
                (c, s) = (
                    c * cosine - s * sine - half_state,
                    s * cosine + c * sine + half_state * t.cos().signum(),
                );
                across = across.max((s * t.cos() - c * t.sin()).abs());
            }
            let bound = drift_across(&formats, steps, widest);
            assert!(
                across <= bound && across > 0.7 * bound,
                "{steps} steps, {widest}: {across} of {bound}"
            );
        }
    }

    /// The furthest that (c, s) of this length comes from the real one, over the bound: each
    /// rounding leads it on in the direction in which it is off already, where `leads`, else
    /// anywhere.
    fn furthest(
        draw: &mut Draw,
        length: f64,
        formats: &SlerpFormats,
        steps: u32,
        leads: bool,
    ) -> f64 {
        let (half_turn, half_state) = (0.5 * formats.turn.ulp(), 0.5 * formats.state.ulp());
        let (angle, step) = (draw.within(0.0, 6.3), draw.within(0.0, 0.2));
        let (cosine, sine) =
            (step.cos() + draw.error(half_turn), step.sin() + draw.error(half_turn));
        let starts_off = if length > 1.0 { half_state } else { 0.0 };
        let (mut c, mut s) = (
            length * angle.cos() + draw.error(starts_off),
            length * angle.sin() + draw.error(starts_off),
        );
        for i in 1..=steps {
            let t = angle + f64::from(i) * step;
            let turned = [c * cosine - s * sine, s * cosine + c * sine];
            let off = [turned[0] - length * t.cos(), turned[1] - length * t.sin()];
            let rounding = |off: f64, draw: &mut Draw| {
                if leads { half_state * off.signum() } else { draw.error(half_state) }
            };
            (c, s) = (turned[0] + rounding(off[0], draw), turned[1] + rounding(off[1], draw));
        }
        let t = angle + f64::from(steps) * step;
        (c - length * t.cos()).hypot(s - length * t.sin())
    }

    /// Turns and starts at random: 95 % of either bound is reached.
    #[test]
    fn drifting_vectors_stay_within_the_bounds_and_reach_them() {
        let formats = slerp_formats(12, 12);
        let mut draw = Draw::new(1);
        for steps in [1, 7, 40] {
            let bounds =
                [(1.0, drift(&formats, steps)), (LARGEST_WEIGHT, scaled_drift(&formats, steps))];
            for (length, bound) in bounds {
                let mut reached = 0.0_f64;
                for leads in [true, false] {
                    for _ in 0..5000 {
                        let off = furthest(&mut draw, length, &formats, steps, leads);
                        reached = reached.max(off / bound);
                    }
                }
                assert!(reached <= 1.0 && reached > 0.95, "{steps} of {length}: {reached}");
            }
        }
    }
}

//! A vector that turns by the same angle with each pixel.
use specula_scene::spec::slerp::{LARGEST_WEIGHT, SlerpFormats};

use super::HOST_ERROR;
use crate::builder::{Builder, Known, Sig};

/// Cosine and sine of the angle i δ, from (1, 0) on, by a rotation in every clock; `turn` is cos δ
/// and sin δ. [lecture, eq. 4.9 to 4.12; methods A11]
///
/// # Error
/// See [`drift`].
pub fn rotation(
    b: &Builder,
    first: &Sig,
    turn: [&Sig; 2],
    formats: &SlerpFormats,
    steps: u32,
) -> [Sig; 2] {
    let inputs = (("start", first), ("turn_cosine", turn[0]), ("turn_sine", turn[1]));
    let formula = "c' = c cos d - s sin d, s' = s cos d + c sin d [lecture, eq. 4.9-4.12]";
    let turned = b.unit("rotation", formula, inputs, |b, (first, cosine, sine)| {
        let drift = drift(formats, steps);
        let known =
            Known { limits: (-1.0 - drift, 1.0 + drift), fact: "c^2 + s^2 = 1", error: drift };
        let turn = Turn { cosine: &cosine, down: &sine, up: &sine };
        let [c, s] = turned(
            b,
            &first,
            [&b.integer(1), &b.integer(0)],
            turn,
            formats.state.fraction_bits,
            &known,
        );
        (c.named("cosine"), s.named("sine"))
    });
    [turned.0, turned.1]
}

/// The angle from pixel to pixel.
#[derive(Clone, Copy)]
pub struct Turn<'a> {
    /// cos δ.
    pub cosine: &'a Sig,
    /// sin δ as it takes from the cosine.
    pub down: &'a Sig,
    /// sin δ as it adds to the sine.
    pub up: &'a Sig,
}

/// The same from any start, larger than 1 by the factor 1/sin 10° at most, and with two sines:
/// where one of them is 0, one of cosine and sine stays, and the other grows by the same with each
/// pixel. [lecture, eq. 4.9 to 4.12; methods A9]
///
/// # Error
/// [`scaled_drift`]. Where one sine is 0 and cos δ is 1 nothing turns, and what grows is off by
/// half a unit of the sine's and the state's last place for each step, which is less.
pub fn scaled_rotation(
    b: &Builder,
    first: &Sig,
    starts: [&Sig; 2],
    turn: Turn,
    formats: &SlerpFormats,
    steps: u32,
) -> [Sig; 2] {
    let Turn { cosine, down, up } = turn;
    let inputs = (
        ("start", first),
        ("cosine_start", starts[0]),
        ("sine_start", starts[1]),
        ("turn_cosine", cosine),
        ("down", down),
        ("up", up),
    );
    let formula = "c' = c cos d - s sin d, s' = s cos d + c sin d [lecture, eq. 4.9-4.12]";
    let turned =
        b.unit("scaled_rotation", formula, inputs, |b, (first, c, s, cosine, down, up)| {
            let drift = scaled_drift(formats, steps);
            let limit = LARGEST_WEIGHT + drift;
            let known =
                Known { limits: (-limit, limit), fact: "c^2 + s^2 <= (1/sin 10)^2", error: drift };
            let turn = Turn { cosine: &cosine, down: &down, up: &up };
            let [c, s] =
                turned(b, &first, [&c, &s], turn, formats.scaled_state.fraction_bits, &known);
            (c.named("cosine"), s.named("sine"))
        });
    [turned.0, turned.1]
}

fn turned(
    b: &Builder,
    first: &Sig,
    starts: [&Sig; 2],
    turn: Turn,
    fraction_bits: u32,
    known: &Known,
) -> [Sig; 2] {
    b.recurrence(first, starts, fraction_bits, known, |[c, s]| {
        let (next_c, next_s) = (c * turn.cosine - s * turn.down, s * turn.cosine + c * turn.up);
        [next_c, next_s].map(|x| x.rounded(fraction_bits))
    })
}

/// As [`drift`], of what is m = 1/sin 10° long at most and begins off by b: S (a m + b) e^(S a),
/// and b more.
pub(super) fn scaled_drift(formats: &SlerpFormats, steps: u32) -> f64 {
    let s = f64::from(steps);
    let half_diagonal = 0.5f64.sqrt();
    let (a, b) = (
        half_diagonal * formats.turn.ulp() + HOST_ERROR,
        half_diagonal * formats.scaled_state.ulp() + HOST_ERROR,
    );
    (s * (a * LARGEST_WEIGHT + b) + b) * (s * a).exp()
}

/// How far (c, s) can come from (cos iδ, sin iδ), as a distance in the plane.
///
/// With cos δ + i sin δ off by a = u_t/√2 at most (half a unit of the last place in each component)
/// and every state rounded by b = u/√2, a step makes |z - w| ≤ (1 + a)|z - w| + a + b, so after S
/// steps it is at most S (a + b) e^(S a).
pub(super) fn drift(formats: &SlerpFormats, steps: u32) -> f64 {
    let s = f64::from(steps);
    let half_diagonal = 0.5f64.sqrt();
    let (a, b) =
        (half_diagonal * formats.turn.ulp() + HOST_ERROR, half_diagonal * formats.state.ulp());
    s * (a + b) * (s * a).exp()
}

/// What of the drift turns (c, s), as a length across (cos iδ, sin iδ), of spans that turn by
/// `widest` at most.
///
/// Let u be (c, s) over (cos iδ, sin iδ), both as complex numbers: 1 but for an error within the
/// [`drift`] d. A step multiplies u by 1 + α, |α| ≤ a, and adds the rounding of the state, turned
/// back by (i + 1)δ. A rounding of half a unit in each component has no more than κ half units
/// across a direction within `widest` of an axis, κ as [`sum_of_components`] has it. So what u has
/// across 1 grows by no more than (1 + a) times, (1 + d) times what α has across, and κ half units
/// of the state.
pub(super) fn drift_across(formats: &SlerpFormats, steps: u32, widest: f64) -> f64 {
    let (s, kappa) = (f64::from(steps), sum_of_components(widest));
    let (half_turn, half_state) =
        (0.5 * formats.turn.ulp() + HOST_ERROR, 0.5 * formats.state.ulp());
    let a = 2f64.sqrt() * half_turn;
    s * kappa * ((1.0 + drift(formats, steps)) * half_turn + half_state) * (s * a).exp()
}

/// Largest cos t + sin t for t from 0 to `widest`, and so |cos t| + |sin t| of any t that is as
/// near to an axis.
pub(super) fn sum_of_components(widest: f64) -> f64 {
    let (sine, cosine) = widest.min(std::f64::consts::FRAC_PI_4).sin_cos();
    sine + cosine
}

#[cfg(test)]
mod tests {
    use specula_scene::Format;

    use super::*;

    /// Every rounding at its worst, which turns further in each step.
    #[test]
    fn turns_drift_across_by_no_more_than_stated() {
        let any = Format::unsigned(1, 10);
        let formats = SlerpFormats {
            turn: Format::signed(1, 12),
            state: Format::signed(1, 11),
            scaled_state: any,
            weight: any,
            vector: any,
            component: any,
            cosine: any,
            diffuse: any,
            base: any,
            shape: any,
        };
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
}

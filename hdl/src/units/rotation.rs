//! A vector that turns by the same angle with each pixel.
use specula_scene::spec::slerp::SlerpFormats;

use super::HOST_ERROR;
use crate::builder::{Builder, Known, Sig};

/// Cosine and sine of the angle i δ, from (1, 0) on, by a rotation in every clock; `turn` is cos δ and sin δ. [lecture, eq. 4.9 to
/// 4.12; METHODS A11]
///
/// # Error
/// See [`drift`].
pub fn rotation(b: &Builder, first: &Sig, turn: [&Sig; 2], formats: &SlerpFormats, steps: u32) -> [Sig; 2] {
    let inputs = (("start", first), ("turn_cosine", turn[0]), ("turn_sine", turn[1]));
    let formula = "c' = c cos d - s sin d, s' = s cos d + c sin d [lecture, eq. 4.9-4.12]";
    let turned = b.unit("rotation", formula, inputs, |b, (first, cosine, sine)| {
        let drift = drift(formats, steps);
        let known = Known { limits: (-1.0 - drift, 1.0 + drift), fact: "c^2 + s^2 = 1", error: drift };
        let fraction_bits = formats.state.fraction_bits;
        let [one, zero] = [1, 0].map(|whole| b.integer(whole));
        let turned = b.recurrence(&first, [&one, &zero], fraction_bits, &known, |[c, s]| {
            let (next_c, next_s) = (c * &cosine - s * &sine, s * &cosine + c * &sine);
            [next_c, next_s].map(|x| x.rounded(fraction_bits))
        });
        let [c, s] = turned;
        (c.named("cosine"), s.named("sine"))
    });
    [turned.0, turned.1]
}

/// How far (c, s) can come from (cos iδ, sin iδ), as a distance in the plane.
///
/// With cos δ + i sin δ off by a = u_t/√2 at most (half a unit of the last place in each component) and every state rounded by
/// b = u/√2, a step makes |z - w| ≤ (1 + a)|z - w| + a + b, so after S steps it is at most S (a + b) e^(S a).
pub(super) fn drift(formats: &SlerpFormats, steps: u32) -> f64 {
    let s = f64::from(steps);
    let half_diagonal = 0.5f64.sqrt();
    let (a, b) = (half_diagonal * formats.turn.ulp() + HOST_ERROR, half_diagonal * formats.state.ulp());
    s * (a + b) * (s * a).exp()
}

//! A vector that turns by the same angle with each pixel.
use specula_spec::slerp::{LARGEST_WEIGHT, SlerpFormats};

use crate::error::rotation::{drift, scaled_drift};
use specula_datapath::builder::{Builder, LoopInvariant, Sig};

/// Cosine and sine of the angle i δ, from (1, 0) on, by a rotation in every clock; `turn` is cos δ
/// and sin δ. [lecture, eq. 4.9 to 4.12; methods A11]
///
/// # Error
/// [`drift`].
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
        let invariant = LoopInvariant {
            limits: (-1.0 - drift, 1.0 + drift),
            fact: "c^2 + s^2 = 1",
            error: drift,
        };
        let turn = Turn { cosine: &cosine, down: &sine, up: &sine };
        let [c, s] = turned(
            b,
            &first,
            [&b.integer(1), &b.integer(0)],
            turn,
            formats.state.fraction_bits,
            &invariant,
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
/// [`scaled_drift`].
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
            let invariant = LoopInvariant {
                limits: (-limit, limit),
                fact: "c^2 + s^2 <= (1/sin 10)^2",
                error: drift,
            };
            let turn = Turn { cosine: &cosine, down: &down, up: &up };
            let [c, s] =
                turned(b, &first, [&c, &s], turn, formats.scaled_state.fraction_bits, &invariant);
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
    invariant: &LoopInvariant,
) -> [Sig; 2] {
    b.recurrence(first, starts, fraction_bits, invariant, |[c, s]| {
        let (next_c, next_s) = (c * turn.cosine - s * turn.down, s * turn.cosine + c * turn.up);
        [next_c, next_s].map(|x| x.rounded(fraction_bits))
    })
}

//! Normals along an arc, or so near to it that a factor brings them to unit length.
use specula_scene::spec::slerp::SlerpFormats;

use super::rotation::{drift, scaled_drift};
use crate::builder::{Builder, Off, Sig, Vector};

/// What is known of the weights that a normal is put together with.
#[derive(Clone, Copy, Debug)]
pub struct Weighing {
    /// By how much both are off, as a length in the plane where their vectors are orthonormal, and
    /// as a sum where they are the ends.
    off: f64,
    /// What both add up to at most.
    sum: f64,
    /// Length of the shortest normal that is put together.
    shortest: f64,
}

impl Weighing {
    /// Of cosine and sine, after `steps` turns at most.
    pub fn orthonormal(formats: &SlerpFormats, steps: u32) -> Weighing {
        let off = drift(formats, steps) + 0.5f64.sqrt() * formats.weight.ulp();
        Weighing { off, sum: 2f64.sqrt(), shortest: 1.0 }
    }

    /// Between the ends: sin((1 - t) f)/sin f + sin(t f)/sin f = cos((1/2 - t) f)/cos(f/2), where
    /// cos(f/2) is the length of the chord's middle, `shortest_chord` or more, and f is 170 degrees
    /// at most. Below 10 degrees chords do, no shorter than cos 5°.
    pub fn between_ends(formats: &SlerpFormats, steps: u32, shortest_chord: f64) -> Weighing {
        let narrowest = 85f64.to_radians().cos();
        let off = 2.0 * (scaled_drift(formats, steps) + 0.5 * formats.weight.ulp());
        Weighing {
            off,
            sum: (1.0 / shortest_chord.max(narrowest)).max(2f64.sqrt()),
            shortest: 5f64.to_radians().cos(),
        }
    }
}

/// N = u P + v Q, and n = N (3 - N·N)/2: Newton's step towards unit length from 1 on. [lecture, eq.
/// 4.7; methods A8, A9, A11]
///
/// l (3 - l²)/2 ≤ 1 for any length l, so n is no longer than 1 but for rounding.
///
/// # Error
/// N is off by e: what the weights are off, and their sum times what P and Q are rounded by. That
/// turns it by e/√(l (l - e)) at most, l for the shortest N; the direction of n is the same. Its
/// length moves by e times 3/2 (1 - l²) at the worst length, and by what (3 - N·N)/2 is rounded by.
pub fn turned_normal(
    b: &Builder,
    weights: [&Sig; 2],
    axes: [&Vector; 2],
    formats: &SlerpFormats,
    known: Weighing,
) -> Vector {
    let inputs = (("u", weights[0]), ("v", weights[1]), ("p", axes[0]), ("q", axes[1]));
    b.unit(
        "turned_normal",
        "n = N (3 - N.N)/2, N = u P + v Q [lecture, eq. 4.7]",
        inputs,
        |b, (u, v, p, q)| {
            let longest_axis = p.longest().max(q.longest());
            let off = known.off * longest_axis + known.sum * p.off().length.max(q.off().length);
            let longest = 1.0 + off;
            let sum = &p.scaled(&u) + &q.scaled(&v);
            let turned = sum
                .assumed_within(longest, "|N| <= 1")
                .proven_off_by(off)
                .rounded(formats.vector.fraction_bits)
                .named("turned");

            let square = turned.length_squared_within(turned.longest(), "|N| <= 1");
            let gain = (b.integer(3) - square)
                .halved()
                .rounded(formats.cosine.fraction_bits)
                .named("gain");
            let half_unit = 0.5 * formats.cosine.ulp();
            let error = lengthened(turned.off().length, known.shortest, half_unit);
            let most = 1.0 + half_unit * turned.longest();
            let n = turned.scaled(&gain).assumed_within(most, "|n| <= 1");
            n.known_off(error).rounded(formats.vector.fraction_bits).named("n")
        },
    )
}

/// How far n is off where N is by `e`.
fn lengthened(e: f64, shortest: f64, half_unit: f64) -> Off {
    if e >= shortest / 2.0 {
        return Off::within(2.0 + half_unit);
    }
    let turned = e / (shortest * (shortest - e)).sqrt();
    let slope = 1.5 * (1.0 - (shortest - e).powi(2)).max((1.0 + e).powi(2) - 1.0);
    Off::parts(turned, slope * e + half_unit * (1.0 + e) + turned * turned / 2.0)
}

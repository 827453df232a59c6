//! Diffuse intensity.
use specula_spec::Format;
use specula_spec::lyon::LyonFormats;

use super::clamp::{to_nonnegative, to_unit_interval};
use crate::error;
use specula_datapath::builder::{Builder, Sig, Vector};

/// Lambert's cosine, I = max(N·L, 0), of vectors that are known to be no longer than about 1. [Lyon,
/// TR 43; methods B]
pub fn diffuse(b: &Builder, n: &Vector, l: &Vector, formats: &LyonFormats) -> Sig {
    b.unit("diffuse", "I = max(N.L, 0) [Lambert]", (("n", n), ("l", l)), |_, (n, l)| {
        let lengths = (n.longest(), l.longest());
        let bits = formats.product.fraction_bits;
        let cosine = n.truncated_dot_within(&l, bits, lengths, "|N.L| <= |N||L|");
        to_nonnegative(&cosine, formats.diffuse.fraction_bits).named("intensity")
    })
}

/// The cosine between a vector that is to be no longer than 1 and a unit vector, kept within 0
/// to 1. Error: [`error::diffuse::cosine`].
pub fn clamped_cosine(b: &Builder, v: &Vector, l: &Vector, format: Format) -> Sig {
    b.unit("clamped_cosine", "min(max(V.L, 0), 1)", (("v", v), ("l", l)), |_, (v, l)| {
        let error = error::diffuse::cosine(v.bound(), l.bound());
        let cosine = v.dot(&l).tighten_error("error::diffuse::cosine", error);
        to_unit_interval(&cosine, format.fraction_bits).named("cosine")
    })
}

/// Gouraud's linearly interpolated intensity, from its start and step, rounded to `fraction_bits`.
/// [lecture, eq. 3.2 to 3.6; methods A4]
///
/// After `steps` steps at most it leaves [0, 1], where the true intensity lies, by no more than
/// [`error::diffuse::overshoot`].
pub fn gouraud(
    b: &Builder,
    first: &Sig,
    (start, step): (&Sig, &Sig),
    fraction_bits: u32,
    steps: u32,
) -> Sig {
    let inputs = (("start", first), ("intensity_start", start), ("intensity_step", step));
    b.unit(
        "gouraud",
        "I(i) = I(0) + i dI [lecture, eq. 3.2-3.6]",
        inputs,
        |_, (first, start, step)| {
            let past = error::diffuse::overshoot(steps, start.ulp());
            let limits = (-past, 1.0 + past);
            let sum = Sig::accumulated(&first, &start, &step, limits, steps, "0 <= I <= 1");
            to_unit_interval(&sum, fraction_bits).named("intensity")
        },
    )
}

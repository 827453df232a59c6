//! Diffuse intensity.
use specula_scene::Format;
use specula_scene::spec::lyon::LyonFormats;

use super::HOST_ERROR;
use crate::builder::{Builder, Sig, Vector};

/// Lambert's cosine, I = max(N·L, 0). [Lyon, TR 43; methods B]
pub fn diffuse(b: &Builder, n: &Vector, l: &Vector, formats: &LyonFormats) -> Sig {
    b.unit("diffuse", "I = max(N.L, 0) [Lambert]", (("n", n), ("l", l)), |_, (n, l)| {
        // |N·L| ≤ |N||L|, and a rounded unit vector is longer than 1 by √3/2 units of the last place at most.
        let lengths = (n.longest(), 1.0 + formats.vector.ulp());
        let cosine = n.dot_within(&l, lengths, "|N.L| <= |N||L|");
        cosine.rounded(formats.diffuse.fraction_bits).at_least_zero().named("intensity")
    })
}

/// The cosine between a vector that is to be no longer than 1 and a unit vector, kept within 0
/// to 1.
///
/// The real cosine's vectors are no longer than 1, so with vectors off by e_v and e_l it is off by
/// e_v + e_l + e_v e_l.
pub fn clamped_cosine(b: &Builder, v: &Vector, l: &Vector, format: Format) -> Sig {
    b.unit("clamped_cosine", "min(max(V.L, 0), 1)", (("v", v), ("l", l)), |_, (v, l)| {
        let (e_v, e_l) = (v.off().length, l.off().length);
        let error = e_v + e_l + e_v * e_l;
        let cosine = v.dot(&l).proven_error_value(error).rounded(format.fraction_bits);
        cosine.at_least_zero().clamped_above(1).named("cosine")
    })
}

/// Gouraud's linearly interpolated intensity, from its start and step, rounded to `fraction_bits`.
/// [lecture, eq. 3.2 to 3.6; methods A4]
///
/// Start and step are each off by half a unit of the accumulator's last place, so after `steps`
/// steps the sum is off by (1 + `steps`)/2, and by no more outside [0, 1], where the true intensity
/// lies.
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
            let slack = f64::from(steps + 1) * start.ulp() + HOST_ERROR;
            let sum = Sig::accumulated(
                &first,
                &start,
                &step,
                (-slack, 1.0 + slack),
                steps,
                "0 <= I <= 1",
            );
            sum.rounded(fraction_bits).at_least_zero().clamped_above(1).named("intensity")
        },
    )
}

//! Scalars along an arc: what the normal's rotation makes of them, and the base of the highlight.
//! What is proven of them: [`error::turned`].
use specula_spec::slerp::SlerpFormats;

use super::reflected::{Direction, Reflected, UnitBound, reflected};
use crate::error;
use specula_datapath::bound::Angular;
use specula_datapath::builder::{Builder, Sig, Vector};

/// N·X = c A·X + s T·X, for L and V alike. [lecture, eq. 4.7; methods A10]
pub fn along_arc(
    b: &Builder,
    weights: [&Sig; 2],
    [start, across]: [&Sig; 2],
    formats: &SlerpFormats,
    steps: u32,
) -> Sig {
    let inputs = (("c", weights[0]), ("s", weights[1]), ("at_start", start), ("across", across));
    b.unit(
        "along_arc",
        "N.X = c A.X + s T.X [lecture, eq. 4.7]",
        inputs,
        |_, (c, s, start, across)| {
            let most = error::turned::largest_scalar(formats, steps);
            let cosine = (c * start + s * across).assumed(-most, most, "|N.X| <= |N||X|");
            cosine.rounded(formats.cosine.fraction_bits).named("cosine")
        },
    )
}

/// N·X = c A·X + s T·X of a way X, no longer than 1, whose scalars are off by as much as they are.
/// [lecture, eq. 4.7; Hast et al., eq. 35]
pub fn way_along_arc(
    b: &Builder,
    weights: [&Sig; 2],
    [start, across]: [&Sig; 2],
    fraction_bits: u32,
) -> Sig {
    let inputs = (("c", weights[0]), ("s", weights[1]), ("at_start", start), ("across", across));
    b.unit(
        "way_along_arc",
        "N.X = c A.X + s T.X [lecture, eq. 4.7]",
        inputs,
        |_, (c, s, start, across)| (c * start + s * across).rounded(fraction_bits).named("product"),
    )
}

/// N·X of a unit normal and a way X, no longer than 1. [Hast et al., eq. 35]
pub fn product_with_way(b: &Builder, normal: &Vector, way: &Vector, fraction_bits: u32) -> Sig {
    b.unit("product_with_way", "p = N.X", (("normal", normal), ("way", way)), |_, (n, x)| {
        n.dot(&x).rounded(fraction_bits).named("product")
    })
}

/// K (2 - N·N): what N is too long or too short by leaves 2 J K but for its square, since z (2 -
/// z) = 1 - (1 - z)².
pub fn corrected(
    b: &Builder,
    n_dot_v: &Sig,
    weights: [&Sig; 2],
    formats: &SlerpFormats,
    steps: u32,
) -> Sig {
    let inputs = (("n_dot_v", n_dot_v), ("c", weights[0]), ("s", weights[1]));
    b.unit("length_correction", "K' = K (2 - N.N)", inputs, |b, (k, c, s)| {
        let fraction_bits = formats.cosine.fraction_bits;
        // Not from near 1 on: registers are 0 before the first pixel, and a range holds what they
        // hold.
        let most = error::turned::largest_square(formats, steps);
        let squared_length = (c.squared() + s.squared()).assumed(0.0, most, "c^2 + s^2 <= 1");
        let correction = (b.integer(2) - squared_length).rounded(fraction_bits).named("correction");
        (k * correction).rounded(fraction_bits).named("corrected")
    })
}

/// 2 J K' - L·V, kept within 0 to 1, of which so much is `proven`. [lecture, eq. 4.5; methods A10]
pub fn specular_base(
    b: &Builder,
    j: &Sig,
    k: &Sig,
    light_dot_view: &Sig,
    proven: Angular,
    formats: &SlerpFormats,
) -> Sig {
    let inputs = (("n_dot_l", j), ("n_dot_v", k), ("light_dot_view", light_dot_view));
    b.unit(
        "specular_base",
        "b = max(2 J K - L.V, 0) [lecture, eq. 4.5]",
        inputs,
        |b, (j, k, light_dot_view)| {
            let of = Reflected {
                factors: [&j, &k],
                product_error: f64::INFINITY,
                light_dot_view: &light_dot_view,
                direction: Direction::Always,
                fraction_bits: formats.base.fraction_bits,
            };
            reflected(b, of, |_| UnitBound::Cosine("error::turned::base", proven))
        },
    )
}

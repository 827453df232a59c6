//! The vector D, whose squared length the highlight depends on. Lengths and errors:
//! [`error::difference`].
use specula_spec::lyon::LyonFormats;

use crate::error::difference::{self, Difference};
use crate::error::length_error::LengthError;
use specula_datapath::bound::VectorError;
use specula_datapath::builder::{Builder, Vector};

/// D = H × N with H = L + V, as long as the part of H that is perpendicular to N. [methods B13]
pub fn halfway_cross_normal(b: &Builder, h: &Vector, n: &Vector, formats: &LyonFormats) -> Vector {
    b.unit(
        "halfway_cross_normal",
        "D = H x N, H = L + V [methods B13]",
        (("h", h), ("n", n)),
        |_, (h, n)| {
            let (vector, of) = (formats.vector, [&h, &n].map(Vector::bound));
            let proven = difference::cross_product(of, vector, formats.truncated(vector));
            let d = h.truncated_cross(&n, formats.product.fraction_bits);
            rounded(&d, proven, "|H x N| <= |H||N|", formats)
        },
    )
}

/// D = R - L with R = 2(N·V)N - V, the view vector reflected about the normal, and how far |D| is
/// off. [Lyon, TR 43, fig. 7; methods B1, B2]
pub fn reflection_minus_light(
    b: &Builder,
    n: &Vector,
    v: &Vector,
    l: &Vector,
    formats: &LyonFormats,
) -> (Vector, LengthError) {
    let formula = "D = 2(N.V)N - V - L [Lyon, TR 43, fig. 7]";
    let inputs = (("n", n), ("v", v), ("l", l));
    let d = b.unit("reflection_minus_light", formula, inputs, |_, (n, v, l)| {
        reflected_minus(&n, ("twice_n_dot_v", &v), &l, formats)
    });
    let of = [n, v, l].map(Vector::bound);
    (d, difference::reflection_length(of, formats.difference))
}

/// D2 = 2(N·L)N - L - V, the light reflected about the normal, less V, and how far |D2| is off. [Lyon, TR 43, fig. 5; methods B4]
pub fn light_reflection(
    b: &Builder,
    n: &Vector,
    l: &Vector,
    v: &Vector,
    formats: &LyonFormats,
) -> (Vector, LengthError) {
    let formula = "D = 2(N.L)N - L - V [Lyon, TR 43, fig. 5]";
    let inputs = (("n", n), ("l", l), ("v", v));
    let d = b.unit("light_reflection", formula, inputs, |_, (n, l, v)| {
        reflected_minus(&n, ("twice_n_dot_l", &l), &v, formats)
    });
    let of = [n, l, v].map(Vector::bound);
    (d, difference::reflection_length(of, formats.difference))
}

/// The unit vector v reflected about n, less the unit vector l: 2(n·v)n - v - l, where 2 n·v gets
/// the name `twice`.
fn reflected_minus(
    n: &Vector,
    (twice, v): (&str, &Vector),
    l: &Vector,
    formats: &LyonFormats,
) -> Vector {
    let proven =
        difference::reflection([n, v, l].map(Vector::bound), (formats.vector, formats.difference));
    let cosine = n.dot_within(v, (n.longest(), v.longest()), "|N.V|, |N.L| <= |N|");
    let twice = cosine.doubled().rounded(formats.difference.fraction_bits).named(twice);
    let reflection = n.scaled(&twice) - v;
    rounded(&(reflection - l), proven, "|R - L| <= |R| + |L|", formats)
}

/// D = (H·N)N - H, the way from H to its projection on N; `h` is H = L + V or about a unit vector.
/// [Lyon, TR 43, fig. 5; methods B5, B6]
pub fn halfway_projection(b: &Builder, h: &Vector, n: &Vector, formats: &LyonFormats) -> Vector {
    let formula = "D = (H.N)N - H [Lyon, TR 43, fig. 5]";
    b.unit("halfway_projection", formula, (("h", h), ("n", n)), |_, (h, n)| {
        let proven = difference::projection([&h, &n].map(Vector::bound), formats.difference);
        let h_dot_n = h
            .dot_within(&n, (h.longest(), n.longest()), "|H.N| <= |H||N|")
            .rounded(formats.difference.fraction_bits)
            .named("h_dot_n");
        rounded(&(n.scaled(&h_dot_n) - &h), proven, "|(H.N)N - H| <= |H|", formats)
    })
}

/// D = h - N for a half-way vector h of about unit length: no multiplier at all. [Lyon, TR 43;
/// methods B6]
pub fn halfway_minus_normal(b: &Builder, h: &Vector, n: &Vector, formats: &LyonFormats) -> Vector {
    b.unit("halfway_minus_normal", "D = h - N [Lyon, TR 43]", (("h", h), ("n", n)), |_, (h, n)| {
        let proven = difference::minus([&h, &n].map(Vector::bound));
        rounded(&(&h - &n), proven, "|h - N| <= |h| + |N|", formats)
    })
}

/// D to its format, of which `fact` says that it is no longer than proven.
fn rounded(d: &Vector, proven: Difference, fact: &str, formats: &LyonFormats) -> Vector {
    d.assumed_within(proven.longest, fact)
        .tighten_error(proven.proof, VectorError::ball(proven.error))
        .rounded(formats.difference.fraction_bits)
        .named("d")
}

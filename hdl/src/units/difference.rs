//! The vector D, whose squared length the highlight depends on.
use specula_scene::spec::lyon::LyonFormats;

use crate::builder::{Builder, Vector};

/// D = H × N with H = L + V, as long as the part of H that is perpendicular to N. [METHODS B13]
///
/// |D| ≤ |H||N| and |H| ≤ 2. A component of D is off by the errors of two components of N times |H|, and the other way round:
/// √2 (|H| e_N + |N| e_H).
pub fn halfway_cross_normal(b: &Builder, h: &Vector, n: &Vector, formats: &LyonFormats) -> Vector {
    b.unit("halfway_cross_normal", "D = H x N, H = L + V [METHODS B13]", (("h", h), ("n", n)), |_, (h, n)| {
        let (longest_h, longest_n) = (2.0 + 2.0 * formats.vector.ulp(), n.longest());
        let (e_h, e_n) = (h.largest_error(), n.largest_error());
        let error = std::f64::consts::SQRT_2 * (longest_h * e_n + longest_n * e_h + e_h * e_n);
        let d = h.cross(&n).assumed_within(longest_h * longest_n, "|H x N| <= |H||N|");
        d.proven_error_value(error).rounded(formats.difference.fraction_bits).named("d")
    })
}

/// D = R - L with R = 2(N·V)N - V, the view vector reflected about the normal. [Lyon, TR 43, fig. 7; METHODS B1, B2]
pub fn reflection_minus_light(b: &Builder, n: &Vector, v: &Vector, l: &Vector, formats: &LyonFormats) -> Vector {
    let formula = "D = 2(N.V)N - V - L [Lyon, TR 43, fig. 7]";
    b.unit("reflection_minus_light", formula, (("n", n), ("v", v), ("l", l)), |_, (n, v, l)| {
        reflected_minus(&n, ("twice_n_dot_v", &v), &l, formats)
    })
}

/// D2 = 2(N·L)N - L - V, the light reflected about the normal, less V. [Lyon, TR 43, fig. 5; METHODS B4]
pub fn light_reflection(b: &Builder, n: &Vector, l: &Vector, v: &Vector, formats: &LyonFormats) -> Vector {
    let formula = "D = 2(N.L)N - L - V [Lyon, TR 43, fig. 5]";
    b.unit("light_reflection", formula, (("n", n), ("l", l), ("v", v)), |_, (n, l, v)| {
        reflected_minus(&n, ("twice_n_dot_l", &l), &v, formats)
    })
}

/// The unit vector `of` reflected about n, less the unit vector `from`: 2(n·of)n - of - from.
///
/// It is no longer than the reflection and 1, and the reflection exceeds 1 no more than |n|² does.
fn reflected_minus(n: &Vector, (name, of): (&str, &Vector), from: &Vector, formats: &LyonFormats) -> Vector {
    let fraction_bits = formats.difference.fraction_bits;
    let cosine = n.dot_within(of, (n.longest(), of.longest()), "|N.V|, |N.L| <= |N|");
    let twice = cosine.doubled().rounded(fraction_bits).named(name);
    let reflection = n.scaled(&twice) - of;
    // R = 2(N·V)N - V is off by up to |N|² in length as N is, and rounding each component adds to that.
    let longest_n = n.longest();
    let longest = 2.0 * longest_n * longest_n + 8.0 * formats.vector.ulp() + 8.0 * formats.difference.ulp();
    (reflection - from).assumed_within(longest, "|R - L| <= |R| + |L|").rounded(fraction_bits).named("d")
}

/// D = (H·N)N - H, the way from H to its projection on N; `h` is H = L + V or about a unit vector. [Lyon, TR 43, fig. 5; METHODS B5, B6]
///
/// With r = |N|, the part along N is (r² - 1) times that of H and the part across is that of H: |D| ≤ |H| max(1, r² - 1). Rounding H·N
/// lengthens it by |N|/2 units of the last place.
pub fn halfway_projection(b: &Builder, h: &Vector, n: &Vector, formats: &LyonFormats) -> Vector {
    let formula = "D = (H.N)N - H [Lyon, TR 43, fig. 5]";
    b.unit("halfway_projection", formula, (("h", h), ("n", n)), |_, (h, n)| {
        let fraction_bits = formats.difference.fraction_bits;
        let lengths = (h.longest(), n.longest());
        let h_dot_n = h.dot_within(&n, lengths, "|H.N| <= |H||N|").rounded(fraction_bits).named("h_dot_n");
        let longest = lengths.0 * (lengths.1 * lengths.1 - 1.0).max(1.0) + lengths.1 * formats.difference.ulp();
        let d = n.scaled(&h_dot_n) - &h;
        d.assumed_within(longest, "|(H.N)N - H| <= |H|").rounded(fraction_bits).named("d")
    })
}

/// D = h - N for a half-way vector h of about unit length: no multiplier at all. [Lyon, TR 43; METHODS B6]
pub fn halfway_minus_normal(b: &Builder, h: &Vector, n: &Vector, formats: &LyonFormats) -> Vector {
    b.unit("halfway_minus_normal", "D = h - N [Lyon, TR 43]", (("h", h), ("n", n)), |_, (h, n)| {
        let longest = h.longest() + n.longest();
        (&h - &n).assumed_within(longest, "|h - N| <= |h| + |N|").rounded(formats.difference.fraction_bits).named("d")
    })
}

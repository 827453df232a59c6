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
        let (e_h, e_n) = (h.x.error_value(), n.x.error_value());
        let error = std::f64::consts::SQRT_2 * (longest_h * e_n + longest_n * e_h + e_h * e_n);
        let d = h.cross(&n).assumed_within(longest_h * longest_n, "|H x N| <= |H||N|");
        d.proven_error_value(error).rounded(formats.difference.fraction_bits).named("d")
    })
}

/// D = R - L with R = 2(N·V)N - V, the view vector reflected about the normal. [Lyon, TR 43, fig. 7; METHODS B1, B2]
///
/// |R - L| ≤ |R| + |L|, and |R| exceeds 1 no more than |N|² does.
pub fn reflection_minus_light(b: &Builder, n: &Vector, v: &Vector, l: &Vector, formats: &LyonFormats) -> Vector {
    let formula = "D = 2(N.V)N - V - L [Lyon, TR 43, fig. 7]";
    b.unit("reflection_minus_light", formula, (("n", n), ("v", v), ("l", l)), |_, (n, v, l)| {
        let fraction_bits = formats.difference.fraction_bits;
        let twice_n_dot_v = n.dot(&v).doubled().rounded(fraction_bits).named("twice_n_dot_v");
        let reflection = n.scaled(&twice_n_dot_v) - &v;
        // R = 2(N·V)N - V is off by up to |N|² in length as N is, and rounding each component adds to that.
        let longest_n = n.longest();
        let longest = 2.0 * longest_n * longest_n + 8.0 * formats.vector.ulp() + 8.0 * formats.difference.ulp();
        (reflection - &l).assumed_within(longest, "|R - L| <= |R| + |L|").rounded(fraction_bits).named("d")
    })
}

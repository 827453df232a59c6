//! Normals of unit length without a root.
use specula_scene::spec::lyon::LyonFormats;

use super::divider;
use crate::builder::{Builder, Sig, Vector};

/// n = 2v H - w with v = H·w / H·H: the unit vector w, wrapped around H = N' + w. [Hast, Barrera and Bengtsson, eq. 27; METHODS C4]
///
/// It is -w reflected about H, so as long as w whatever H is. With N' within 90 degrees of w and the unit ball, |H|² = 1 + |N'|² + 2N'·w is
/// 1 at least and 0 ≤ v ≤ 1.
///
/// # Error
/// n differs from the wrap of the rounded H and w by 2|H| times the error of v, which rounding makes u_p/|H|² + u_v/2: less than
/// 2 u_p/|H| + 2.1 u_v, and for the length |H| is not below 3/4.
///
/// The wrap itself is an isometry in w, and in H twice the projection on its direction û. Projections on û and û' differ by no more than
/// |û - û'| ≤ |H - H'|/√(|H||H'|), so components of H off by e move n by 2|w| √3 e/(1 - √3 e).
pub fn wrapped(b: &Builder, h: &Vector, w: &Vector, formats: &LyonFormats) -> Vector {
    b.unit("wrapped", "n = 2v H - w, v = H.w / H.H [Hast et al., eq. 27]", (("h", h), ("w", w)), |b, (h, w)| {
        let operand_bits = formats.wrap_operand.fraction_bits;
        let lengths = (h.longest(), w.longest());
        let p = h.dot_within(&w, lengths, "|H.w| <= |H||w|").rounded(operand_bits).named("p");
        let q = h.length_squared_within(lengths.0, "|H| <= 2").rounded(operand_bits).named("q");
        let shortest_squared = 1.0;
        let v = divider(b, &p, &q, formats.wrap_ratio.fraction_bits, shortest_squared).named("v");
        let longest = lengths.1 + 2.0 * formats.vector.ulp() + 4.0 * formats.wrap_operand.ulp() + 4.0 * formats.wrap_ratio.ulp();
        let e_h = 3f64.sqrt() * [&h.x, &h.y, &h.z].map(Sig::error_value).into_iter().fold(0.0, f64::max);
        let shortest = 1.0 - e_h;
        let of_rounding = 2.0 * formats.wrap_operand.ulp() / shortest + 2.1 * formats.wrap_ratio.ulp();
        let error = 2.0 * lengths.1 * e_h / shortest + 3f64.sqrt() * w.largest_error() + of_rounding;
        let n = h.scaled(&v.doubled()) - &w;
        // Where rounding is as coarse as H is long, what is propagated is all that is known.
        let n = if shortest > 0.0 { n.proven_error_value(error) } else { n };
        n.assumed_within(longest, "|2v H - w| = |w|").rounded(formats.vector.fraction_bits).named("n")
    })
}

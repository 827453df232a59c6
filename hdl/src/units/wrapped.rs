//! Normals of unit length without a root.
use specula_scene::spec::lyon::LyonFormats;

use super::divider;
use crate::builder::{Builder, Vector};

/// n = 2v H - w with v = H·w / H·H: the unit vector w, wrapped around H = N' + w. [Hast, Barrera and Bengtsson, eq. 27; METHODS C4]
///
/// It is -w reflected about H, so as long as w whatever H is. With N' within 90 degrees of w and the unit ball, |H|² = 1 + |N'|² + 2N'·w is
/// 1 at least and 0 ≤ v ≤ 1.
///
/// # Error
/// n is longer than w by what rounding makes of v, which is u_p/|H|² for the operands and u_v/2 for the ratio, times 2|H|: with |H| not below
/// 3/4 by rounding, less than 3 u_p + 2 u_v. A component of n is off by 2(|H_c| e_v + v e_H + e_v e_H) + e_w.
pub fn wrapped(b: &Builder, h: &Vector, w: &Vector, formats: &LyonFormats) -> Vector {
    b.unit("wrapped", "n = 2v H - w, v = H.w / H.H [Hast et al., eq. 27]", (("h", h), ("w", w)), |b, (h, w)| {
        let operand_bits = formats.wrap_operand.fraction_bits;
        let lengths = (h.longest(), w.longest());
        let p = h.dot_within(&w, lengths, "|H.w| <= |H||w|").rounded(operand_bits).named("p");
        let q = h.length_squared_within(lengths.0, "|H| <= 2").rounded(operand_bits).named("q");
        let shortest_squared = 1.0;
        let v = divider(b, &p, &q, formats.wrap_ratio.fraction_bits, shortest_squared).named("v");
        let longest = lengths.1 + 2.0 * formats.vector.ulp() + 4.0 * formats.wrap_operand.ulp() + 4.0 * formats.wrap_ratio.ulp();
        let n = h.scaled(&v.doubled()) - &w;
        n.assumed_within(longest, "|2v H - w| = |w|").rounded(formats.vector.fraction_bits).named("n")
    })
}

//! What the defaults of all methods are made of.
use specula_scene::needs::Needs;

use crate::narrowing::LARGEST_ROOT_REACH;

/// Bits that number the pixels of the longest span.
pub(crate) fn span_bits(longest_span: u32) -> u32 {
    longest_span.next_power_of_two().ilog2()
}

/// Bits by which q = N·N falls short of 1 where normals are shortest; 8 at most, which spans of 165
/// degrees take.
pub(crate) fn small_q_bits(needs: &Needs) -> u32 {
    (-2.0 * needs.shortest_normal.max(0.0625).log2()).ceil() as u32
}

/// Integer bits m of 1/√q, q = N·N, for the shortest normal of a scene.
pub(crate) fn root_reach(needs: &Needs, operand: u32) -> u32 {
    reach(needs.shortest_normal, operand)
}

/// Integer bits m of 1/√q that reach twice as far as the shortest vector asks, so that rounding
/// cannot lead past them; q of `operand` fraction bits tells 4^-m from 0.
pub(crate) fn reach(shortest: f64, operand: u32) -> u32 {
    let shortest = shortest.max(0.5f64.powi(LARGEST_ROOT_REACH as i32));
    ((-shortest.log2()).ceil() as u32 + 1).min(operand / 2).min(LARGEST_ROOT_REACH)
}

/// log₂ n of the largest exponent, rounded up: how many bits of its base are lost in the power.
pub(crate) fn exponent_bits(needs: &Needs) -> u32 {
    needs.largest_shininess.max(1).next_power_of_two().ilog2()
}

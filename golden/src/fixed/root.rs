//! `reciprocal_square_root` of docs/arithmetic.md.
use super::number::{Wide, round_reciprocal_root};

/// 1/√max(z, 4^-m) rounded to nearest with ties up, m = `integer_bits`; z has 24 fraction bits at
/// most.
pub(super) fn reciprocal_square_root(z: Wide, integer_bits: u32, fraction_bits: u32) -> Wide {
    round_reciprocal_root(z.max(Wide::ONE >> (2 * integer_bits)), fraction_bits)
}

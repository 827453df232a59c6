//! `reciprocal_square_root` of docs/arithmetic.md.
use specula_scene::Format;

use super::number::{Wide, round_reciprocal_root};

/// 1/√max(z, 4^-m) rounded to nearest with ties up, m the format's integer bits; z has 24 fraction bits at most.
pub(super) fn reciprocal_square_root(z: Wide, format: Format) -> Wide {
    round_reciprocal_root(z.max(Wide::ONE >> (2 * format.integer_bits)), format.fraction_bits)
}

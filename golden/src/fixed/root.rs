//! `reciprocal_square_root` of docs/arithmetic/units.md.
use specula_scene::Format;

use super::number::Wide;

/// 1/√max(z, 4^-m) rounded to nearest with ties up, m the format's integer bits.
///
/// With z = Z 2^-64, R = ⌊2^(f+1)/√z⌋ is the largest whole number with R² Z ≤ 2^(2f + 2 + 64), so R = ⌊√⌊2^(2f + 66)/Z⌋⌋; f ≤ 24.
pub(super) fn reciprocal_square_root(z: Wide, format: Format) -> Wide {
    let z = z.max(Wide::ONE >> (2 * format.integer_bits));
    let f = format.fraction_bits;
    let twice = ((1i128 << (2 * f + 2 + Wide::FRAC_NBITS)) / z.to_bits()).isqrt();
    Wide::from_bits(((twice + 1) >> 1) << (Wide::FRAC_NBITS - f))
}

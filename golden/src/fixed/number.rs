//! Numbers that are exact between narrowing points, and the narrowing itself.
use ::fixed::types::I64F64;
use specula_spec::Format;

/// Holds every value between narrowing points exactly: 64 bits left of the binary point, sign
/// included, and 64 right of it.
///
/// `CoreSpec::check` allows 24 fraction bits at narrowing points (20 in D), 56 in accumulators, 6
/// in coefficients. So fraction bits are
///
/// - i · step, i(i - 1)/2 · difference: 56 (i(i - 1)/2 is whole);
/// - c cos δ - s sin δ: 28 + 30 = 58;
/// - products of two narrowed values, z·s, f²: 48;
/// - (y + y²)/2, g·h/2: 49;
/// - n·D·D/2^(k+1), with k ≤ 3: 40 + 4 = 44;
/// - m·|D_c|/2^h: 24 + 20 + 2 = 46, and u_c² 48;
/// - colours: 6 + 24 = 30.
///
/// Left of the point, i < 2^13 gives i(i - 1)/2 · difference < 2^25 · 2^2 and a sum of three such
/// terms < 2^28; |n| < 2, |D_c| < 2^3 and n < 2^13 give n·D·D < 2^13 · 3 · 2^6 < 2^21; a
/// coefficient of at most 63 bits is less than 2^57, and nine of them times at most 2 less than
/// 2^62. That |n| < 2 rests on the normals and the weight that `Lyon::check` asks for.
pub type Wide = I64F64;

const HALF: Wide = Wide::lit("0.5");

/// The value of an input: raw · 2^-fraction bits.
pub fn from_raw(raw: i64, format: Format) -> Wide {
    Wide::from_bits(i128::from(raw) << (Wide::FRAC_NBITS - format.fraction_bits))
}

/// The raw value of a number that has no more than `fraction_bits`; of one that needs more than 64
/// bits, the low 64.
pub fn to_raw(value: Wide, fraction_bits: u32) -> i64 {
    (value.to_bits() >> (Wide::FRAC_NBITS - fraction_bits)) as i64
}

/// Rounds to nearest, ties up: floor(x · 2^f + 1/2) / 2^f.
///
/// |x| · 2^f < 2^63. At narrowing points f ≤ 24 and |x| < 2^28 (see [`Wide`]).
pub fn round_to(value: Wide, fraction_bits: u32) -> Wide {
    ((value << fraction_bits) + HALF).floor() >> fraction_bits
}

/// The largest number not above it with so many fraction bits: floor(x · 2^f) / 2^f.
///
/// |x| · 2^f < 2^63, as for a product of less than 2^4 with 56 fraction bits.
pub fn truncate_to(value: Wide, fraction_bits: u32) -> Wide {
    (value << fraction_bits).floor() >> fraction_bits
}

/// p / q rounded to nearest, ties up, for p ≥ 0 and q > 0.
///
/// floor(p/q · 2^f + 1/2) = floor((p · 2^(f+1) + q) / 2q), on raw values, whose common factor 2^-64
/// cancels. With p < q < 2^28 and f ≤ 24 the numerator stays below 2^(28 + 64 + 25 + 1) = 2^118,
/// and with p < q ≤ 2 and f ≤ 48 below 2^(1 + 64 + 49 + 1) = 2^115.
pub fn round_quotient(p: Wide, q: Wide, fraction_bits: u32) -> Wide {
    let (p, q) = (p.to_bits(), q.to_bits());
    let quotient = ((p << (fraction_bits + 1)) + q) / (2 * q);
    Wide::from_num(quotient) >> fraction_bits
}

/// p / q rounded to nearest, ties up, for any p and q > 0, kept within -`limit` to `limit`.
///
/// floor((p · 2^(f+1) + q) / 2q), where |p| < 2^28 and f ≤ 24 keep the numerator below 2^118.
pub fn round_signed_quotient(p: Wide, q: Wide, fraction_bits: u32, limit: i64) -> Wide {
    let (p, q) = (p.to_bits(), q.to_bits());
    let quotient = ((p << (fraction_bits + 1)) + q).div_euclid(2 * q);
    let limit = i128::from(limit) << fraction_bits;
    Wide::from_num(quotient.clamp(-limit, limit)) >> fraction_bits
}

/// 1/√q rounded to nearest, ties up, for q > 0 of at most 24 fraction bits and below 2^28.
///
/// With q = Q · 2^-24, floor(2^(f+1)/√q) = floor(√(2^(2f+26)/Q)), and the root of the quotient's
/// floor has the same floor; f ≤ 24 keeps it below 2^74.
pub fn round_reciprocal_root(q: Wide, fraction_bits: u32) -> Wide {
    let q = (q.to_bits() >> (Wide::FRAC_NBITS - 24)).unsigned_abs();
    let doubled = ((1_u128 << (2 * fraction_bits + 26)) / q).isqrt();
    Wide::from_num(doubled.div_ceil(2)) >> fraction_bits
}

/// The largest multiple of 2^-`fraction_bits` that is no more than `value`.
pub fn round_down(value: Wide, fraction_bits: u32) -> Wide {
    (value << fraction_bits).floor() >> fraction_bits
}

/// The smallest multiple of 2^-`fraction_bits` that is no less than `value`.
pub fn round_up(value: Wide, fraction_bits: u32) -> Wide {
    -round_down(-value, fraction_bits)
}

/// √x rounded to nearest, ties up, for 0 ≤ x ≤ 1 and f ≤ 24.
///
/// With R = ⌊√(2^(2f+2) x)⌋ it is ⌊(R + 1)/2⌋; the radicand without its fraction has the same R.
pub fn round_root(x: Wide, fraction_bits: u32) -> Wide {
    let radicand: u64 = (x << (2 * fraction_bits + 2)).floor().to_num();
    Wide::from_num(radicand.isqrt().div_ceil(2)) >> fraction_bits
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every q of 8 bits: s is the only multiple of the last place with (s - 1/2)² q ≤ 1 < (s +
    /// 1/2)² q.
    #[test]
    fn reciprocal_roots_are_the_nearest() {
        for raw in 1..256_i64 {
            for fraction_bits in [0, 3, 8] {
                let s = to_raw(
                    round_reciprocal_root(Wide::from_num(raw) >> 6, fraction_bits),
                    fraction_bits,
                );
                let one = 64 << (2 * fraction_bits + 2);
                assert!(
                    (2 * s - 1).pow(2) * raw <= one && one < (2 * s + 1).pow(2) * raw,
                    "1/sqrt({raw}/64) to {fraction_bits}: {s}"
                );
            }
        }
    }

    #[test]
    fn signed_quotients_are_the_nearest_and_limited() {
        for q in 1..32_i64 {
            for p in -40..=40_i64 {
                let wide = |raw| Wide::from_num(raw) >> 5;
                for fraction_bits in [0, 3] {
                    let b = to_raw(
                        round_signed_quotient(wide(p), wide(q), fraction_bits, 4),
                        fraction_bits,
                    );
                    let limit = 4 << fraction_bits;
                    let twice = 2 * (p << fraction_bits);
                    let nearest = (2 * b - 1) * q <= twice && twice < (2 * b + 1) * q;
                    let limited = (b == limit && twice >= (2 * b + 1) * q)
                        || (b == -limit && twice < (2 * b - 1) * q);
                    assert!(nearest || limited, "{p}/{q} to {fraction_bits}: {b}");
                }
            }
        }
    }

    /// Every multiple of 1/16 from -8 to 8, rounded to 0 to 4 fraction bits; against integers
    /// alone.
    #[test]
    fn rounding_is_to_nearest_with_ties_up() {
        for sixteenths in -128..=128_i32 {
            let value = Wide::from_num(sixteenths) >> 4;
            for fraction_bits in 0..=4 {
                let step = 16 >> fraction_bits;
                let below = sixteenths.div_euclid(step) * step;
                let nearest = if 2 * (sixteenths - below) >= step { below + step } else { below };
                assert_eq!(
                    round_to(value, fraction_bits),
                    Wide::from_num(nearest) >> 4,
                    "{sixteenths}/16 to {fraction_bits}"
                );
            }
        }
    }

    /// Every quotient of 5-bit operands: the result is the only multiple b of the last place with
    /// b - 1/2 ≤ p/q < b + 1/2.
    #[test]
    fn quotients_are_the_nearest() {
        for q in 1..32_i64 {
            for p in 0..=q {
                let wide = |raw| Wide::from_num(raw) >> 5;
                for fraction_bits in [0, 3, 4, 7] {
                    let b = to_raw(round_quotient(wide(p), wide(q), fraction_bits), fraction_bits);
                    let twice = 2 * (p << fraction_bits);
                    assert!(
                        (2 * b - 1) * q <= twice && twice < (2 * b + 1) * q,
                        "{p}/{q} to {fraction_bits}: {b}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_smallest_difference_decides_a_tie() {
        let half = Wide::lit("0.5");
        assert_eq!(round_to(half, 0), Wide::ONE);
        assert_eq!(round_to(half - Wide::DELTA, 0), Wide::ZERO);
        assert_eq!(round_to(-half, 0), Wide::ZERO);
        assert_eq!(round_to(-half - Wide::DELTA, 0), -Wide::ONE);
    }

    #[test]
    fn raw_values_go_in_and_come_out() {
        for format in [Format::signed(1, 14), Format::unsigned(13, 0), Format::signed(3, 56)] {
            for raw in [format.min_raw(), -1, 0, 1, format.max_raw()] {
                assert_eq!(to_raw(from_raw(raw, format), format.fraction_bits), raw);
            }
        }
    }
}

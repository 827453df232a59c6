//! Fixed-point formats, written as Lyon writes them: `S1.10`, `U0.12`.
use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

/// The widest signal anywhere in a design, in bits.
pub const WIDEST_SIGNAL: u32 = 63;

/// A fixed-point format: value = raw · 2^-`fraction_bits`.
///
/// A signed format has one sign bit beside its integer bits, so `S1.10` is 12 bits wide and holds
/// [-2, 2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Format {
    /// Whether there is a sign bit (two's complement).
    pub signed: bool,
    /// Bits left of the binary point, without the sign bit.
    pub integer_bits: u32,
    /// Bits right of the binary point.
    pub fraction_bits: u32,
}

impl Format {
    /// A signed format, `S<integer_bits>.<fraction_bits>`.
    pub const fn signed(integer_bits: u32, fraction_bits: u32) -> Format {
        Format { signed: true, integer_bits, fraction_bits }
    }

    /// An unsigned format, `U<integer_bits>.<fraction_bits>`.
    pub const fn unsigned(integer_bits: u32, fraction_bits: u32) -> Format {
        Format { signed: false, integer_bits, fraction_bits }
    }

    /// Width in bits, sign included.
    pub const fn width(self) -> u32 {
        self.signed as u32 + self.integer_bits + self.fraction_bits
    }

    /// Weight of the last bit, 2^-`fraction_bits`.
    pub fn ulp(self) -> f64 {
        power_of_two(-(self.fraction_bits as i64))
    }

    /// Smallest raw value.
    pub const fn min_raw(self) -> i64 {
        if self.signed { -(1 << (self.integer_bits + self.fraction_bits)) } else { 0 }
    }

    /// Largest raw value.
    pub const fn max_raw(self) -> i64 {
        (1 << (self.integer_bits + self.fraction_bits)) - 1
    }

    /// The value that a raw number stands for.
    pub fn value(self, raw: i64) -> f64 {
        raw as f64 * self.ulp()
    }

    /// The value that a raw number stands for, every digit of it, which may be more than an f64
    /// has.
    pub fn in_digits(self, raw: i64) -> String {
        let sign = if raw < 0 { "-" } else { "" };
        let magnitude = u128::from(raw.unsigned_abs());
        let ones = 1u128 << self.fraction_bits;
        let (whole, mut rest) = (magnitude / ones, magnitude % ones);
        let mut digits = format!("{sign}{whole}");
        if rest > 0 {
            digits.push('.');
        }
        // Ten times what is left ends after as many digits as there are fraction bits, which are
        // fewer than 64.
        while rest > 0 {
            rest *= 10;
            digits.push(char::from(b'0' + (rest / ones) as u8));
            rest %= ones;
        }
        digits
    }

    /// Nearest raw value, ties up, saturated to the format's range; the host's way into the core.
    /// NaN becomes 0, so that no set-up can put a NaN into a core.
    pub fn quantise(self, value: f64) -> i64 {
        let scaled = value * power_of_two(self.fraction_bits.into());
        // Adding 1/2 first would round once more in f64: up from just below 1/2, and from odd
        // numbers beyond 2^52.
        let whole = scaled.floor();
        let nearest = if scaled - whole >= 0.5 { whole + 1.0 } else { whole };
        // `as` saturates at i64's ends and maps NaN to 0.
        (nearest as i64).clamp(self.min_raw(), self.max_raw())
    }

    /// [`Format::quantise`] for each component.
    pub fn quantise_vector(self, vector: impl Into<[f64; 3]>) -> [i64; 3] {
        vector.into().map(|component| self.quantise(component))
    }
}

/// 2^`exponent`, exactly and on every machine, for exponents from -1022 to 1023: the exponent field
/// biased by 1023.
pub const fn power_of_two(exponent: i64) -> f64 {
    f64::from_bits(((1023 + exponent) as u64) << 52)
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.signed { 'S' } else { 'U' };
        write!(f, "{sign}{}.{}", self.integer_bits, self.fraction_bits)
    }
}

/// Why a text is not a format.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is not a fixed-point format: {reason}")]
pub struct FormatError {
    text: String,
    reason: &'static str,
}

impl FromStr for Format {
    type Err = FormatError;

    fn from_str(text: &str) -> Result<Format, FormatError> {
        let fail = |reason| FormatError { text: text.to_owned(), reason };
        let shape = "write S or U, integer bits, a point and fraction bits, as in `S1.14`";
        let signed = match text.as_bytes().first() {
            Some(b'S') => true,
            Some(b'U') => false,
            _ => return Err(fail(shape)),
        };
        let (integer, fraction) = text[1..].split_once('.').ok_or_else(|| fail(shape))?;
        let bits = |digits: &str| digits.parse::<u32>().map_err(|_| fail(shape));
        let (integer_bits, fraction_bits) = (bits(integer)?, bits(fraction)?);
        let width = u64::from(integer_bits) + u64::from(fraction_bits) + u64::from(signed);
        match width {
            0 => Err(fail("it has no bits")),
            1 if signed => Err(fail("a signed format needs a bit beside its sign")),
            w if w > u64::from(WIDEST_SIGNAL) => Err(fail("it is wider than 63 bits")),
            _ => Ok(Format { signed, integer_bits, fraction_bits }),
        }
    }
}

impl TryFrom<String> for Format {
    type Error = FormatError;

    fn try_from(text: String) -> Result<Format, FormatError> {
        text.parse()
    }
}

impl From<Format> for String {
    fn from(format: Format) -> String {
        format.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_print_as_they_are_written() {
        for text in ["S1.10", "U0.12", "U13.0", "S3.59"] {
            assert_eq!(text.parse::<Format>().map(|f| f.to_string()), Ok(text.to_owned()));
        }
    }

    #[test]
    fn nonsense_is_refused() {
        for text in [
            "",
            "S",
            "S0.0",
            "U0.0",
            "X1.2",
            "S1",
            "S1.2.3",
            "U-1.2",
            "U40.40",
            "S\u{301}1.2",
            "U1.4294967295",
        ] {
            assert!(text.parse::<Format>().is_err(), "{text}");
        }
    }

    #[test]
    fn ranges_match_the_width() {
        let s = Format::signed(1, 10);
        assert_eq!((s.width(), s.min_raw(), s.max_raw()), (12, -2048, 2047));
        let u = Format::unsigned(0, 12);
        assert_eq!((u.width(), u.min_raw(), u.max_raw()), (12, 0, 4095));
    }

    #[test]
    fn powers_of_two_are_exact() {
        for exponent in -63..=63 {
            assert_eq!(power_of_two(exponent), 2f64.powi(exponent as i32));
        }
    }

    #[test]
    fn digits_are_those_of_the_number_also_where_an_f64_has_fewer() {
        let in_digits = |fraction_bits, raw| Format::signed(1, fraction_bits).in_digits(raw);
        assert_eq!(in_digits(4, 0), "0");
        assert_eq!(in_digits(4, -24), "-1.5");
        assert_eq!(in_digits(0, 17), "17");
        assert_eq!(in_digits(4, 1), "0.0625");
        assert_eq!(
            in_digits(56, (1 << 56) + 7),
            "1.00000000000000009714451465470119728706777095794677734375"
        );
        assert_eq!(in_digits(63, i64::MIN), "-1");
        for raw in -300..300 {
            assert_eq!(in_digits(6, raw).parse(), Ok(raw as f64 / 64.0));
        }
    }

    #[test]
    fn quantising_rounds_to_nearest_and_saturates() {
        let s = Format::signed(0, 2);
        assert_eq!([0.124, 0.125, -0.125, 0.9, -7.0].map(|x| s.quantise(x)), [0, 1, 0, 3, -4]);
        assert_eq!(s.quantise(f64::NAN), 0);
        assert_eq!([f64::INFINITY, f64::NEG_INFINITY].map(|x| s.quantise(x)), [3, -4]);
        // Neither is changed by an addition of 1/2 in f64.
        assert_eq!(Format::unsigned(1, 0).quantise(0.5_f64.next_down()), 0);
        let odd = (1i64 << 52) + 1;
        assert_eq!(Format::unsigned(0, 56).quantise(odd as f64 * power_of_two(-56)), odd);
    }
}

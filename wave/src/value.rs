//! Values of signals and their notations.

/// A value in a dump.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// Bits from the highest to the lowest: `0`, `1`, `x`, `z` and VHDL's other states.
    Bits(String),
    /// A real number, in decimal.
    Real(String),
    /// Text as it stands in the file.
    Text(String),
}

impl Value {
    /// A real number with as few digits as distinguish it from all others.
    pub fn real(number: f64) -> Value {
        let usual = number == 0.0 || (1e-5..1e16).contains(&number.abs()) || !number.is_finite();
        Value::Real(if usual { number.to_string() } else { format!("{number:e}") })
    }

    /// Length in bytes.
    pub fn length(&self) -> usize {
        match self {
            Value::Bits(text) | Value::Real(text) | Value::Text(text) => text.len(),
        }
    }

    /// Whether it is a bit.
    pub fn is_bit(&self) -> bool {
        matches!(self, Value::Bits(bits) if bits.len() == 1)
    }
}

/// The notation of a signal's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Notation {
    /// A hexadecimal number, for signals whose format is unknown.
    Hexadecimal,
    /// Bits.
    Binary,
    /// A fixed-point number.
    Decimal {
        /// Whether the highest bit counts negative.
        signed: bool,
        /// Bits right of the binary point.
        fraction_bits: u32,
    },
}

/// Largest width of a number that is written in decimal.
const WIDEST: usize = 64;

impl Notation {
    /// The format as it is written next to a signal's name.
    pub fn label(self, width: u32) -> String {
        match self {
            Notation::Hexadecimal => "hex".to_owned(),
            Notation::Binary => "bin".to_owned(),
            Notation::Decimal { signed, fraction_bits } => {
                let integer_bits =
                    (width - u32::from(signed).min(width)).saturating_sub(fraction_bits);
                let sign = if signed { 'S' } else { 'U' };
                format!("{sign}{integer_bits}.{fraction_bits}")
            }
        }
    }

    /// The number of characters that `value` should have: at most `most`, and at most `rounded` if
    /// it can be rounded. The beginning of a text is worth showing.
    pub fn preferred_width(self, value: &Value, rounded: usize, most: usize) -> usize {
        let most = if can_be_rounded(value, self) { rounded.min(most) } else { most };
        match value {
            Value::Text(text) => text.chars().count().min(most),
            _ => self.written(value, most).map_or(0, |text| text.chars().count()),
        }
    }

    /// `value` with as many of its decimals as `room` characters hold; `None` if it cannot be
    /// written in so few.
    pub fn written(self, value: &Value, room: usize) -> Option<String> {
        let text = match (value, self) {
            (Value::Text(text), _) => text.clone(),
            (Value::Real(digits), _) => return rounded(digits, room),
            (Value::Bits(bits), _) if !bits.bytes().all(|bit| matches!(bit, b'0' | b'1')) => {
                unknown(bits, self)
            }
            (Value::Bits(bits), Notation::Decimal { signed, fraction_bits })
                if bits.len() <= WIDEST =>
            {
                return fixed_point(raw(bits, signed), fraction_bits, room);
            }
            (Value::Bits(bits), Notation::Binary) => bits.clone(),
            (Value::Bits(bits), _) => hexadecimal(bits),
        };
        (text.chars().count() <= room).then_some(text)
    }
}

/// Whether a value needs less room if it is written with fewer digits.
fn can_be_rounded(value: &Value, notation: Notation) -> bool {
    match (value, notation) {
        (Value::Real(_), _) => true,
        (Value::Bits(bits), Notation::Decimal { fraction_bits, .. }) => {
            fraction_bits > 0 && bits.len() <= WIDEST
        }
        _ => false,
    }
}

/// A real number with as many of its digits as fit, at least two, so that it does not look like an
/// integer.
fn rounded(digits: &str, room: usize) -> Option<String> {
    if digits.len() <= room {
        return Some(digits.to_owned());
    }
    let number: f64 = digits.parse().ok().filter(|number: &f64| number.is_finite())?;
    let exponent = number.abs().log10().floor() as i32;
    (1..=16).rev().find_map(|digits: i32| {
        let plain = usize::try_from(digits - exponent).ok().filter(|&decimals| decimals > 0);
        let plain = plain.map(|decimals| format!("{number:.decimals$}"));
        let fits = |text: &String| text.len() <= room;
        plain.filter(fits).or_else(|| Some(format!("{number:.*e}", digits as usize)).filter(fits))
    })
}

/// The integer that the bits represent.
fn raw(bits: &str, signed: bool) -> i128 {
    let unsigned = bits.bytes().fold(0, |number, bit| number << 1 | i128::from(bit == b'1'));
    if signed && bits.starts_with('1') { unsigned - (1 << bits.len()) } else { unsigned }
}

/// The number raw · 2^−fraction_bits, rounded to what fits. At least one decimal stays, so that a
/// fraction does not look like an integer.
fn fixed_point(raw: i128, fraction_bits: u32, room: usize) -> Option<String> {
    if fraction_bits == 0 {
        return Some(raw.to_string()).filter(|text| text.len() <= room);
    }
    let number = raw as f64 * (-f64::from(fraction_bits)).exp2();
    // With this many decimals, neighbouring values differ.
    let most = (f64::from(fraction_bits) * 2f64.log10()).ceil() as usize;
    let fits = |decimals: &usize| format!("{number:.decimals$}").len() <= room;
    let decimals = (most.min(1)..=most).rev().find(fits)?;
    Some(without_idle_zeros(format!("{number:.decimals$}"), number))
}

/// Removes zeros from the end of a number that is exact without them; the zeros of a rounded number
/// show how far it is rounded.
fn without_idle_zeros(text: String, number: f64) -> String {
    if text.parse() != Ok(number) {
        return text;
    }
    let short = text.trim_end_matches('0');
    short.strip_suffix('.').unwrap_or(short).to_owned()
}

fn hexadecimal(bits: &str) -> String {
    nibbles(bits).iter().map(|nibble| digit(nibble)).collect()
}

/// Groups of four bits, counted from the right.
fn nibbles(bits: &str) -> Vec<&[u8]> {
    let bits = bits.as_bytes();
    let (first, others) = bits.split_at(bits.len() % 4);
    std::iter::once(first).filter(|first| !first.is_empty()).chain(others.chunks(4)).collect()
}

/// The hexadecimal digit of a group; `X` if only some of its bits are unknown.
fn digit(nibble: &[u8]) -> char {
    let known = nibble.iter().all(|bit| matches!(bit, b'0' | b'1'));
    let number = nibble.iter().fold(0, |number, &bit| number << 1 | u32::from(bit == b'1'));
    match nibble {
        _ if known => char::from_digit(number, 16).unwrap_or('?'),
        [first, others @ ..] if others.iter().all(|bit| bit == first) => char::from(*first),
        _ => 'X',
    }
}

/// A value with bits that are neither 0 nor 1: one letter where all bits are the same.
fn unknown(bits: &str, notation: Notation) -> String {
    let first = bits.chars().next().unwrap_or('x');
    match notation {
        _ if bits.chars().all(|bit| bit == first) => first.to_string(),
        Notation::Binary => bits.to_owned(),
        _ => hexadecimal(bits),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(notation: Notation, bits: &str, room: usize) -> Option<String> {
        notation.written(&Value::Bits(bits.to_owned()), room)
    }

    const S1_6: Notation = Notation::Decimal { signed: true, fraction_bits: 6 };
    const U8_0: Notation = Notation::Decimal { signed: false, fraction_bits: 0 };

    #[test]
    fn numbers_take_the_room_there_is() {
        let number = |room| written(S1_6, "11011001", room);
        // -39/64: two decimals distinguish it from its neighbours.
        assert_eq!(number(20).as_deref(), Some("-0.61"));
        assert_eq!(number(5).as_deref(), Some("-0.61"));
        assert_eq!(number(4).as_deref(), Some("-0.6"));
        assert_eq!(number(3), None);
    }

    #[test]
    fn exact_numbers_have_no_idle_zeros() {
        assert_eq!(written(S1_6, "00100000", 9).as_deref(), Some("0.5"));
        assert_eq!(written(S1_6, "01000000", 9).as_deref(), Some("1"));
        assert_eq!(written(S1_6, "10000000", 9).as_deref(), Some("-2"));
        assert_eq!(written(U8_0, "11001000", 9).as_deref(), Some("200"));
        assert_eq!(written(U8_0, "11001000", 2), None);
    }

    #[test]
    fn unknown_bits_are_letters() {
        assert_eq!(written(U8_0, "xxxxxxxx", 1).as_deref(), Some("x"));
        assert_eq!(written(Notation::Hexadecimal, "zzzz00xx1111", 9).as_deref(), Some("zXf"));
        assert_eq!(written(Notation::Binary, "1x", 2).as_deref(), Some("1x"));
    }

    #[test]
    fn hexadecimal_numbers_begin_at_the_right() {
        assert_eq!(written(Notation::Hexadecimal, "1011110", 9).as_deref(), Some("5e"));
        assert_eq!(written(Notation::Hexadecimal, "0", 9).as_deref(), Some("0"));
    }

    #[test]
    fn wide_numbers_are_hexadecimal() {
        let bits = "1".repeat(65);
        assert_eq!(written(U8_0, &bits, 99).as_deref(), Some("1ffffffffffffffff"));
        assert_eq!(written(U8_0, &"1".repeat(63), 99).as_deref(), Some("9223372036854775807"));
    }

    #[test]
    fn real_numbers_lose_digits_where_there_is_no_room() {
        let written = |number: f64, room| Notation::Hexadecimal.written(&Value::real(number), room);
        assert_eq!(written(-1.25, 9).as_deref(), Some("-1.25"));
        assert_eq!(written(1.0 / 3.0, 40).as_deref(), Some("0.3333333333333333"));
        assert_eq!(written(1.0 / 3.0, 9).as_deref(), Some("0.3333333"));
        assert_eq!(written(123_456.789, 8).as_deref(), Some("123456.8"));
        assert_eq!(written(1.0 / 3e30, 9).as_deref(), Some("3.333e-31"));
        assert_eq!(written(1.0 / 3.0, 2), None);
        assert_eq!(written(1e300, 9).as_deref(), Some("1e300"));
        assert_eq!(written(f64::NAN, 9).as_deref(), Some("NaN"));
        assert_eq!(written(f64::NEG_INFINITY, 9).as_deref(), Some("-inf"));
    }

    #[test]
    fn wide_values_wish_for_room_and_numbers_that_can_be_rounded_for_little() {
        let bits = Value::Bits("1".repeat(64));
        assert_eq!(Notation::Hexadecimal.preferred_width(&bits, 9, 40), 16);
        assert_eq!(Notation::Hexadecimal.preferred_width(&bits, 9, 15), 0);
        assert_eq!(Notation::Hexadecimal.preferred_width(&Value::real(1.0 / 3.0), 9, 40), 9);
    }

    #[test]
    fn labels_are_formats() {
        assert_eq!(S1_6.label(8), "S1.6");
        assert_eq!(Notation::Decimal { signed: true, fraction_bits: 17 }.label(1), "S0.17");
        assert_eq!(Notation::Hexadecimal.label(8), "hex");
    }
}

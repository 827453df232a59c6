//! Numbers in text, as C, C++ and numpy print them.

/// The value of a word, or `None` if it is not a number: the function accepts anything that
/// `printf` writes for a double, in any C library and locale.
pub fn number(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    text.parse().ok().or_else(|| unusual(text))
}

/// The value as [`number`] gives it, rounded once to single precision, as binary files have it.
pub fn single(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    let usual = text.parse::<f32>().ok().map(f64::from);
    usual.or_else(|| unusual(text).map(|value| f64::from(value as f32)))
}

/// The value of a word that is an integer, possibly written as a fraction (`3.0`).
pub fn whole(word: &[u8]) -> Option<i64> {
    let text = std::str::from_utf8(word).ok()?;
    let from_fraction = || {
        number(word)
            .filter(|value| value.fract() == 0.0 && value.abs() < 1e15)
            .map(|value| value as i64)
    };
    text.parse().ok().or_else(from_fraction)
}

/// Forms that Rust does not parse: `0x1.8p+1`, `nan(ind)` and `NaNQ`, `1.#QNAN` of Microsoft's
/// older library, the decimal comma of many locales, and Fortran's `1.5D+00`.
fn unusual(text: &str) -> Option<f64> {
    let lower = text.to_ascii_lowercase();
    let (sign, size) = match lower.strip_prefix(['+', '-']) {
        Some(size) => (if lower.starts_with('-') { -1.0 } else { 1.0 }, size),
        None => (1.0, lower.as_str()),
    };
    let value = if let Some(word) = size.strip_prefix("0x1.#").or(size.strip_prefix("1.#")) {
        microsoft(word)?
    } else if let Some(digits) = size.strip_prefix("0x") {
        hexadecimal(digits)?
    } else if ["nanq", "nans"].contains(&size) || (size.starts_with("nan(") && size.ends_with(')'))
    {
        f64::NAN
    } else {
        decimal_comma(size).or_else(|| fortran(size))?
    };
    Some(sign * value)
}

/// What Microsoft's library wrote after `1.#`: possibly cut off and rounded to the requested digits
/// (`1.#J`, `1.#R`), or padded with zeros, and with an exponent (`1.#INF00e+000`).
fn microsoft(word: &str) -> Option<f64> {
    let digits = word.split(['e', 'p']).next()?;
    match digits.trim_end_matches('0') {
        "inf" | "in" | "j" | "io" => Some(f64::INFINITY),
        "qnan" | "qna" | "qn" | "qo" | "r" | "snan" | "sna" | "sn" | "so" | "t" | "ind" | "nan" => {
            Some(f64::NAN)
        }
        _ => None,
    }
}

fn decimal_comma(size: &str) -> Option<f64> {
    let (whole, fraction) = size.split_once(',')?;
    let is_plain =
        whole.bytes().all(|byte| byte.is_ascii_digit()) && !fraction.contains(['.', ',']);
    is_plain.then(|| format!("{whole}.{fraction}").parse().ok()).flatten()
}

/// Double precision as Fortran prints it: `1.5D+00`.
fn fortran(size: &str) -> Option<f64> {
    let (digits, exponent) = size.split_once('d')?;
    let is_plain = digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    is_plain.then(|| format!("{digits}e{exponent}").parse().ok()).flatten()
}

/// Hexadecimal digits with a point and a power of two: `1.8p+1` is 3.
fn hexadecimal(text: &str) -> Option<f64> {
    let (digits, exponent) = match text.split_once('p') {
        Some((digits, exponent)) => (digits, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    if whole.is_empty() && fraction.is_empty() {
        return None;
    }
    let mut value = 0.0;
    for digit in whole.chars().chain(fraction.chars()) {
        // 16 digits are exact enough: f64 has 53 bits.
        value = value * 16.0 + f64::from(digit.to_digit(16)?);
    }
    let places = i32::try_from(fraction.len()).ok()?.checked_mul(4)?;
    Some(libm::ldexp(value, exponent.saturating_sub(places)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_c_prints_them() {
        for (word, value) in [
            ("1", 1.0),
            ("+1", 1.0),
            ("-0", 0.0),
            (".5", 0.5),
            ("5.", 5.0),
            ("1e+05", 1e5),
            ("-1E-003", -1e-3),
            ("0x1.8p+1", 3.0),
            ("-0X1P-1", -0.5),
            ("0x1p-1074", 5e-324),
            ("0xc.8p-3", 1.5625),
            ("0x1.921fb54442d18p+1", std::f64::consts::PI),
            ("0,5", 0.5),
            ("1.5D+01", 15.0),
            ("-.25d0", -0.25),
            ("-1,5e+01", -15.0),
            ("inf", f64::INFINITY),
            ("+Infinity", f64::INFINITY),
            ("1.#INF", f64::INFINITY),
            ("-1.#INF000", f64::NEG_INFINITY),
            ("1.#INF00e+000", f64::INFINITY),
            ("-0x1.#INFp+0", f64::NEG_INFINITY),
            ("1.#J", f64::INFINITY),
        ] {
            assert_eq!(number(word.as_bytes()), Some(value), "{word}");
        }
    }

    #[test]
    fn what_is_not_a_number_is_read_as_one_that_is_none() {
        for word in [
            "nan",
            "-nan",
            "+NaN",
            "-nan(ind)",
            "nan(0x8000000000000)",
            "NAN(SNAN)",
            "1.#QNAN",
            "-1.#IND00",
            "1.#R",
            "NaNQ",
            "-1.#IND00e+000",
        ] {
            assert!(number(word.as_bytes()).is_some_and(f64::is_nan), "{word}");
        }
    }

    #[test]
    fn words_are_no_numbers() {
        for word in [
            "", "-", ".", "up", "1,2,3", "1,2.3", ",", "0x", "0x.", "0xg", "0x1p", "1.#", "1.#up",
            "nan(", "1 2", "e5", "d5", "1d", "1e5d5", "1d2d3",
        ] {
            assert_eq!(number(word.as_bytes()), None, "{word}");
        }
        assert_eq!(number(b"1\xff"), None);
    }

    #[test]
    fn whole_numbers_may_be_written_as_fractions() {
        for (word, value) in [
            ("3", Some(3)),
            ("+3", Some(3)),
            ("-1", Some(-1)),
            ("3.0", Some(3)),
            ("3e0", Some(3)),
            ("0x3", Some(3)),
        ] {
            assert_eq!(whole(word.as_bytes()), value, "{word}");
        }
        for word in ["3.5", "nan", "inf", "1e300", "x", "9223372036854775808"] {
            assert_eq!(whole(word.as_bytes()), None, "{word}");
        }
    }

    #[test]
    fn singles_are_rounded_once() {
        assert_eq!(single(b"0.1"), Some(f64::from(0.1_f32)));
        assert_eq!(single(b"0x1.99999ap-4"), Some(f64::from(0.1_f32)));
        assert_eq!(single(b"1e39"), Some(f64::INFINITY));
    }
}

//! Times and real numbers as VCD files state them.
use super::super::survey::LATEST;

/// A time, and its oddity if it has one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Time {
    /// A whole number, as IEEE 1364 has it.
    Whole(u64),
    /// A number with a fraction, which is cut off.
    Fraction(u64),
    /// A number below 0.
    Negative,
    /// A number larger than [`LATEST`].
    TooLarge,
}

impl Time {
    /// Reads the time behind `#`; `None` if it is not a number.
    pub fn parse(word: &[u8]) -> Option<Time> {
        let text = std::str::from_utf8(word).ok()?;
        if !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit()) {
            let time = text.parse().ok().filter(|&time| time <= LATEST);
            return Some(time.map_or(Time::TooLarge, Time::Whole));
        }
        // The whole part is read as an integer, since a floating-point number would lose digits of
        // it.
        let fraction = text.split_once('.').filter(|(whole, rest)| {
            let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
            !whole.is_empty() && digits(whole) && digits(rest)
        });
        if let Some((whole, rest)) = fraction {
            return Some(match Time::parse(whole.as_bytes())? {
                Time::Whole(whole) if rest.bytes().any(|byte| byte != b'0') => {
                    Time::Fraction(whole)
                }
                other => other,
            });
        }
        let number: f64 = text.parse().ok().filter(|number: &f64| number.is_finite())?;
        Some(match number {
            number if number < 0.0 => Time::Negative,
            number if number >= LATEST as f64 => Time::TooLarge,
            number if number.fract() != 0.0 => Time::Fraction(number as u64),
            number => Time::Whole(number as u64),
        })
    }
}

/// Reads a real number as any programming language prints it.
pub fn real(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    let lower = text.to_ascii_lowercase();
    // C prints a NaN with a sign, or with its bits in parentheses.
    let bare = lower.trim_start_matches(['+', '-']);
    if bare.starts_with("1.#inf") {
        return Some(if lower.starts_with('-') { f64::NEG_INFINITY } else { f64::INFINITY });
    }
    if bare == "nan" || bare.starts_with("nan(") || bare.starts_with("1.#") {
        return Some(f64::NAN);
    }
    // Some programs print the decimal separator of their user's country.
    text.parse().ok().or_else(|| text.replace(',', ".").parse().ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_read_as_far_as_they_can_be_counted() {
        let cases = [
            ("0", Some(Time::Whole(0))),
            ("007", Some(Time::Whole(7))),
            ("18446744073709551614", Some(Time::Whole(LATEST))),
            ("18446744073709551615", Some(Time::TooLarge)),
            ("99999999999999999999999", Some(Time::TooLarge)),
            ("10.5", Some(Time::Fraction(10))),
            ("10.0", Some(Time::Whole(10))),
            ("9007199254740993.5", Some(Time::Fraction(9_007_199_254_740_993))),
            ("1e3", Some(Time::Whole(1000))),
            ("1e+16", Some(Time::Whole(10_000_000_000_000_000))),
            ("-5", Some(Time::Negative)),
            ("", None),
            ("ten", None),
            ("inf", None),
            ("0x10", None),
        ];
        for (text, time) in cases {
            assert_eq!(Time::parse(text.as_bytes()), time, "{text}");
        }
    }

    #[test]
    fn real_numbers_may_be_none() {
        assert_eq!(real(b"1.5"), Some(1.5));
        assert_eq!(real(b"-1.5e-3"), Some(-0.0015));
        assert_eq!(real(b"1,5"), Some(1.5));
        assert_eq!(real(b"inf"), Some(f64::INFINITY));
        assert!(
            ["nan", "-nan", "NaN", "nan(0x8)", "-1.#IND"]
                .iter()
                .all(|text| real(text.as_bytes()).is_some_and(f64::is_nan))
        );
        assert_eq!(real(b"x"), None);
    }
}

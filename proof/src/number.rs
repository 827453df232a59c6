//! Numbers as Gappa reads them: `MbE` is M · 2^E, so that every f64 and every raw value is exact.

/// An f64, every digit of it.
pub fn of(value: f64) -> String {
    let bits = value.abs().to_bits();
    let (biased, fraction) = ((bits >> 52) as i64, bits & ((1 << 52) - 1));
    let (mantissa, exponent) = match biased {
        0 => (fraction, -1074),
        _ => (fraction | (1 << 52), biased - 1075),
    };
    signed(value < 0.0, mantissa, exponent)
}

/// `raw` · 2^`exponent`.
pub fn scaled(raw: i64, exponent: i64) -> String {
    signed(raw < 0, raw.unsigned_abs(), exponent)
}

fn signed(negative: bool, mantissa: u64, exponent: i64) -> String {
    let sign = if negative { "-" } else { "" };
    match mantissa.trailing_zeros() {
        64 => "0".to_owned(),
        zeros => format!("{sign}{}b{}", mantissa >> zeros, exponent + i64::from(zeros)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_every_digit() {
        assert_eq!(of(0.0), "0");
        assert_eq!(of(1.0), "1b0");
        assert_eq!(of(-0.375), "-3b-3");
        assert_eq!(of(0.1), "3602879701896397b-55");
        assert_eq!(of(f64::from_bits(1)), "1b-1074");
        assert_eq!(scaled(-40, -4), "-5b-1");
        assert_eq!(scaled(i64::MIN, -63), "-1b0");
    }
}

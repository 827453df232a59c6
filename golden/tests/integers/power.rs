//! b^n on raw values, with tables from f64.
use crate::raw::{Raw, round};

/// The power of a highlight's base with `from` fraction bits, by squaring or by tables, whichever
/// port there is, with `shape` fraction bits then; and its fraction bits.
pub fn raised(raw: &Raw, base: i128, from: u32, shape: u32) -> (i128, u32) {
    if raw.has("log2_exponent") {
        ((0..raw.get("log2_exponent")).fold(base, |b, _| round(b * b, 2 * from, from)), from)
    } else {
        let exponent_bits = i128::BITS - raw.largest("exponent").leading_zeros();
        (of(base, from, raw.get("exponent"), exponent_bits, shape), shape)
    }
}

/// `base` has `from` fraction bits, exponents have up to `exponent_bits`, the power `to` fraction
/// bits.
pub fn of(base: i128, from: u32, n: i128, exponent_bits: u32, to: u32) -> i128 {
    if base == 0 {
        return 0;
    }
    two_to_minus(n * minus_log2(base, from, to + exponent_bits + 3), to + exponent_bits + 3, to)
}

/// `value` to `bits`.
pub fn raw(value: f64, bits: u32) -> i128 {
    (value * 2f64.powi(bits as i32) + 0.5).floor() as i128
}

fn minus_log2(base: i128, from: u32, w: u32) -> i128 {
    let index_bits = (w + 4) / 4;
    let (parts, c_bits) = (1i128 << index_bits, index_bits + 4);
    // 2^40 is beyond every base here, so that m has 40 fraction bits.
    let e = base.leading_zeros() - (1i128 << from).leading_zeros();
    let m = base << (40 - from + e);
    let i = (m - (1 << 40)) >> (40 - index_bits);
    let c = match i {
        0 => 1.0,
        i if i == parts - 1 => 0.5,
        i => 1.0 / (1.0 + (i as f64 + 0.5) / parts as f64),
    };
    let c = raw(c, c_bits);
    let r_bits = 40 + c_bits;
    let r = m * c - (1 << r_bits);
    let s = round(r * r, 2 * r_bits, w);
    let t = round(r * s, r_bits + w, w);
    let wide = r_bits.max(w + 14);
    let q = round(
        (r << (wide - r_bits)) - (s << (wide - w - 1)) + ((5461 * t) << (wide - w - 14)),
        wide,
        w,
    );
    let log2_e = raw(std::f64::consts::LOG2_E, w - index_bits + 2);
    let log_c = raw((c as f64).log2() - f64::from(c_bits), w);
    ((i128::from(e) << w) + log_c - round(q * log2_e, 2 * w - index_bits + 2, w)).max(0)
}

/// 2^-y; y has `from` fraction bits.
pub fn two_to_minus(y: i128, from: u32, to: u32) -> i128 {
    let bits = to + 6;
    let y = round(y, from, bits);
    if y >= i128::from(to + 2) << bits {
        return 0;
    }
    let (h, delta) = (y >> to & 63, y & ((1 << to) - 1));
    let d = round(delta * raw(std::f64::consts::LN_2, bits), 2 * bits, bits);
    let p = round((d << (bits + 1)) - d * d, 2 * bits + 1, bits);
    let u = round(raw((-(h as f64) / 64.0).exp2(), bits) * ((1 << bits) - p), 2 * bits, bits);
    round(u, bits + (y >> bits) as u32, to)
}

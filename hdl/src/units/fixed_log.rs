//! Logarithms and powers of two in whole numbers, for the entries of tables: the same on every machine.
//!
//! Numbers have 60 fraction bits. Each function is off by less than 2^-52, far below half a unit of any table's entries.

/// Fraction bits of the numbers here.
const BITS: u32 = 60;
const ONE: i128 = 1 << BITS;
/// ln 2.
const LN_2: i128 = 799_144_290_325_165_979;
/// log₂ e.
const LOG2_E: i128 = 1_663_314_137_230_540_311;

fn times(a: i128, b: i128) -> i128 {
    (a * b) >> BITS
}

/// Rounded to `fraction_bits`, fewer than 60.
fn rounded(value: i128, fraction_bits: u32) -> i64 {
    // Entries have 40 bits at most.
    ((value + (1 << (BITS - fraction_bits - 1))) >> (BITS - fraction_bits)) as i64
}

/// ln 2 to `fraction_bits`.
pub fn ln_2(fraction_bits: u32) -> i64 {
    rounded(LN_2, fraction_bits)
}

/// log₂ e to `fraction_bits`.
pub fn log2_e(fraction_bits: u32) -> i64 {
    rounded(LOG2_E, fraction_bits)
}

/// log₂ of raw · 2^-`bits`, which is from 1/2 to 1, to `fraction_bits`.
///
/// ln x = 2 artanh z = 2 (z + z³/3 + z⁵/5 + …) with z = (x - 1)/(x + 1), where |z| ≤ 1/3.
pub fn log2(raw: i64, bits: u32, fraction_bits: u32) -> i64 {
    let x = i128::from(raw) << (BITS - bits);
    let z = ((x - ONE) << BITS) / (x + ONE);
    let square = times(z, z);
    let mut power = z;
    let mut sum = 0;
    for odd in (1..64).step_by(2) {
        sum += power / odd;
        power = times(power, square);
    }
    rounded(times(2 * sum, LOG2_E), fraction_bits)
}

/// 2^(-h/64) to `fraction_bits`, for h from 0 to 63: products of the roots 2^(-1/2), 2^(-1/4) … 2^(-1/64).
pub fn two_to_minus(h: u32, fraction_bits: u32) -> i64 {
    let mut root = ONE / 2;
    let mut product = ONE;
    for bit in (0..6).rev() {
        root = (root << BITS).isqrt();
        if h >> bit & 1 == 1 {
            product = times(product, root);
        }
    }
    rounded(product, fraction_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn logarithms_are_those_of_f64() {
        for raw in 512..=1024_i64 {
            let wanted = (raw as f64 / 1024.0).log2() * (1u64 << 34) as f64;
            assert!((log2(raw, 10, 34) as f64 - wanted).abs() <= 0.5001, "log2 of {raw}/1024");
        }
        assert_eq!((log2(512, 10, 34), log2(1024, 10, 34)), (-(1 << 34), 0));
    }

    #[test]
    fn powers_are_those_of_f64() {
        for h in 0..64 {
            let wanted = (-f64::from(h) / 64.0).exp2() * (1u64 << 22) as f64;
            assert!((two_to_minus(h, 22) as f64 - wanted).abs() <= 0.5001, "2^-{h}/64");
        }
        assert!((ln_2(22) as f64 / 4_194_304.0 - std::f64::consts::LN_2).abs() < 2f64.powi(-23));
        assert!((log2_e(30) as f64 / 1_073_741_824.0 - std::f64::consts::LOG2_E).abs() < 2f64.powi(-31));
    }
}

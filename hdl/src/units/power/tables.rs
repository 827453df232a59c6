//! Logarithms, powers of two and squared angles in whole numbers, for the entries of tables: the
//! same on every machine.
//!
//! Numbers have 60 fraction bits. Each function is off by less than 2^-52, and a parabola's
//! coefficients by less than 2^-40, far below half a unit of any table's entries.

/// Fraction bits of the numbers here.
const BITS: u32 = 60;
const ONE: i128 = 1 << BITS;
/// ln 2.
const LN_2: i128 = 799_144_290_325_165_979;
/// log₂ e.
const LOG2_E: i128 = 1_663_314_137_230_540_311;
/// π.
const PI: i128 = 3_622_009_729_038_561_421;

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

/// 2^(-h/64) to `fraction_bits`, for h from 0 to 63: products of the roots 2^(-1/2), 2^(-1/4) …
/// 2^(-1/64).
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

/// A, B and C, to `fraction_bits`, of the parabola A + δ(B + δ C) that meets g(d) = α² log₂ e/d,
/// d = 1 - cos α, at both ends and in the middle of the `part`th of the parts of 2^-`index_bits`, δ
/// being counted from the middle; d < 2.
pub fn squared_angle_parabola(part: i64, index_bits: u32, fraction_bits: u32) -> [i64; 3] {
    let half_part = index_bits + 1;
    let at = |half_parts: i64| squared_angle(i128::from(half_parts) << (BITS - half_part));
    let [left, middle, right] = [2 * part, 2 * part + 1, 2 * part + 2].map(at);
    let slope = (right - left) << index_bits;
    let curvature = (left + right - 2 * middle) << (2 * half_part - 1);
    [middle, slope, curvature].map(|coefficient| rounded(coefficient, fraction_bits))
}

/// α² log₂ e/d with d = 1 - cos α, 0 ≤ d < 2.
fn squared_angle(d: i128) -> i128 {
    if d <= ONE {
        return times(squared_angle_of_small(d), LOG2_E);
    }
    // α = π - α', of 1 - cos α' = 2 - d.
    let rest = 2 * ONE - d;
    let supplement = (times(squared_angle_of_small(rest), rest) << BITS).isqrt();
    let angle = PI - supplement;
    times((times(angle, angle) << BITS) / d, LOG2_E)
}

/// α²/d for 0 ≤ d ≤ 1 by arccos²(1 - d) = Σ 2 (2d)^k/(k² C(2k, k)), each of whose terms is the one
/// before it times d k²/((2k + 1)(k + 1)).
fn squared_angle_of_small(d: i128) -> i128 {
    let (mut term, mut sum) = (2 * ONE, 0);
    for k in 1..64 {
        sum += term;
        term = times(term, d) * (k * k) / ((2 * k + 1) * (k + 1));
    }
    sum
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
        assert!(
            (log2_e(30) as f64 / 1_073_741_824.0 - std::f64::consts::LOG2_E).abs() < 2f64.powi(-31)
        );
    }

    #[test]
    fn parabolas_are_near_the_squared_angle() {
        for d in (1..1920).map(|i| f64::from(i) / 1024.0) {
            let part = (d * 16.0).floor();
            let delta = d - (part + 0.5) / 16.0;
            let [value, slope, curvature] =
                squared_angle_parabola(part as i64, 4, 40).map(|raw| raw as f64 / 2f64.powi(40));
            // Of the third derivative, which grows towards d = 2.
            let remainder = 1e-5 * (2.0 - d).powf(-2.5);
            let wanted = 4.0 * (d / 2.0).sqrt().asin().powi(2) / d * std::f64::consts::LOG2_E;
            let off = (value + delta * (slope + delta * curvature) - wanted).abs();
            assert!(off < remainder, "d = {d}: off by {off}, {remainder}");
        }
    }
}

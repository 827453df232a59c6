//! `power` of docs/arithmetic/units.md: b^n for any whole n.
use super::exp2::Exp2;
use super::number::{Wide, round_to};

/// The unit for one pair of formats, its tables filled.
pub(super) struct Power {
    /// W.
    working_bits: u32,
    /// I.
    index_bits: u32,
    /// c.
    reciprocals: Vec<Wide>,
    /// T.
    logarithms: Vec<Wide>,
    exp2: Exp2,
}

impl Power {
    /// For exponents of up to `exponent_bits` bits and results with `fraction_bits`.
    pub fn new(exponent_bits: u32, fraction_bits: u32) -> Power {
        let working_bits = fraction_bits + exponent_bits + 3;
        let index_bits = (working_bits + 1).div_ceil(4);
        let parts = 1u32 << index_bits;
        let reciprocals: Vec<Wide> =
            (0..parts).map(|i| reciprocal(i, parts, index_bits + 4)).collect();
        let logarithms = reciprocals.iter().map(|&c| round_to(log2(c), working_bits)).collect();
        Power { working_bits, index_bits, reciprocals, logarithms, exp2: Exp2::new(fraction_bits) }
    }

    /// b^n.
    pub fn raise(&self, base: Wide, n: u32) -> Wide {
        if base == Wide::ZERO {
            return Wide::ZERO;
        }
        self.exp2.value(Wide::from_num(n) * self.minus_log2(base))
    }

    /// λ.
    fn minus_log2(&self, base: Wide) -> Wide {
        let w = self.working_bits;
        // 1 is the highest bit of U1.f, so what stands before the first 1 tells how far below 1 the
        // base is.
        let e = base.leading_zeros() - Wide::ONE.leading_zeros();
        let m = base << e;
        let index = ((m - Wide::ONE) << self.index_bits).to_num::<usize>();
        let r = m * self.reciprocals[index] - Wide::ONE;
        let s = round_to(r * r, w);
        let t = round_to(r * s, w);
        let q = round_to(r - (s >> 1) + ((t * 5461) >> 14), w);
        let rest = round_to(q * round_to(Wide::LOG2_E, w - self.index_bits + 2), w);
        (Wide::from_num(e) + self.logarithms[index] - rest).max(Wide::ZERO)
    }
}

/// c.
fn reciprocal(i: u32, parts: u32, fraction_bits: u32) -> Wide {
    match i {
        0 => Wide::ONE,
        i if i + 1 == parts => Wide::ONE >> 1,
        i => round_to(
            Wide::from_num(2 * parts) / Wide::from_num(2 * parts + 2 * i + 1),
            fraction_bits,
        ),
    }
}

/// Bit by bit: squaring x doubles its logarithm, and what it then has beyond 2 is the next bit.
/// Truncation loses less than 2^-58.
fn log2(c: Wide) -> Wide {
    let two = Wide::from_num(2);
    // From 1/2 to 1 there are 1 and the logarithm of 2c.
    let mut x = c << 1;
    if x == two {
        return Wide::ZERO;
    }
    let mut log = -Wide::ONE;
    for bit in 1..=60 {
        x = x * x;
        if x >= two {
            x >>= 1;
            log += Wide::ONE >> bit;
        }
    }
    log
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every base of 10 bits and exponents near and far, against f64, whose own error is far
    /// smaller.
    #[test]
    fn powers_are_faithful() {
        for (exponent_bits, fraction_bits) in [(4, 4), (8, 12), (13, 12), (15, 16)] {
            let unit = Power::new(exponent_bits, fraction_bits);
            let largest = (1 << exponent_bits) - 1;
            for raw in 0..=1024 {
                for n in [1, 2, 3, 5, 11, largest / 3, largest - 1, largest] {
                    let base = Wide::from_num(raw) >> 10;
                    let wanted = (f64::from(raw) / 1024.0).powi(n as i32);
                    let off = (unit.raise(base, n).to_num::<f64>() - wanted).abs()
                        * f64::from(1 << fraction_bits);
                    assert!(
                        off < 1.0,
                        "({raw}/1024)^{n} is off by {off} of its last place, with {fraction_bits} bits"
                    );
                }
            }
            assert_eq!(unit.raise(Wide::ONE, largest), Wide::ONE);
        }
    }

    /// Bases near 1, which have powers between 0 and 1 with large exponents.
    #[test]
    fn powers_of_bases_near_1_are_faithful() {
        let unit = Power::new(15, 16);
        for below in 0..3000 {
            for n in [20_000, 32_767] {
                let base = Wide::ONE - (Wide::from_num(below) >> 22);
                let wanted = (1.0 - f64::from(below) / f64::from(1 << 22)).powi(n as i32);
                let off = (unit.raise(base, n).to_num::<f64>() - wanted).abs() * 65536.0;
                assert!(off < 1.0, "(1 - {below}/2^22)^{n} is off by {off}");
            }
        }
    }
}

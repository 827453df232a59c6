//! `two_to_minus` of docs/arithmetic/units.md: 2^-y.
use super::number::{Wide, round_to};

/// The unit for one format, its table filled.
pub(super) struct Exp2 {
    /// F.
    fraction_bits: u32,
    /// E.
    roots: Vec<Wide>,
}

impl Exp2 {
    /// For results with `fraction_bits`.
    pub fn new(fraction_bits: u32) -> Exp2 {
        let root =
            |h: u32| round_to(exp_minus(Wide::from_num(h) / 64 * Wide::LN_2), fraction_bits + 6);
        Exp2 { fraction_bits, roots: (0..64).map(root).collect() }
    }

    /// 2^-y of y as it comes, 0 or more.
    pub fn value(&self, y: Wide) -> Wide {
        let y = round_to(y, self.fraction_bits + 6);
        if y >= Wide::from_num(self.fraction_bits + 2) { Wide::ZERO } else { self.two_to_minus(y) }
    }

    fn two_to_minus(&self, y: Wide) -> Wide {
        let bits = self.fraction_bits + 6;
        let whole = y.to_num::<u32>();
        let h = (y.frac() << 6_u32).to_num::<usize>();
        let delta = y.frac() - (Wide::from_num(h) >> 6);
        let d = round_to(delta * round_to(Wide::LN_2, bits), bits);
        let p = round_to(d - ((d * d) >> 1), bits);
        let u = round_to(self.roots[h] * (Wide::ONE - p), bits);
        round_to(u >> whole, self.fraction_bits)
    }
}

/// e^-x for 0 ≤ x < 1 by its series; the 21st term is below 2^-64.
fn exp_minus(x: Wide) -> Wide {
    let mut term = Wide::ONE;
    let mut sum = Wide::ONE;
    for k in 1..=20 {
        term = -(term * x) / k;
        sum += term;
    }
    sum
}

//! `gaussian` of docs/arithmetic/units.md: exp(-2n α²) of d = 1 - cos α.
use super::exp2::Exp2;
use super::number::{Wide, round_to};

/// The largest d, in eighths.
const MOST_EIGHTHS: i32 = 15;
/// Parts of the table, to 31/16.
const PARTS: i32 = 31;
/// How often an angle is halved before its series.
const HALVINGS: u32 = 4;

/// The unit for one format, its tables filled.
pub(super) struct Gaussian {
    /// A, B and C.
    parabolas: Vec<[Wide; 3]>,
    /// F + 4.
    bits: u32,
    exp2: Exp2,
}

impl Gaussian {
    /// For results with `fraction_bits`.
    pub fn new(fraction_bits: u32) -> Gaussian {
        let bits = fraction_bits + 4;
        let rounded = |i| parabola(i).map(|coefficient| round_to(coefficient, bits));
        Gaussian {
            parabolas: (0..PARTS).map(rounded).collect(),
            bits,
            exp2: Exp2::new(fraction_bits),
        }
    }

    /// The largest d there is.
    pub fn largest_versine() -> Wide {
        Wide::from_num(MOST_EIGHTHS) >> 3
    }

    /// exp(-2n α²).
    pub fn value(&self, versine: Wide, n: u32) -> Wide {
        let t = (Wide::from_num(n) * versine).min(Wide::from_num(4));
        self.exp2.value(2 * t * self.squared_angle(versine))
    }

    /// g.
    fn squared_angle(&self, d: Wide) -> Wide {
        let i = (d << 4_u32).to_num::<usize>();
        let [a, b, c] = self.parabolas[i];
        let delta = d - (Wide::from_num(2 * i + 1) >> 5);
        a + round_to(delta * (b + round_to(delta * c, self.bits)), self.bits)
    }
}

/// Through g at both ends and in the middle of part `i`.
fn parabola(i: i32) -> [Wide; 3] {
    let at = |half_parts: i32| exact(Wide::from_num(half_parts) >> 5);
    let [left, middle, right] = [2 * i, 2 * i + 1, 2 * i + 2].map(at);
    // (right - left)/2h and (right + left - 2 middle)/2h², h = 1/32.
    [middle, (right - left) << 4_u32, (right + left - 2 * middle) << 9_u32]
}

/// α² log₂ e/d. The angle's half has 1 - cos(α/2) = (d/2)/(1 + √(1 - d/2)), and a small angle α² =
/// 2d (1 + d/6 (1 + 4d/15 (1 + …))).
fn exact(d: Wide) -> Wide {
    if d == Wide::ZERO {
        return 2 * Wide::LOG2_E;
    }
    let halved = |d: Wide| {
        let half: Wide = d >> 1;
        half / (Wide::ONE + Wide::sqrt(Wide::ONE - half))
    };
    let small = (0..HALVINGS).fold(d, |d, _| halved(d));
    let series = (1..=12).rev().fold(Wide::ONE, |rest: Wide, k: i128| {
        // Each term is the one before times d k²/((2k + 1)(k + 1)).
        Wide::ONE + rest * small * (k * k) / ((2 * k + 1) * (k + 1))
    });
    let squared_angle = (2 * small * series) << (2 * HALVINGS);
    squared_angle / d * Wide::LOG2_E
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every d of 8 bits and exponents near and far, against f64, whose own error is far smaller.
    #[test]
    fn gaussians_are_faithful() {
        for fraction_bits in [4, 8, 12, 16] {
            let unit = Gaussian::new(fraction_bits);
            for raw in 0..=480 {
                for n in [1, 2, 3, 5, 11, 50, 400, 8191] {
                    let versine = Wide::from_num(raw) >> 8;
                    let angle = 2.0 * (f64::from(raw) / 512.0).sqrt().asin();
                    let wanted = (-2.0 * f64::from(n) * angle * angle).exp();
                    let off = (unit.value(versine, n).to_num::<f64>() - wanted).abs()
                        * f64::from(1 << fraction_bits);
                    assert!(
                        off < 0.7,
                        "d = {raw}/256, n = {n}: off by {off} of the last place, with {fraction_bits} bits"
                    );
                }
            }
            assert_eq!(unit.value(Wide::ZERO, 8191), Wide::ONE);
        }
    }
}

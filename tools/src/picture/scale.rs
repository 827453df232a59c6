//! A colour scale for errors, which follows the square root, so that a small error is visible next
//! to a large one.

/// A scale from 0 to a round number.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourScale {
    /// Its upper end, at or above the largest number.
    top: f64,
}

/// Possible upper ends of a scale, up to a power of ten.
const ROUND: [f64; 11] = [1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
/// The smallest upper end. Below one LSB there is only the rounding to 8 bits.
const SMALLEST: f64 = 1.0;
/// Least distance of ticks on a scale of length 1.
const CLOSEST: f64 = 0.08;

impl ColourScale {
    /// The scale whose upper end is the next round number above `largest`.
    pub fn reaching(largest: f64) -> ColourScale {
        let largest = if largest.is_finite() { largest.max(SMALLEST) } else { SMALLEST };
        let power = 10f64.powf(largest.log10().floor());
        let round = ROUND.into_iter().find(|round| round * power >= largest).unwrap_or(10.0);
        ColourScale { top: round * power }
    }

    /// The place of a number on the scale, 0 to 1.
    pub fn place(&self, number: f64) -> f64 {
        (number / self.top).clamp(0.0, 1.0).sqrt()
    }

    /// The ticks from the top downwards: numbers and their labels.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        let powers = (-3..=3).rev().map(|power| 10f64.powi(power));
        let series = powers.flat_map(|power| [5.0, 2.0, 1.0].map(|digit| digit * power));
        let mut ticks = vec![self.top];
        for number in series.filter(|&number| number < self.top) {
            let last = ticks[ticks.len() - 1];
            if self.place(last) - self.place(number) >= CLOSEST && self.place(number) >= CLOSEST {
                ticks.push(number);
            }
        }
        ticks.push(0.0);
        ticks.into_iter().map(|number| (number, written(number))).collect()
    }
}

/// The number with as many decimals as it has, up to three.
fn written(number: f64) -> String {
    format!("{number:.3}").trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ticks(largest: f64) -> Vec<String> {
        ColourScale::reaching(largest).ticks().into_iter().map(|(_, text)| text).collect()
    }

    #[test]
    fn ticks_are_round_and_apart() {
        assert_eq!(ticks(0.93), ["1", "0.5", "0.2", "0.1", "0.05", "0.02", "0"]);
        assert_eq!(ticks(11.27), ["12", "10", "5", "2", "1", "0.5", "0.1", "0"]);
        assert_eq!(ticks(255.0), ["300", "200", "100", "50", "20", "5", "0"]);
        assert_eq!(ticks(0.0), ticks(1.0));
    }

    #[test]
    fn every_scale_reaches_its_number() {
        for k in 1..2000 {
            let largest = f64::from(k) * 0.13;
            let scale = ColourScale::reaching(largest);
            assert!(
                scale.top >= largest && scale.top <= 1.5 * largest.max(SMALLEST),
                "{largest}: {scale:?}"
            );
            assert!((0.0..1.01).contains(&scale.place(largest)));
        }
        assert_eq!(ColourScale::reaching(f64::NAN), ColourScale::reaching(0.0));
    }
}

//! From amounts of light to an 8-bit code.
use specula_spec::{CoreParameters, Format};

use super::method::Intensities;
use super::number::{Wide, round_to};
use super::observer::Observer;

const CHANNELS: [&str; 3] = ["r", "g", "b"];
const CODE: Format = Format::unsigned(8, 0);

/// The sum of ambient, diffuse and specular light in each channel, exact, in LSBs.
pub(super) struct Colour([Wide; 3]);

impl Colour {
    /// Ambient light alone.
    pub fn ambient(ambient: [Wide; 3]) -> Colour {
        Colour(ambient)
    }

    /// Adds `coefficient` · `amount` in each channel.
    pub fn add(&mut self, coefficient: &[Wide; 3], amount: Wide) {
        for (sum, coefficient) in self.0.iter_mut().zip(coefficient) {
            *sum += coefficient * amount;
        }
    }

    /// min(255, floor(c + 1/2)).
    pub fn code(self, format: Format, observer: &mut impl Observer) -> [u8; 3] {
        observer.see_sums(&self.0);
        std::array::from_fn(|c| {
            observer.see(format_args!("colour_{}", CHANNELS[c]), self.0[c], format);
            // Saturation works at the upper end alone: no coefficient and no amount is negative.
            let code: u8 = round_to(self.0[c], CODE.fraction_bits).saturating_to_num();
            observer.see(format_args!("code_{}", CHANNELS[c]), Wide::from_num(code), CODE);
            code
        })
    }
}

/// Format of the sum: 2·lights + 1 ≤ 9 terms, of coefficient times amount < 2, need 5 integer bits
/// above the coefficient's.
pub(super) fn sum_format(
    core: &CoreParameters,
    amounts: impl Iterator<Item = Intensities<Format>>,
) -> Format {
    let finest = |Intensities { diffuse, specular }: Intensities<Format>| {
        diffuse.fraction_bits.max(specular.fraction_bits)
    };
    let fraction_bits = core.coefficient.fraction_bits + amounts.map(finest).max().unwrap_or(0);
    Format::unsigned(core.coefficient.integer_bits + 5, fraction_bits)
}

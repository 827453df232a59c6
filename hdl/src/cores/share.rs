//! What arrives of the light of a pipeline, where lights that share it may lose some or none.
use super::common::Intensities;
use specula_datapath::builder::{Builder, Sig, TimeSlots};

/// The share of a pipeline's light.
pub(super) struct Share {
    /// Whether the light loses any.
    pub applies: Sig,
    /// The share of it, if it does.
    pub share: Sig,
}

impl Share {
    /// What arrives of an amount of light, rounded to `fraction_bits`.
    ///
    /// The amount itself may have fewer than its format, where what it is made of has.
    pub fn of(&self, amount: &Sig, fraction_bits: u32) -> Sig {
        self.applies.choose(&(amount * &self.share).rounded(fraction_bits), amount)
    }

    /// The same of diffuse and specular light, rounded to `fraction_bits`.
    pub fn of_both(
        &self,
        Intensities { diffuse, specular }: Intensities,
        fraction_bits: [u32; 2],
    ) -> Intensities {
        Intensities {
            diffuse: self.of(&diffuse, fraction_bits[0]),
            specular: self.of(&specular, fraction_bits[1]),
        }
    }
}

/// Whether the light of each pipeline loses any, where it is said of each light.
pub(super) fn applies(
    b: &Builder,
    slots: &TimeSlots,
    of_lights: impl Iterator<Item = bool>,
) -> Vec<Sig> {
    let applies: Vec<Sig> = of_lights.map(|applies| b.integer(applies.into())).collect();
    if slots.count() == 1 { applies } else { vec![slots.multiplexed(&applies)] }
}

//! Raw values and their rounding.
use std::collections::HashMap;

use specula_spec::attenuation::AttenuationFormats;
use specula_spec::{CoreSpec, SpanPacket};

use crate::hybrid::quadratic;

/// A packet's raw values, by the names of their ports.
pub struct Raw {
    values: HashMap<String, i128>,
    largest: HashMap<String, i128>,
    attenuation: Option<AttenuationFormats>,
    /// The pixel that is shaded.
    pixel: u32,
}

impl Raw {
    pub fn new(core: &CoreSpec, packet: &SpanPacket, pixel: u32) -> Raw {
        let ports = core.inputs();
        let names = || ports.iter().map(|port| port.name.clone());
        Raw {
            values: names().zip(packet.inputs.iter().map(|&raw| i128::from(raw))).collect(),
            largest: names().zip(ports.iter().map(|port| i128::from(port.range.1))).collect(),
            attenuation: core.parameters.attenuation.as_ref().map(|of| of.formats.clone()),
            pixel,
        }
    }

    pub fn get(&self, name: &str) -> i128 {
        self.values[name]
    }

    /// Whether there is a port of that name.
    pub fn has(&self, name: &str) -> bool {
        self.values.contains_key(name)
    }

    /// The largest raw value that the port takes.
    pub fn largest(&self, name: &str) -> i128 {
        self.largest[name]
    }

    pub fn vector(&self, name: &str) -> [i128; 3] {
        ["x", "y", "z"].map(|axis| self.get(&format!("{name}_{axis}")))
    }

    /// Code of one channel: `terms` are coefficients' names without the channel, and amounts of
    /// `bits` fraction bits.
    pub fn code(&self, channel: &str, terms: &[(String, i128)], bits: u32) -> u8 {
        let finest =
            self.attenuation.as_ref().map_or(bits, |f| bits.max(f.attenuated.fraction_bits));
        let sum: i128 = terms
            .iter()
            .map(|(name, amount)| {
                let coefficient = self.get(&format!("{name}_{channel}"));
                coefficient * self.arriving(name, *amount, [bits, finest])
            })
            .sum();
        let total = (self.get(&format!("ambient_{channel}")) << finest) + sum;
        round(total, finest + 6, 0).min(255) as u8
    }

    /// What distance leaves of an amount with the first number of fraction bits, with the second.
    fn arriving(&self, term: &str, amount: i128, [bits, finest]: [u32; 2]) -> i128 {
        let name = format!("{}_attenuation", term.split('_').next().unwrap());
        let Some(f) = self.attenuation.as_ref().filter(|_| self.has(&format!("{name}_start")))
        else {
            return amount << (finest - bits);
        };
        let [sum, share, attenuated] =
            [f.attenuation_accumulator, f.attenuation, f.attenuated].map(|f| f.fraction_bits);
        let left = quadratic(self, &name, self.pixel, sum, share).clamp(0, 1 << share);
        round(amount * left, bits + share, attenuated) << (finest - attenuated)
    }
}

/// Changes fraction bits, to nearest with ties up.
pub fn round(raw: i128, from: u32, to: u32) -> i128 {
    if to >= from { raw << (to - from) } else { (raw + (1 << (from - to - 1))) >> (from - to) }
}

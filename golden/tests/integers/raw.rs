//! Raw values and their rounding.
use std::collections::HashMap;

use specula_scene::spec::{CoreSpec, SpanPacket};

/// A packet's raw values, by the names of their ports.
pub struct Raw(HashMap<String, i128>);

impl Raw {
    pub fn new(core: &CoreSpec, packet: &SpanPacket) -> Raw {
        let names = core.inputs().into_iter().map(|port| port.name);
        Raw(names.zip(packet.inputs.iter().map(|&raw| i128::from(raw))).collect())
    }

    pub fn get(&self, name: &str) -> i128 {
        self.0[name]
    }

    pub fn vector(&self, name: &str) -> [i128; 3] {
        ["x", "y", "z"].map(|axis| self.get(&format!("{name}_{axis}")))
    }

    /// Code of one channel: `terms` are coefficients' names without the channel, and amounts of `bits` fraction bits.
    pub fn code(&self, channel: &str, terms: &[(String, i128)], bits: u32) -> u8 {
        let sum: i128 = terms.iter().map(|(name, amount)| self.get(&format!("{name}_{channel}")) * amount).sum();
        let total = (self.get(&format!("ambient_{channel}")) << bits) + sum;
        round(total, bits + 6, 0).min(255) as u8
    }
}

/// Changes fraction bits, to nearest with ties up.
pub fn round(raw: i128, from: u32, to: u32) -> i128 {
    if to >= from { raw << (to - from) } else { (raw + (1 << (from - to - 1))) >> (from - to) }
}

//! Raw values and their rounding.
use std::collections::HashMap;

use specula_spec::{CoreSpec, SpanPacket};

/// A packet's raw values, by the names of their ports.
pub struct Raw {
    values: HashMap<String, i128>,
    largest: HashMap<String, i128>,
}

impl Raw {
    pub fn new(core: &CoreSpec, packet: &SpanPacket) -> Raw {
        let ports = core.inputs();
        let names = || ports.iter().map(|port| port.name.clone());
        Raw {
            values: names().zip(packet.inputs.iter().map(|&raw| i128::from(raw))).collect(),
            largest: names().zip(ports.iter().map(|port| i128::from(port.range.1))).collect(),
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
        let sum: i128 = terms
            .iter()
            .map(|(name, amount)| self.get(&format!("{name}_{channel}")) * amount)
            .sum();
        let total = (self.get(&format!("ambient_{channel}")) << bits) + sum;
        round(total, bits + 6, 0).min(255) as u8
    }
}

/// Changes fraction bits, to nearest with ties up.
pub fn round(raw: i128, from: u32, to: u32) -> i128 {
    if to >= from { raw << (to - from) } else { (raw + (1 << (from - to - 1))) >> (from - to) }
}

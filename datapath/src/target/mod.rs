//! Targets: what a family of devices is made of and how long signals take through it, as tables.
//!
//! The tables stand in `datapath/targets`; `docs/targets.md` says how they are measured. All delays
//! are nanoseconds.
mod delay;

pub use delay::Shape;
use serde::Deserialize;

use crate::design::Primitives;

/// A family of devices.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Target {
    /// Its name on the command line.
    pub name: String,
    /// The device and speed grade whose delays these are.
    pub part: String,
    /// How they were measured.
    pub measured: String,
    /// Delays of the fabric; a target without them can be asked for no clock.
    pub fabric: Option<Fabric>,
    /// Its multiplier blocks, if it has any.
    pub multiplier: Option<Multiplier>,
    /// What delays of several clocks are made of.
    #[serde(default)]
    pub delay_line: DelayLines,
}

/// Delays of look-up tables, flip-flops, carry chains and nets.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fabric {
    /// From the clock to a flip-flop's output, with the set-up of another.
    pub register: f64,
    /// Through a look-up table.
    pub lut: f64,
    /// From a cell to the next one.
    pub net: f64,
    /// Through an adder of no bits, nets apart.
    pub carry: f64,
    /// For each bit that a carry passes.
    pub carry_bit: f64,
}

/// A multiplier block.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Multiplier {
    /// Widths of signed operands, in bits, the wider one first.
    pub widths: [u32; 2],
    /// Widths of operands without sign, in bits.
    pub unsigned: [u32; 2],
    /// The cells by which Verilog instantiates it; without, Verilog has `*` and the registers
    /// around it, which tools take into the block.
    pub cells: Option<Cells>,
    /// The look-up tables that are worth one block: how many the device has for each.
    pub worth: u32,
    /// The ways in which its own registers can be used, fewest first.
    #[serde(default)]
    pub pipeline: Vec<BlockPipeline>,
}

/// Cells that Verilog instantiates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Cells {
    /// `MULT18X18D`.
    Ecp5,
    /// `SB_MAC16`.
    Ice40up,
}

/// Registers of a block that are used.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BlockPipeline {
    /// Clocks from operands to product.
    pub clocks: u32,
    /// From an operand to the first register, the net there apart; through the block where it has
    /// no registers.
    pub into: f64,
    /// From the last register out of the block, the way to the fabric included.
    pub out: f64,
}

/// What delays of several clocks are made of.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DelayLines {
    /// Clocks of the shortest delay that is a memory in look-up tables; without, it is flip-flops.
    pub shortest: Option<u32>,
}

/// The tables, by the names of their targets.
const TABLES: [(&str, &str); 2] = [
    ("generic", include_str!("../../targets/generic.toml")),
    ("ecp5", include_str!("../../targets/ecp5.toml")),
];

impl Target {
    /// Names of all targets.
    pub fn names() -> impl Iterator<Item = &'static str> {
        TABLES.into_iter().map(|(name, _)| name)
    }

    /// Names of the targets that can be asked for a clock.
    pub fn clocked() -> impl Iterator<Item = &'static str> {
        let has_delays = |name: &&str| Target::named(name).is_some_and(|t| t.fabric.is_some());
        Target::names().filter(has_delays)
    }

    /// What Verilog has cells for.
    pub fn primitives(&self) -> Primitives {
        let none = Primitives::default();
        Primitives {
            multiplier: self.multiplier.as_ref().and_then(|multiplier| multiplier.cells),
            shortest_memory: self.delay_line.shortest.unwrap_or(none.shortest_memory),
        }
    }

    /// The target of this name, if there is one.
    pub fn named(name: &str) -> Option<Target> {
        let (_, table) = TABLES.into_iter().find(|(target, _)| *target == name)?;
        // The tables are part of the program, and a test reads each.
        Some(toml::from_str(table).expect("a table of the program's own"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_can_be_read_and_has_its_own_name() {
        for name in Target::names() {
            assert_eq!(Target::named(name).map(|target| target.name).as_deref(), Some(name));
        }
    }
}

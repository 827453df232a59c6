//! Targets: what a family of devices is made of and how long signals take through it, as tables.
//!
//! The tables stand in `datapath/targets`; `docs/targets.md` says how they are measured. All delays
//! are nanoseconds.
mod delay;
mod device;
mod logic;

pub use delay::Shape;
pub use device::Device;
pub use logic::{Carry, Logic, LogicCell};
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
    /// The cells with which a carry chain clears a summand without a look-up table before it, if
    /// there are any.
    pub gated_sum: Option<SumCells>,
    /// How its look-up tables are counted.
    #[serde(default)]
    pub logic: Logic,
    /// Its multiplier blocks, if it has any.
    pub multiplier: Option<Multiplier>,
    /// Its block RAM, if it has any.
    pub table: Option<BlockRam>,
    /// What delays of several clocks are made of.
    #[serde(default)]
    pub delay_line: DelayLines,
    /// Its devices, the smallest first.
    #[serde(default, rename = "device")]
    pub devices: Vec<Device>,
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
    /// Carries from a piece of a sum to the next one that placement keeps short in one core; all,
    /// if nothing is known.
    pub carries: Option<u32>,
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

/// Cells of sums of which one summand may be cleared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SumCells {
    /// `CCU2C`.
    Ecp5,
}

/// A block RAM.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BlockRam {
    /// Its bits.
    pub bits: u32,
    /// The longest word, in bits.
    pub widest: u32,
    /// The ways in which its own registers can be used, fewest first: 1 clock with that of the
    /// address alone, 2 with that of the word too.
    #[serde(default)]
    pub pipeline: Vec<BlockPipeline>,
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
    /// Clocks of the longest that is one such memory; a longer one is several in a row.
    pub longest: Option<u32>,
    /// From flip-flop to flip-flop through such a memory, nets included.
    pub read: Option<f64>,
    /// Whether such a memory has a flip-flop before it wherever logic gives what it delays, so that
    /// no path leads through a net more.
    #[serde(default)]
    pub registered: bool,
}

/// The tables, by the names of their targets.
const TABLES: [(&str, &str); 6] = [
    ("generic", include_str!("../../targets/generic.toml")),
    ("ecp5", include_str!("../../targets/ecp5.toml")),
    ("ice40hx", include_str!("../../targets/ice40hx.toml")),
    ("ice40up", include_str!("../../targets/ice40up.toml")),
    ("gowin", include_str!("../../targets/gowin.toml")),
    ("xilinx7", include_str!("../../targets/xilinx7.toml")),
];

impl Target {
    /// All families that have a table.
    pub fn families() -> impl Iterator<Item = Target> {
        TABLES.into_iter().map(|(_, table)| Target::read(table))
    }

    fn read(table: &str) -> Target {
        // The tables are part of the program, and a test reads each.
        toml::from_str(table).expect("a table of the program's own")
    }

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
            gated_sum: self.gated_sum,
            shortest_memory: self.delay_line.shortest.unwrap_or(none.shortest_memory),
            longest_memory: self.delay_line.longest.unwrap_or(none.longest_memory),
            registered_memories: self.delay_line.registered,
        }
    }

    /// The target of this name, if there is one.
    pub fn named(name: &str) -> Option<Target> {
        let (_, table) = TABLES.into_iter().find(|(target, _)| *target == name)?;
        Some(Target::read(table))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_table_can_be_read_and_has_its_own_name() {
        for name in Target::names() {
            assert_eq!(Target::named(name).map(|target| target.name).as_deref(), Some(name));
        }
        let names: BTreeSet<String> = Target::families().map(|target| target.name).collect();
        assert_eq!(names.len(), Target::families().count());
    }

    #[test]
    fn delays_are_not_negative_and_more_takes_longer() {
        for target in Target::families() {
            let name = &target.name;
            let Some(fabric) = &target.fabric else { continue };
            let Fabric { register, lut, net, carry, carry_bit, carries: _ } = *fabric;
            assert!([register, lut, net, carry_bit].into_iter().all(|ns| ns > 0.0), "{name}");
            assert!(carry >= 0.0, "{name}");
            assert!(target.delay_line.read.is_none_or(|ns| ns > register), "{name}");
            let (blocks, memories) = (&target.multiplier, &target.table);
            let blocks = blocks.iter().map(|block| &block.pipeline);
            for ways in blocks.chain(memories.iter().map(|memory| &memory.pipeline)) {
                let period = |way: &BlockPipeline| match way.clocks {
                    0 => register + net + way.into + way.out,
                    _ => (register + net + way.into).max(way.out),
                };
                assert!(!ways.is_empty(), "{name}");
                assert!(ways.iter().all(|way| way.into >= 0.0 && way.out >= 0.0), "{name}");
                let rises = |pair: &[BlockPipeline]| {
                    pair[0].clocks < pair[1].clocks && period(&pair[0]) >= period(&pair[1])
                };
                assert!(ways.windows(2).all(rises), "{name}: more registers, and no faster");
            }
        }
    }
}

//! What an operator costs, asked wherever it matters, so that pipelining for a device can change
//! without touching units or cores.
mod device;

use serde::Deserialize;

use crate::design::Op;
pub use device::Device;

/// A device, as far as pipelining asks.
pub trait Target {
    /// Its name, for headers and reports.
    fn name(&self) -> &'static str;
    /// Clocks from an operator's operands to its registered result; 0 for no register.
    fn registers_after(&self, op: &Op) -> u32;
}

/// No device in particular: one register after each multiplier, adder and multiplexer. Comparators
/// and gates feed the multiplexer they belong to within the same clock; shifts and ports are wires.
#[derive(Clone, Copy, Debug, Default)]
pub struct Generic;

impl Target for Generic {
    fn name(&self) -> &'static str {
        "generic"
    }

    fn registers_after(&self, op: &Op) -> u32 {
        match op {
            Op::Add(..) | Op::Sub(..) | Op::Mul(..) | Op::Select(..) => 1,
            Op::Input
            | Op::Constant(_)
            | Op::Copy(_)
            | Op::ShiftLeft(..)
            | Op::ShiftRight(..)
            | Op::Wrap(_)
            | Op::LessThan(..)
            | Op::And(..)
            | Op::Or(..)
            | Op::LookUp(..)
            | Op::Not(_) => 0,
        }
    }
}

/// A family of devices, as far as their budgets go.
#[derive(Clone, Debug, Deserialize)]
pub struct Family {
    /// Its name on the command line.
    pub name: String,
    /// Its multiplier blocks, if it has any.
    pub multiplier: Option<Multiplier>,
    /// Its devices, the smallest first.
    #[serde(default, rename = "device")]
    pub devices: Vec<Device>,
}

/// A multiplier block.
#[derive(Clone, Debug, Deserialize)]
pub struct Multiplier {
    /// Widths of signed operands, in bits, the wider one first.
    pub widths: [u32; 2],
}

/// The tables.
const TABLES: [&str; 6] = [
    include_str!("../targets/generic.toml"),
    include_str!("../targets/ice40hx.toml"),
    include_str!("../targets/ice40up.toml"),
    include_str!("../targets/ecp5.toml"),
    include_str!("../targets/gowin.toml"),
    include_str!("../targets/xilinx7.toml"),
];

/// All families.
pub fn families() -> impl Iterator<Item = Family> {
    // The tables are part of the program, and a test reads each.
    TABLES.into_iter().map(|table| toml::from_str(table).expect("a table of the program's own"))
}

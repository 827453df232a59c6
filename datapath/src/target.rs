//! What an operator costs, asked wherever it matters, so that pipelining for a device can change
//! without touching units or cores.
use crate::design::Op;

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

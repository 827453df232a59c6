//! How long operators take, nets included.
use super::{Fabric, Target};
use crate::design::Op;

/// What of an operator its delay depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Wires: no delay.
    Wires,
    /// A function of few bits in one look-up table.
    Gate,
    /// Whether any of so many bits is 1.
    AnyOf(u32),
    /// A carry chain of so many bits.
    Carry(u32),
    /// A table in logic with so many bits of address.
    Table(u32),
    /// A product.
    Product,
}

impl Shape {
    /// The shape of an operator whose result has `width` bits; `operand` gives its operands' widths,
    /// 0 for those of constants 0.
    pub fn of(op: &Op, width: u32, operand: impl Fn(crate::design::NodeId) -> u32) -> Shape {
        match *op {
            Op::Input
            | Op::Constant(_)
            | Op::Copy(_)
            | Op::ShiftLeft(..)
            | Op::ShiftRight(..)
            | Op::Wrap(_) => Shape::Wires,
            Op::Add(..) | Op::Sub(..) => Shape::Carry(width),
            // The sign alone.
            Op::LessThan(_, b) if operand(b) == 0 => Shape::Wires,
            // Any bit at all.
            Op::LessThan(a, b) if operand(a) == 0 => Shape::AnyOf(operand(b)),
            Op::LessThan(a, b) => Shape::Carry(operand(a).max(operand(b))),
            Op::And(..) | Op::Or(..) | Op::Not(_) | Op::Select(..) => Shape::Gate,
            Op::LookUp(a, _) => Shape::Table(operand(a)),
            Op::Mul(..) => Shape::Product,
        }
    }
}

impl Fabric {
    /// Nanoseconds from an operand's cell through an operator in logic, the net to it included.
    pub fn delay(&self, shape: Shape) -> f64 {
        let gate = self.net + self.lut;
        match shape {
            Shape::Wires => 0.0,
            Shape::Gate => gate,
            Shape::AnyOf(bits) => gate * f64::from(bits.max(2).ilog2().div_ceil(2)),
            Shape::Carry(width) => self.net + self.carry + self.carry_bit * f64::from(width),
            // Four bits of address in a look-up table, then two more for each level of multiplexers.
            Shape::Table(bits) => gate * f64::from(1 + bits.saturating_sub(4).div_ceil(2)),
            Shape::Product => f64::INFINITY,
        }
    }

    /// Most bits of a carry chain that begins at a register and ends at one within `period`; none
    /// if not even one bit does.
    pub fn widest_sum(&self, period: f64) -> Option<u32> {
        let bits = (period - self.register - self.delay(Shape::Carry(0))) / self.carry_bit;
        (bits >= 1.0).then_some(bits as u32)
    }
}

impl Target {
    /// The registers of a multiplier block with which products are ready soonest at a clock of this
    /// period; those with the most registers where none is.
    pub fn block_pipeline(&self, period: f64) -> Option<&super::BlockPipeline> {
        let fabric = self.fabric.as_ref()?;
        let pipelines = &self.multiplier.as_ref()?.pipeline;
        let meets = |way: &&super::BlockPipeline| match way.clocks {
            0 => fabric.register + fabric.net + way.into + way.out <= period,
            _ => fabric.register + fabric.net + way.into <= period && way.out <= period,
        };
        pipelines.iter().find(meets).or(pipelines.last())
    }
}

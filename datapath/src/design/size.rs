//! What a design is made of, before any FPGA tool sees it.
use serde::{Deserialize, Serialize};

use super::{Design, Node, NodeId, Op, ScopeId};

/// Operators and registers, counted.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Size {
    /// Multipliers of two variables.
    pub multipliers: usize,
    /// Sum over multipliers of the product of their operands' widths.
    pub multiplier_bits: u64,
    /// Adders and subtractors.
    pub adders: usize,
    /// Sum of the adders' result widths.
    pub adder_bits: u64,
    /// Multiplexers.
    pub multiplexers: usize,
    /// Register bits.
    pub register_bits: u64,
    /// Bits of read-only memory.
    pub table_bits: u64,
}

/// Size of what stands in one unit itself, its inner units apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitSize {
    /// Full name of the unit.
    pub path: String,
    /// Its clocks from input to output.
    pub latency: u32,
    /// What it is made of.
    pub size: Size,
}

impl Size {
    fn count(&mut self, design: &Design, (id, node): (NodeId, &Node)) {
        let width = |id| u64::from(design.node(id).width());
        match node.op {
            Op::Mul(a, b) if design.factors(node).is_some() => {
                self.multipliers += 1;
                self.multiplier_bits += width(a) * width(b);
            }
            // A product with a constant is a sum of shifts, at most one adder for each two bits of
            // the constant.
            Op::Add(..) | Op::Sub(..) | Op::Mul(..) | Op::LessThan(..) => {
                self.adders += 1;
                self.adder_bits += u64::from(node.width());
            }
            // A flip-flop has a clock enable of its own.
            Op::Select(..) if node.clock_enable(id).is_some() => {}
            Op::Select(..) => self.multiplexers += 1,
            Op::LookUp(_, table) => {
                self.table_bits +=
                    design.tables[table.0 as usize].entries.len() as u64 * u64::from(node.width())
            }
            _ => {}
        }
        if node.registered() {
            self.register_bits += u64::from(node.width());
        }
    }
}

impl Design {
    /// The operands of a product of two variables, which takes a multiplier; one with a constant
    /// takes adders.
    pub fn factors(&self, node: &Node) -> Option<[NodeId; 2]> {
        let variable = |id| self.node(id).op.constant().is_none();
        match node.op {
            Op::Mul(a, b) if variable(a) && variable(b) => Some([a, b]),
            _ => None,
        }
    }

    /// Size of the whole design.
    pub fn size(&self) -> Size {
        let mut size = Size::default();
        self.iter().for_each(|node| size.count(self, node));
        size
    }

    /// Size of every unit, in the order in which they were built.
    pub fn unit_sizes(&self) -> Vec<UnitSize> {
        let unit = |index: usize| {
            let id = ScopeId(index as u32);
            let mut size = Size::default();
            self.iter()
                .filter(|(_, node)| node.scope == id)
                .for_each(|node| size.count(self, node));
            UnitSize { path: self.path(id).join("."), latency: self.scope(id).latency(), size }
        };
        (0..self.scopes.len()).map(unit).collect()
    }
}

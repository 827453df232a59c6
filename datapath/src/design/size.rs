//! What a design is made of, before any FPGA tool sees it.
use serde::{Deserialize, Serialize};

use super::{Design, Node, NodeId, Op, Range, ScopeId, Table};

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

/// What a design is made of.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Operators and registers.
    pub size: Size,
    /// The factors of each product of two variables.
    pub factors: Vec<Factors>,
}

/// The factors of a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Factors {
    /// Their widths in bits; one without a sign has a bit for it.
    pub widths: [u32; 2],
    /// Whether they have signs.
    pub signed: [bool; 2],
    /// Whether they are the same value.
    pub square: bool,
}

impl Factors {
    /// Those of a product of two values, each with its range.
    pub(crate) fn of([a, b]: [(NodeId, Range); 2]) -> Factors {
        let ranges = [a.1, b.1];
        Factors {
            widths: ranges.map(Range::signed_width),
            signed: ranges.map(Range::signed),
            square: a.0 == b.0,
        }
    }
}

/// What is known of an operand.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Operand {
    /// Every raw value it takes.
    pub range: Range,
    /// Whether it is a constant.
    pub constant: bool,
}

impl Size {
    /// Counts an operator whose result has `width` bits, registers apart.
    pub(crate) fn count(
        &mut self,
        op: Op,
        width: u32,
        tables: &[Table],
        operand: impl Fn(NodeId) -> Operand,
    ) {
        let is_variable = |id| !operand(id).constant;
        match op {
            Op::Mul(a, b) if is_variable(a) && is_variable(b) => {
                let [a, b] = [a, b].map(|id| u64::from(operand(id).range.width()));
                self.multipliers += 1;
                self.multiplier_bits += a * b;
            }
            // A product with a constant is a sum of shifts, at most one adder for each two bits of
            // the constant.
            Op::Add(..) | Op::Sub(..) | Op::Mul(..) | Op::LessThan(..) => {
                self.adders += 1;
                self.adder_bits += u64::from(width);
            }
            Op::Select(..) => self.multiplexers += 1,
            Op::LookUp(_, table) => {
                let entries = tables[table.0 as usize].entries.len() as u64;
                self.table_bits += entries * u64::from(width);
            }
            _ => {}
        }
    }

    fn count_node(&mut self, design: &Design, (id, node): (NodeId, &Node)) {
        // A flip-flop has a clock enable of its own.
        if node.clock_enable(id).is_none() {
            self.count(node.op, node.width(), &design.tables, |id| {
                let operand = design.node(id);
                Operand { range: operand.range, constant: operand.op.constant().is_some() }
            });
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
        self.iter().for_each(|node| size.count_node(self, node));
        size
    }

    /// What the whole design is made of.
    pub fn extent(&self) -> Extent {
        let products = self.nodes.iter().filter_map(|node| self.factors(node));
        let factor = |id| (id, self.node(id).range);
        let factors = products.map(|of| Factors::of(of.map(factor)));
        Extent { size: self.size(), factors: factors.collect() }
    }

    /// Size of every unit, in the order in which they were built.
    pub fn unit_sizes(&self) -> Vec<UnitSize> {
        let unit = |index: usize| {
            let id = ScopeId(index as u32);
            let mut size = Size::default();
            self.iter()
                .filter(|(_, node)| node.scope == id)
                .for_each(|node| size.count_node(self, node));
            UnitSize { path: self.path(id).join("."), latency: self.scope(id).latency(), size }
        };
        (0..self.scopes.len()).map(unit).collect()
    }
}

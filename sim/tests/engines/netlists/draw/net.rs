//! A netlist that grows.
use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, Range, Register, Scope, ScopeId};
use specula_fixtures::{Draw, designs};

use super::ranges;
use crate::netlists::profile::Profile;

/// What the comment of every unit says.
const FORMULA: &str = "drawn";

pub struct Net<'r> {
    pub design: Design,
    pub draw: &'r mut Draw,
    pub profile: Profile,
    /// The unit that signals are added to.
    pub scope: ScopeId,
    /// Registers whose operand comes last of all.
    pub open: Vec<NodeId>,
}

/// A unit of a netlist, below the top.
pub fn scope(number: usize, parent: ScopeId) -> Scope {
    designs::scope(&format!("unit{number}"), FORMULA, Some(parent))
}

/// A design with nothing but its control inputs.
pub fn empty() -> Design {
    designs::empty(FORMULA)
}

/// A signal, named after its number.
pub fn node(number: usize, op: Op, register: Register, range: Range, scope: ScopeId) -> Node {
    Node {
        op,
        register,
        range,
        fraction_bits: 0,
        stage: 0,
        still: false,
        scope,
        name: format!("n{number}"),
        named: true,
    }
}

impl<'r> Net<'r> {
    pub fn new(draw: &'r mut Draw, profile: Profile) -> Net<'r> {
        Net { design: empty(), draw, profile, scope: ScopeId::TOP, open: vec![] }
    }

    pub fn range(&self, id: NodeId) -> Range {
        self.design.node(id).range
    }

    /// A new signal with a range that is known to be true.
    pub fn place(&mut self, op: Op, register: Register, range: Range) -> NodeId {
        assert!(range.width() <= 63, "{op:?} is too wide");
        let id = NodeId(self.design.nodes.len() as u32);
        let mut node = node(self.design.nodes.len(), op, register, range, self.scope);
        let before =
            op.operands().filter(|&o| o < id).map(|o| self.design.node(o).stage).max().unwrap_or(0);
        node.stage = before + u32::from(register != Register::None);
        self.design.nodes.push(node);
        id
    }

    pub fn input(&mut self, range: Range) -> NodeId {
        self.place(Op::Input, Register::None, range)
    }

    pub fn constant(&mut self, value: i64) -> NodeId {
        self.place(Op::Constant(value), Register::None, Range::single(value))
    }

    /// A new signal with the range that its operands give it; `None` if that is too wide.
    pub fn add(&mut self, op: Op, register: Register) -> Option<NodeId> {
        let range = ranges::of(&self.design, op)?;
        // A linter takes what is always the same for a mistake, and the builder leaves it out.
        if self.profile.verilog && range.low == range.high {
            return None;
        }
        let range = if register == Register::None { range } else { range.hull(Range::single(0)) };
        Some(self.place(op, register, range))
    }

    /// With a register or without.
    pub fn any_register(&mut self) -> Register {
        if self.draw.below(2) == 0 { Register::Data } else { Register::None }
    }

    /// The signals that can be read here.
    pub fn readable(&self) -> Vec<NodeId> {
        let here = |(_, node): &(NodeId, &Node)| {
            node.scope == self.scope && !matches!(node.op, Op::Constant(_))
        };
        self.design.iter().filter(here).map(|(id, _)| id).collect()
    }

    /// A signal that can be read here, late ones more often, and now and then a constant.
    pub fn pick(&mut self) -> NodeId {
        let readable = self.readable();
        if readable.is_empty() || self.draw.below(12) == 0 {
            let value = ranges::constant(self.draw);
            return self.constant(value);
        }
        let (a, b) = (self.draw.below(readable.len()), self.draw.below(readable.len()));
        readable[if self.draw.below(3) == 0 { a } else { a.max(b) }]
    }

    /// A bit that can be read here.
    pub fn pick_bit(&mut self) -> NodeId {
        let bits: Vec<NodeId> =
            self.readable().into_iter().filter(|&id| ranges::is_bit(self.range(id))).collect();
        if !bits.is_empty() && self.draw.below(3) > 0 {
            return bits[self.draw.below(bits.len())];
        }
        let (a, b) = (self.pick(), self.pick());
        let register = self.any_register();
        self.place(Op::LessThan(a, b), register, ranges::bit())
    }
}

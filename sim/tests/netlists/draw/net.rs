//! A netlist that grows.
use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, Range, Register, Scope, ScopeId};

use super::ranges;
use crate::common::random::Random;
use crate::profile::Profile;

pub struct Net<'r> {
    pub design: Design,
    pub random: &'r mut Random,
    pub profile: Profile,
    /// The unit that signals are added to.
    pub scope: ScopeId,
    /// Registers whose operand comes last of all.
    pub open: Vec<NodeId>,
}

/// A unit of a netlist.
pub fn scope(number: usize, parent: Option<ScopeId>) -> Scope {
    let name = if parent.is_some() { format!("unit{number}") } else { "core".to_owned() };
    Scope { unit: name.clone(), formula: "drawn".into(), instance: name, parent, entry: 0, exit: 0 }
}

/// A design with nothing but its control inputs.
pub fn empty() -> Design {
    let (valid, start) = (NodeId(0), NodeId(1));
    let mut design = Design {
        nodes: vec![],
        tables: vec![],
        scopes: vec![scope(0, None)],
        inputs: vec![],
        valid,
        start,
        interval: 1,
        valid_out: valid,
        outputs: vec![],
        output_errors: vec![],
        assumptions: vec![],
        left_out: vec![],
    };
    design.nodes.extend(
        [0, 1].map(|number| node(number, Op::Input, Register::None, ranges::bit(), ScopeId::TOP)),
    );
    design
}

/// A signal, named after its number.
pub fn node(number: usize, op: Op, register: Register, range: Range, scope: ScopeId) -> Node {
    Node {
        op,
        register,
        range,
        fraction_bits: 0,
        stage: 0,
        scope,
        name: format!("n{number}"),
        named: true,
    }
}

impl<'r> Net<'r> {
    pub fn new(random: &'r mut Random, profile: Profile) -> Net<'r> {
        Net { design: empty(), random, profile, scope: ScopeId::TOP, open: vec![] }
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
        if self.random.below(2) == 0 { Register::Data } else { Register::None }
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
        if readable.is_empty() || self.random.below(12) == 0 {
            let value = ranges::constant(self.random);
            return self.constant(value);
        }
        let (a, b) = (self.random.below(readable.len()), self.random.below(readable.len()));
        readable[if self.random.below(3) == 0 { a } else { a.max(b) }]
    }

    /// A bit that can be read here.
    pub fn pick_bit(&mut self) -> NodeId {
        let bits: Vec<NodeId> =
            self.readable().into_iter().filter(|&id| ranges::is_bit(self.range(id))).collect();
        if !bits.is_empty() && self.random.below(3) > 0 {
            return bits[self.random.below(bits.len())];
        }
        let (a, b) = (self.pick(), self.pick());
        let register = self.any_register();
        self.place(Op::LessThan(a, b), register, ranges::bit())
    }
}

//! From a design to a tree of modules.
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use rust_hdl_core::prelude::*;

use super::wire::Role;
use super::{Cell, Child, Module, Wire};
use crate::design::{
    Assumption, Design, MultiplierBlock, Node, NodeId, Op, Range, Register, ScopeId, Table,
};

/// What crosses borders, worked out once for the whole design.
struct Borders<'a> {
    design: &'a Design,
    /// Signals of a unit that its parent reads, or that leave the core.
    outputs: HashSet<NodeId>,
    /// The signals of each unit, in order.
    members: HashMap<ScopeId, Vec<NodeId>>,
    /// The products in multiplier blocks of each unit.
    multipliers: HashMap<ScopeId, Vec<&'a MultiplierBlock>>,
    tables: Rc<[Table]>,
    /// Whether registers or inputs lead to each signal by wires alone.
    stored: Vec<bool>,
}

impl Design {
    /// The design as a tree of rust-hdl modules, its constants local to each module that reads
    /// them.
    pub fn to_block(&self) -> Module {
        let mut module = Borders::new(self).module(ScopeId::TOP);
        module.connect_all();
        module
    }
}

impl<'a> Borders<'a> {
    fn new(design: &'a Design) -> Borders<'a> {
        let mut outputs: HashSet<NodeId> =
            design.outputs.iter().copied().chain([design.valid_out]).collect();
        let mut members: HashMap<ScopeId, Vec<NodeId>> = HashMap::new();
        for (id, node) in design.iter() {
            if node.op.constant().is_some() {
                continue;
            }
            members.entry(node.scope).or_default().push(id);
            let inner = node
                .op
                .operands()
                .filter(|&o| design.scope(design.node(o).scope).parent == Some(node.scope));
            outputs.extend(inner.filter(|&o| design.node(o).op.constant().is_none()));
        }
        let mut multipliers: HashMap<ScopeId, Vec<&MultiplierBlock>> = HashMap::new();
        for block in &design.multipliers {
            multipliers.entry(design.node(block.product).scope).or_default().push(block);
        }
        let (tables, stored) = (design.tables.clone().into(), stored(design));
        Borders { design, outputs, members, multipliers, tables, stored }
    }

    fn kind(&self, id: NodeId) -> AtomKind {
        let node = self.design.node(id);
        let from_parent =
            |o: NodeId| self.design.scope(node.scope).parent == Some(self.design.node(o).scope);
        let is_port = matches!(node.op, Op::Copy(o) if !node.registered() && !self.is_constant(o) && from_parent(o));
        match node.op {
            Op::Input => AtomKind::InputParameter,
            _ if is_port => AtomKind::InputParameter,
            _ if self.outputs.contains(&id) => AtomKind::OutputParameter,
            _ => AtomKind::LocalSignal,
        }
    }

    /// The stated fact by which a signal is narrower than its operand.
    fn fact(&self, id: NodeId) -> Option<String> {
        let node = self.design.node(id);
        let Op::Wrap(operand) = node.op else { return None };
        let about = |a: &&Assumption| a.node == operand && a.range == node.range;
        self.design.assumptions.iter().find(about).map(|a| a.fact.clone())
    }

    fn is_constant(&self, id: NodeId) -> bool {
        self.design.node(id).op.constant().is_some()
    }

    fn module(&self, scope: ScopeId) -> Module {
        let about = self.design.scope(scope);
        let mut module = Module {
            unit: about.unit.clone(),
            formula: about.formula.clone(),
            instance: about.instance.clone(),
            stages: (about.entry, about.exit),
            clock: Default::default(),
            reset: None,
            wires: vec![],
            gates: vec![],
            registers: vec![],
            children: vec![],
            primitives: self.design.primitives,
            multipliers: vec![],
            tables: self.tables.clone(),
            active: true,
        };
        let local = self.wires(&mut module, scope);
        self.cells(&mut module, scope, &local);
        let children = (0..self.design.scopes.len() as u32)
            .map(ScopeId)
            .filter(|&c| self.design.scope(c).parent == Some(scope));
        for child in children.filter(|c| self.members.contains_key(c)) {
            let child = self.child(child, &local);
            module.children.push(child);
        }
        module
    }

    fn members(&self, scope: ScopeId) -> &[NodeId] {
        self.members.get(&scope).map_or(&[], Vec::as_slice)
    }

    /// Makes the module's wires and says which wire carries which signal.
    fn wires(&self, module: &mut Module, scope: ScopeId) -> HashMap<NodeId, u32> {
        let mut local = HashMap::new();
        for &id in self.members(scope) {
            local.insert(id, module.wires.len() as u32);
            let stored = self.stored[id.0 as usize];
            let role = Role { kind: self.kind(id), fact: self.fact(id), stored };
            module.wires.push(Wire::new(id, self.design.node(id), role));
        }
        if self.members(scope).iter().any(|&id| self.design.node(id).register == Register::Validity)
        {
            let node = Node {
                name: "reset".into(),
                range: Range::new(0, 1),
                fraction_bits: 0,
                ..self.design.node(self.design.valid).clone()
            };
            module.reset = Some(module.wires.len() as u32);
            let role = Role { kind: AtomKind::InputParameter, fact: None, stored: true };
            module.wires.push(Wire::new(self.design.valid, &node, role));
        }
        local
    }

    fn cells(&self, module: &mut Module, scope: ScopeId, local: &HashMap<NodeId, u32>) {
        let mut constants = HashMap::new();
        for &id in self.members(scope) {
            let node = self.design.node(id);
            let crosses = matches!(node.op, Op::Copy(o) if !node.registered() && !self.is_constant(o) && !local.contains_key(&o));
            if node.op == Op::Input || crosses {
                continue;
            }
            let op = node.op.map(|o| {
                let wire = local.get(&o).or_else(|| constants.get(&o)).copied();
                NodeId(wire.unwrap_or_else(|| self.constant(module, o, &mut constants)))
            });
            let cell = Cell { wire: local[&id], op, register: node.register };
            if node.registered() { module.registers.push(cell) } else { module.gates.push(cell) }
        }
        for block in self.multipliers.get(&scope).into_iter().flatten() {
            let wire = |id: NodeId| local.get(&id).or_else(|| constants.get(&id)).copied();
            module.multipliers.extend(block.renumbered(|id| wire(id).map(NodeId)));
        }
    }

    /// A wire of the module that carries the constant `id`.
    fn constant(
        &self,
        module: &mut Module,
        id: NodeId,
        constants: &mut HashMap<NodeId, u32>,
    ) -> u32 {
        let number = module.wires.len() as u32;
        let role = Role { kind: AtomKind::Constant, fact: None, stored: true };
        let mut wire = Wire::new(id, self.design.node(id), role);
        if let Op::Constant(value) = self.design.node(id).op {
            (wire.value, wire.next) = (value, value);
        }
        module.wires.push(wire);
        module.gates.insert(
            0,
            Cell { wire: number, op: self.design.node(id).op, register: Register::None },
        );
        constants.insert(id, number);
        number
    }

    fn child(&self, scope: ScopeId, outside: &HashMap<NodeId, u32>) -> Child {
        let module = self.module(scope);
        let (mut inputs, mut outputs) = (vec![], vec![]);
        // Constants are local to each module that reads them and cross no border.
        let variable = |(_, wire): &(usize, &Wire)| wire.wire_type().kind != AtomKind::Constant;
        for (pin, wire) in module.wires.iter().enumerate().filter(variable) {
            let id = wire.wire_type().node;
            if let (AtomKind::InputParameter, Op::Copy(from)) =
                (wire.wire_type().kind, self.design.node(id).op)
            {
                inputs.push((pin as u32, outside[&from]));
            }
            let readers =
                outside.iter().filter(|&(&reader, _)| self.design.node(reader).op == Op::Copy(id));
            outputs.extend(readers.map(|(_, &wire)| (pin as u32, wire)));
        }
        outputs.sort_unstable();
        Child { module, inputs, outputs }
    }
}

/// Whether registers or inputs lead to each signal by wires alone.
fn stored(design: &Design) -> Vec<bool> {
    let mut stored: Vec<bool> = Vec::with_capacity(design.nodes.len());
    for (id, node) in design.iter() {
        let of_stored = || node.op.operands().all(|operand| stored[operand.0 as usize]);
        let is_stored = node.registered() || design.operator_kind(id).is_none() && of_stored();
        stored.push(is_stored);
    }
    stored
}

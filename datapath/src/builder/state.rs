//! The design while it grows.
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use super::TooWide;
use super::fold;
use crate::design::{
    Design, LeftOut, Node, NodeId, Op, Range, Register, Scope, ScopeId, WideRange,
};
use crate::target::Target;
use crate::verilog::{CONTROL, is_reserved};

/// What is known of a new signal beside its operator.
#[derive(Clone)]
pub(super) struct Facts {
    pub range: WideRange,
    pub fraction_bits: u32,
    /// Bound on |fixed - real|, in units of the last place.
    pub error: f64,
    /// What to call it until somebody gives it a name.
    pub kind: &'static str,
}

pub(super) struct State {
    pub design: Design,
    pub target: Rc<dyn Target>,
    /// The unit that operators are added to.
    pub scope: ScopeId,
    /// The delay register behind a signal, in its unit.
    delays: HashMap<NodeId, NodeId>,
    names: HashSet<(ScopeId, String)>,
    /// Signals whose name is a stand-in: their kind and a number, or the port of the unit they come
    /// from.
    unnamed: HashSet<NodeId>,
    /// What computes which signal, so that nothing is built twice in a unit.
    computed: HashMap<(ScopeId, Op, Register), NodeId>,
    /// What the next unit's instance is to be called, if not after the unit.
    pub instance: Option<String>,
    too_wide: Option<TooWide>,
}

impl State {
    pub fn new(name: &str, formula: &str, target: Rc<dyn Target>) -> State {
        let top = Scope {
            unit: name.into(),
            formula: formula.into(),
            instance: name.into(),
            parent: None,
            entry: 0,
            exit: 0,
        };
        let none = NodeId(0);
        let design = Design {
            nodes: vec![],
            tables: vec![],
            scopes: vec![top],
            inputs: vec![],
            valid: none,
            start: none,
            interval: 1,
            valid_out: none,
            outputs: vec![],
            output_errors: vec![],
            assumptions: vec![],
            left_out: vec![],
        };
        // A signal of the module's own name would hide the module.
        let taken = CONTROL.into_iter().chain([name]);
        let names = taken.map(|taken| (ScopeId::TOP, taken.to_owned())).collect();
        let scope = ScopeId::TOP;
        let computed = HashMap::new();
        State {
            design,
            target,
            scope,
            delays: HashMap::new(),
            names,
            unnamed: HashSet::new(),
            computed,
            instance: None,
            too_wide: None,
        }
    }

    pub fn is_constant(&self, id: NodeId) -> Option<i64> {
        self.design.node(id).op.constant()
    }

    pub fn leave_out(&mut self, what: &str, why: &str) {
        let unit = self.design.path(self.scope).join(".");
        self.design.left_out.push(LeftOut { unit, what: what.into(), why: why.into() });
    }

    pub fn constant(&mut self, value: i64, fraction_bits: u32) -> NodeId {
        let node = Node {
            op: Op::Constant(value),
            register: Register::None,
            range: Range::single(value),
            fraction_bits,
            stage: 0,
            scope: self.scope,
            name: String::new(),
            named: false,
        };
        self.push(node)
    }

    pub fn open_input(&mut self, name: &str, range: Range, fraction_bits: u32) -> NodeId {
        let name = self.unique(self.scope, name);
        let (op, register, scope) = (Op::Input, Register::None, self.scope);
        self.push(Node { op, register, range, fraction_bits, stage: 0, scope, name, named: true })
    }

    /// Adds an operator, or gives the signal whose raw values are the same anyway: what it folds
    /// to, or its twin. That signal may stand for another real value, so errors belong to the
    /// [`Sig`](super::Sig) that refers to it. Operands are in this unit and of one stage.
    pub fn emit(&mut self, op: Op, register: Register, facts: Facts) -> NodeId {
        if let Some(id) = fold::folded(self, op, &facts) {
            return id;
        }
        let key = (self.scope, op, register);
        if let Some(&same) = self.computed.get(&key).filter(|&&same| self.agrees(same, &facts)) {
            return same;
        }
        let stage = self.common_stage(op);
        let (name, scope) = (self.numbered(facts.kind), self.scope);
        let range = self.fitted(facts.range, &name);
        let clocks = u32::from(register != Register::None);
        let node = Node {
            op,
            register,
            range,
            fraction_bits: facts.fraction_bits,
            stage: stage + clocks,
            scope,
            name,
            named: true,
        };
        let id = self.push(node);
        self.unnamed.insert(id);
        self.computed.insert(key, id);
        id
    }

    fn agrees(&self, id: NodeId, facts: &Facts) -> bool {
        let node = self.design.node(id);
        facts.range.narrow() == Ok(node.range) && node.fraction_bits == facts.fraction_bits
    }

    /// The register that the target wants behind an operator.
    pub fn register_after(&self, op: &Op) -> Register {
        if self.target.registers_after(op) > 0 { Register::Data } else { Register::None }
    }

    /// Registers that the target wants behind an operator beyond its own.
    pub fn further_registers(&self, op: &Op) -> u32 {
        self.target.registers_after(op).saturating_sub(1)
    }

    fn common_stage(&self, op: Op) -> u32 {
        op.operands()
            .filter(|&o| self.is_constant(o).is_none())
            .map(|o| self.design.node(o).stage)
            .max()
            .unwrap_or(0)
    }

    /// The signal as it is at a later `stage`: delayed by registers that all its readers share.
    pub fn aligned(&mut self, id: NodeId, stage: u32) -> NodeId {
        let mut at = id;
        while self.is_constant(at).is_none() && self.design.node(at).stage < stage {
            at = match self.delays.get(&at) {
                Some(&delayed) => delayed,
                None => self.delay(at),
            };
        }
        at
    }

    fn delay(&mut self, id: NodeId) -> NodeId {
        let node = self.design.node(id).clone();
        let name = self.unique(node.scope, &delayed_name(&node.name));
        let delayed = self.push(Node {
            op: Op::Copy(id),
            register: Register::Data,
            stage: node.stage + 1,
            name,
            ..node
        });
        self.design.nodes[delayed.0 as usize].named = false;
        self.delays.insert(id, delayed);
        delayed
    }

    /// `valid`, which is of the first stage, delayed to `stage` by registers that reset clears.
    pub fn validity_after(&mut self, valid: NodeId, stage: u32) -> NodeId {
        let mut at = valid;
        for clock in 1..=stage {
            let node = self.design.node(at).clone();
            let name =
                if clock == stage { "valid_out".to_owned() } else { format!("valid_{clock}") };
            let name = self.unique(ScopeId::TOP, &name);
            at = self.push(Node {
                op: Op::Copy(at),
                register: Register::Validity,
                stage: clock,
                name,
                ..node
            });
            self.design.nodes[at.0 as usize].named = clock == stage;
        }
        at
    }

    /// A signal of the core's own that leaves it as `name` at `stage`.
    pub fn output(&mut self, id: NodeId, stage: u32, name: &str) -> NodeId {
        let id = self.aligned(id, stage);
        let node = self.design.node(id).clone();
        let name = self.unique(ScopeId::TOP, name);
        let (op, register, scope) = (Op::Copy(id), Register::None, ScopeId::TOP);
        self.push(Node { op, register, stage, scope, name, ..node })
    }

    pub fn close(&mut self, last: u32) -> Result<Design, TooWide> {
        self.design.scopes[0].exit = last;
        if let Some(too_wide) = self.too_wide.take() {
            return Err(too_wide);
        }
        let mut design = self.design.clone();
        for &NodeId(index) in &self.unnamed {
            design.nodes[index as usize].named = false;
        }
        design.prune();
        Ok(design)
    }

    /// Calls the output of a unit after the signal that it delays.
    pub fn name_delayed_output(&mut self, id: NodeId, of: NodeId) {
        let name = format!("{}_out", self.design.node(of).name);
        self.unnamed.insert(id);
        self.name(id, &name);
        self.design.nodes[id.0 as usize].named = true;
    }

    /// Lets a later name take the place of the one the signal has.
    pub fn nameable(&mut self, id: NodeId) {
        self.unnamed.insert(id);
    }

    /// Gives a signal a name if it has none yet.
    pub fn name(&mut self, id: NodeId, name: &str) {
        if self.unnamed.remove(&id) {
            let scope = self.design.node(id).scope;
            let old = self.design.node(id).name.clone();
            self.names.remove(&(scope, old));
            let name = self.unique(scope, name);
            self.design.nodes[id.0 as usize].name = name;
        }
    }

    /// `name`, or with a number behind it where the unit has it already.
    pub fn unique(&mut self, scope: ScopeId, name: &str) -> String {
        // A word that Verilog keeps for itself gets a number, as one that the unit has already.
        let mut candidate = if is_reserved(name) { format!("{name}_1") } else { name.to_owned() };
        let mut number = 2;
        while !self.names.insert((scope, candidate.clone())) {
            candidate = format!("{name}_{number}");
            number += 1;
        }
        candidate
    }

    fn numbered(&mut self, kind: &str) -> String {
        let mut number = 1;
        loop {
            let candidate = format!("{kind}_{number}");
            if self.names.insert((self.scope, candidate.clone())) {
                return candidate;
            }
            number += 1;
        }
    }

    /// The range, or (noting the fault) a stand-in for one that does not fit 63 bits.
    fn fitted(&mut self, range: WideRange, name: &str) -> Range {
        range.narrow().unwrap_or_else(|width| {
            let signal = format!("{}.{name}", self.design.path(self.scope).join("."));
            self.too_wide.get_or_insert(TooWide { signal, width });
            Range::new(0, 1)
        })
    }

    /// Adds a signal, which counts as named until something else is said of it.
    pub fn push(&mut self, node: Node) -> NodeId {
        self.design.nodes.push(Node { named: true, ..node });
        NodeId(self.design.nodes.len() as u32 - 1)
    }
}

/// `n_x` becomes `n_x_d1`, and that `n_x_d2`.
fn delayed_name(name: &str) -> String {
    let counted =
        name.rsplit_once("_d").and_then(|(base, digits)| Some((base, digits.parse::<u32>().ok()?)));
    match counted {
        Some((base, clocks)) => format!("{base}_d{}", clocks + 1),
        None => format!("{name}_d1"),
    }
}

//! What a waveform declares: units with their signals in them, in the order in which a file lists
//! them.
use std::collections::HashMap;

use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, Register, Scope, ScopeId};

/// What a waveform declares.
#[derive(Debug)]
pub struct Outline<'a> {
    /// What is inside the core, and the end of the core.
    pub entries: Vec<Entry<'a>>,
    /// The variables whose values the file holds.
    pub variables: Vec<Variable>,
}

/// An entry of the list.
#[derive(Clone, Copy, Debug)]
pub enum Entry<'a> {
    /// A unit begins: first its signals, then the units within it.
    Unit(&'a Scope),
    /// A signal, and the number of its variable. Signals that are connected have one variable,
    /// which the first of them brings: numbers of variables are in the order of the entries.
    Signal(&'a Node, usize),
    /// The innermost unit that has begun ends.
    End,
}

/// Something that has values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Variable {
    /// The column in which they are.
    pub column: usize,
    /// Width in bits.
    pub width: u32,
}

impl<'a> Outline<'a> {
    /// The outline for `nodes`; constants are left out, and units in which nothing is shown.
    pub fn new(design: &'a Design, nodes: &[NodeId]) -> Outline<'a> {
        let units = design.scopes.len();
        let mut draft = Draft {
            design,
            signals: vec![vec![]; units],
            shown: vec![false; units],
            known: HashMap::new(),
        };
        for (column, &id) in
            nodes.iter().enumerate().filter(|&(_, &id)| design.node(id).op.constant().is_none())
        {
            draft.admit(column, id);
        }
        let mut outline = Outline { entries: vec![], variables: vec![] };
        draft.inside(ScopeId::TOP, &mut outline);
        outline
    }
}

/// The signal that `id` is connected to: ports of units have the value of what is behind them, bit
/// by bit.
fn origin(design: &Design, id: NodeId) -> NodeId {
    let node = design.node(id);
    match node.op {
        Op::Copy(of)
            if node.register == Register::None && design.node(of).width() == node.width() =>
        {
            origin(design, of)
        }
        _ => id,
    }
}

/// An outline while it is made.
struct Draft<'a> {
    design: &'a Design,
    /// The signals of each unit, with their columns.
    signals: Vec<Vec<(usize, NodeId)>>,
    /// Whether something is shown in a unit or in one within it.
    shown: Vec<bool>,
    /// The variables of signals that others are connected to.
    known: HashMap<NodeId, usize>,
}

impl<'a> Draft<'a> {
    fn admit(&mut self, column: usize, id: NodeId) {
        let scope = self.design.node(id).scope;
        self.signals[scope.0 as usize].push((column, id));
        let mut at = Some(scope);
        while let Some(scope) = at.filter(|scope| !self.shown[scope.0 as usize]) {
            self.shown[scope.0 as usize] = true;
            at = self.design.scope(scope).parent;
        }
    }

    fn inside(&mut self, scope: ScopeId, outline: &mut Outline<'a>) {
        for (column, id) in std::mem::take(&mut self.signals[scope.0 as usize]) {
            let node = self.design.node(id);
            let variable =
                *self.known.entry(origin(self.design, id)).or_insert(outline.variables.len());
            if variable == outline.variables.len() {
                outline.variables.push(Variable { column, width: node.width() });
            }
            outline.entries.push(Entry::Signal(node, variable));
        }
        for index in 0..self.design.scopes.len() as u32 {
            let inner = self.design.scope(ScopeId(index));
            if inner.parent == Some(scope) && self.shown[index as usize] {
                outline.entries.push(Entry::Unit(inner));
                self.inside(ScopeId(index), outline);
            }
        }
        outline.entries.push(Entry::End);
    }
}

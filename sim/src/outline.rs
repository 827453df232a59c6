//! What a waveform declares: units with their signals in them, in the order in which a file lists them.
use specula_hdl::Design;
use specula_hdl::design::{Node, NodeId, Op, Scope, ScopeId};

/// An entry of the list.
#[derive(Clone, Copy, Debug)]
pub enum Entry<'a> {
    /// A unit begins: first its signals, then the units within it.
    Unit(&'a Scope),
    /// A signal, and its column among those that are written.
    Signal(usize, &'a Node),
    /// The innermost unit that has begun ends.
    End,
}

/// What is inside the core for `nodes`, and the end of the core; constants are left out, and units in which nothing is shown.
pub fn outline<'a>(design: &'a Design, nodes: &[NodeId]) -> Vec<Entry<'a>> {
    let units = design.scopes.len();
    let mut outline = Outline { design, signals: vec![vec![]; units], shown: vec![false; units], entries: vec![] };
    for (column, &id) in nodes.iter().enumerate() {
        outline.admit(column, design.node(id));
    }
    outline.inside(ScopeId::TOP);
    outline.entries
}

struct Outline<'a> {
    design: &'a Design,
    /// The signals of each unit, with their columns.
    signals: Vec<Vec<(usize, &'a Node)>>,
    /// Whether something is shown in a unit or in one within it.
    shown: Vec<bool>,
    entries: Vec<Entry<'a>>,
}

impl<'a> Outline<'a> {
    fn admit(&mut self, column: usize, node: &'a Node) {
        if matches!(node.op, Op::Constant(_)) {
            return;
        }
        self.signals[node.scope.0 as usize].push((column, node));
        let mut at = Some(node.scope);
        while let Some(scope) = at.filter(|scope| !self.shown[scope.0 as usize]) {
            self.shown[scope.0 as usize] = true;
            at = self.design.scope(scope).parent;
        }
    }

    fn inside(&mut self, scope: ScopeId) {
        let signals = std::mem::take(&mut self.signals[scope.0 as usize]);
        self.entries.extend(signals.into_iter().map(|(column, node)| Entry::Signal(column, node)));
        for index in 0..self.design.scopes.len() as u32 {
            let inner = self.design.scope(ScopeId(index));
            if inner.parent == Some(scope) && self.shown[index as usize] {
                self.entries.push(Entry::Unit(inner));
                self.inside(ScopeId(index));
            }
        }
        self.entries.push(Entry::End);
    }
}

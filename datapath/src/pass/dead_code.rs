//! Takes out what no output needs.
use crate::design::{Assumption, Design, LeftOut, Node, NodeId, Op, ScopeId};

/// A design without the signals that reach no output.
pub fn without(mut design: Design) -> Design {
    design.prune();
    design
}

impl Design {
    /// Removes signals that reach no output, keeping the order of the rest. Inputs stay: they are
    /// the core's interface.
    fn prune(&mut self) {
        let kept = self.needed();
        self.note_pruned(&kept);
        let mut renumbered = vec![None; self.nodes.len()];
        let mut next = 0;
        for (old, keep) in kept.iter().enumerate() {
            if *keep {
                renumbered[old] = Some(NodeId(next));
                next += 1;
            }
        }
        let new = |id: NodeId| renumbered[id.0 as usize];
        // Operands of a needed signal are needed themselves, so they have a new number.
        let of_needed = |id: NodeId| new(id).unwrap_or(id);
        let mut keep = kept.iter();
        self.nodes.retain(|_| keep.next().copied().unwrap_or(false));
        for node in &mut self.nodes {
            node.op = node.op.map(of_needed);
        }
        self.inputs = self.inputs.iter().map(|id| id.and_then(new)).collect();
        self.multipliers =
            self.multipliers.iter().filter_map(|block| block.renumbered(new)).collect();
        self.outputs = self.outputs.iter().map(|&id| of_needed(id)).collect();
        (self.valid, self.start, self.valid_out) =
            (of_needed(self.valid), of_needed(self.start), of_needed(self.valid_out));
        self.assumptions = std::mem::take(&mut self.assumptions)
            .into_iter()
            .filter_map(|a| new(a.node).map(|node| Assumption { node, ..a }))
            .collect();
    }

    /// A line for each unit that loses operators or registers.
    fn note_pruned(&mut self, kept: &[bool]) {
        let gone = |id: NodeId, node: &Node| {
            let wires = matches!(
                node.op,
                Op::Constant(_)
                    | Op::Copy(_)
                    | Op::Wrap(_)
                    | Op::ShiftLeft(..)
                    | Op::ShiftRight(..)
            );
            !wires && node.clock_enable(id).is_none()
        };
        for scope in (0..self.scopes.len() as u32).map(ScopeId) {
            let pruned = self
                .iter()
                .zip(kept)
                .filter(|((_, node), kept)| !**kept && node.scope == scope)
                .map(|(node, _)| node);
            let (operators, bits) = pruned.fold((0, 0), |(operators, bits), (id, node)| {
                (
                    operators + u32::from(gone(id, node)),
                    bits + if node.registered() { node.width() } else { 0 },
                )
            });
            if operators > 0 || bits > 0 {
                let what = format!("{operators} operators and {bits} register bits");
                let (unit, why) =
                    (self.path(scope).join("."), "nothing reads what they give".to_owned());
                self.left_out.push(LeftOut { unit, what, why });
            }
        }
    }

    fn needed(&self) -> Vec<bool> {
        let mut needed: Vec<bool> = self.nodes.iter().map(|n| n.op == Op::Input).collect();
        let mut open: Vec<NodeId> = self.outputs.iter().copied().chain([self.valid_out]).collect();
        while let Some(id) = open.pop() {
            if !std::mem::replace(&mut needed[id.0 as usize], true) {
                open.extend(self.node(id).op.operands());
            }
        }
        needed
    }
}

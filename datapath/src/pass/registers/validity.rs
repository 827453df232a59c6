//! Validity: one line of registers in the core, which every loop sees at its own stage.
use super::Placing;
use crate::design::{Node, NodeId, Op, Register, ScopeId};

impl Placing<'_> {
    /// Validity as it leaves the design at `stage`.
    pub(super) fn valid_out(&mut self, stage: u32) -> NodeId {
        let valid = self.valid_at(self.signal(self.graph.leaves), stage);
        if self.node(valid).registered() {
            let name = self.unique(ScopeId::TOP, "valid_out");
            let last = &mut self.nodes[valid.0 as usize];
            (last.name, last.named) = (name, true);
        }
        valid
    }

    /// The operator of a register that holds its value where no pixel is, by the bit `valid`. Without
    /// that it reads one signal, or has an enable of its own.
    pub(super) fn with_valid_pixel(&mut self, own: NodeId, op: Op, valid: NodeId) -> Op {
        match op {
            Op::Select(enable, next, _) => {
                let name = format!("{}_enable", self.node(own).name);
                Op::Select(self.both(valid, enable, &name), next, own)
            }
            op => Op::Select(valid, op.operands().next().unwrap_or(own), own),
        }
    }

    /// The operator of a register that is cleared a clock before a valid pixel with `first`, and
    /// takes over `next` with a valid pixel.
    pub(super) fn cleared_before(
        &mut self,
        own: NodeId,
        first: NodeId,
        zero: NodeId,
        next: NodeId,
    ) -> Op {
        let node = self.node(own).clone();
        let coming = self.valid_in(node.scope, node.stage - 1);
        let clear = self.both(coming, first, &format!("{}_clear", node.name));
        let valid = self.valid_in(node.scope, node.stage);
        let name = self.unique(node.scope, &format!("{}_next", node.name));
        let (op, register, named) = (Op::Select(valid, next, own), Register::None, false);
        let kept = self.push(Node { op, register, name, named, ..node });
        Op::Select(clear, zero, kept)
    }

    /// Two bits, both of which are waited for.
    fn both(&mut self, valid: NodeId, enable: NodeId, name: &str) -> NodeId {
        let node = self.node(valid).clone();
        let name = self.unique(node.scope, name);
        let (op, register) = (Op::And(valid, enable), Register::None);
        self.push(Node { op, register, name, named: false, ..node })
    }

    /// Whether a pixel is at `stage`, as a unit sees it: by a port of its own, so that no unit has
    /// registers of validity.
    pub(super) fn valid_in(&mut self, scope: ScopeId, stage: u32) -> NodeId {
        let Some(outside) = self.graph.unit(scope).parent else {
            return self.valid_at(self.signal(self.graph.steps), stage);
        };
        if let Some(&port) = self.valid_ports.get(&(scope, stage)) {
            return port;
        }
        let from = self.valid_in(outside, stage);
        let entry = self.schedule.of_group(self.graph.unit(scope).inputs);
        let name = match stage.saturating_sub(entry) {
            0 => "valid".to_owned(),
            clocks => format!("valid_{clocks}"),
        };
        let name = self.unique(scope, &name);
        let (op, register, node) = (Op::Copy(from), Register::None, self.node(from).clone());
        let port = self.push(Node { op, register, scope, name, named: true, ..node });
        self.valid_ports.insert((scope, stage), port);
        port
    }

    /// A bit of validity, delayed to `stage` by registers that reset clears. All readers share them.
    pub(super) fn valid_at(&mut self, bit: NodeId, stage: u32) -> NodeId {
        let own = self.node(bit).stage;
        let mut at = bit;
        for clock in own + 1..=stage {
            at = match self.valid_later.get(&at) {
                Some(&later) => later,
                None => self.valid_after(at, bit, clock),
            };
        }
        at
    }

    /// The register of validity behind `before`, which is `bit` some clocks later.
    fn valid_after(&mut self, before: NodeId, bit: NodeId, clock: u32) -> NodeId {
        let of = if bit == self.signal(self.graph.leaves) { "valid" } else { "slot_valid" };
        let name = self.unique(ScopeId::TOP, &format!("{of}_{clock}"));
        let (op, register, stage) = (Op::Copy(before), Register::Validity, clock);
        let node = self.node(before).clone();
        let later = self.push(Node { op, register, stage, name, named: false, ..node });
        self.valid_later.insert(before, later);
        later
    }
}

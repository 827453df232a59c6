//! Units: modules with ports, made from what crosses their border.
use std::collections::HashMap;
use std::rc::Rc;

use super::state::Facts;
use super::{Builder, Bundle, Inputs, Sig};
use crate::design::{Node, NodeId, Op, Register, Scope, ScopeId};
use crate::target::Unregistered;
use crate::verilog::CONTROL;

impl Builder {
    /// Opens a unit called `name` that computes `formula`.
    ///
    /// Its inputs become ports of the same stage; what `body` returns becomes its outputs, again of
    /// one stage, so a unit has one latency. Constants go in and out without a port. Signals of the
    /// outside that are no inputs cannot be used in it.
    pub fn unit<I: Inputs, O: Bundle>(
        &self,
        name: &str,
        formula: &str,
        inputs: I,
        body: impl FnOnce(&Builder, I::Values) -> O,
    ) -> O {
        let entry = self.entry_stage(&inputs);
        let (outside, inside) = self.enter(name, formula, entry);
        let values = inputs.map(&mut |sig, port| self.port(sig, port, outside, inside, entry));
        let results = body(self, values);
        self.leave(&results, outside, inside, entry)
    }

    /// Calls the instance of the unit that `body` opens first `name`.
    pub fn instance<R>(&self, name: &str, body: impl FnOnce() -> R) -> R {
        self.state.borrow_mut().instance = Some(name.to_owned());
        body()
    }

    /// What `body` describes works within one clock: its operators get no registers, its results
    /// one each, or none where what is around it works within one clock itself.
    pub fn in_one_clock<O: Bundle>(&self, body: impl FnOnce() -> O) -> O {
        let results = self.without_registers(body);
        let mut last = 0;
        results.map(&mut |sig, _| {
            last = last.max(sig.stage());
            sig.clone()
        });
        results.map(&mut |sig, _| self.behind_a_register(&sig.aligned(last)))
    }

    /// What `body` describes has no registers.
    pub(super) fn without_registers<R>(&self, body: impl FnOnce() -> R) -> R {
        let target = std::mem::replace(&mut self.state.borrow_mut().target, Rc::new(Unregistered));
        let results = body();
        self.state.borrow_mut().target = target;
        results
    }

    /// A target that wants no register behind a multiplexer wants none here: what is around works
    /// within one clock.
    fn behind_a_register(&self, sig: &Sig) -> Sig {
        let id = sig.id();
        if self.state.borrow().register_after(&Op::Select(id, id, id)) == Register::None {
            return sig.clone();
        }
        let facts = Facts {
            range: sig.range().into(),
            fraction_bits: sig.fraction_bits(),
            error: sig.error(),
            kind: "registered",
        };
        self.emit(Op::Copy(sig.id()), Register::Data, facts)
    }

    fn entry_stage<I: Inputs>(&self, inputs: &I) -> u32 {
        let mut entry = 0;
        inputs.map(&mut |sig, _| {
            entry = entry.max(sig.stage());
            sig.clone()
        });
        entry
    }

    fn enter(&self, name: &str, formula: &str, entry: u32) -> (ScopeId, ScopeId) {
        let mut state = self.state.borrow_mut();
        let outside = state.scope;
        let inside = ScopeId(state.design.scopes.len() as u32);
        let called = state.instance.take();
        let instance = state.unique(outside, called.as_deref().unwrap_or(name));
        let scope = Scope {
            unit: name.into(),
            formula: formula.into(),
            instance,
            parent: Some(outside),
            entry,
            exit: entry,
        };
        state.design.scopes.push(scope);
        // The names of every module's control ports.
        for taken in CONTROL {
            state.unique(inside, taken);
        }
        state.scope = inside;
        (outside, inside)
    }

    /// The input `sig` as the unit sees it.
    fn port(&self, sig: &Sig, port: &str, outside: ScopeId, inside: ScopeId, entry: u32) -> Sig {
        let mut state = self.state.borrow_mut();
        if state.is_constant(sig.id()).is_some() {
            drop(state);
            return sig.clone();
        }
        assert_eq!(
            state.design.node(sig.id()).scope,
            outside,
            "unit input `{port}` belongs to another unit"
        );
        state.scope = outside;
        let aligned = state.aligned(sig.id(), entry);
        state.scope = inside;
        let name = state.unique(inside, port);
        let node = state.design.node(aligned).clone();
        let (op, register, fraction_bits) =
            (Op::Copy(aligned), Register::None, sig.fraction_bits());
        let id = state.push(Node { op, register, fraction_bits, scope: inside, name, ..node });
        drop(state);
        sig.at(id)
    }

    fn leave<O: Bundle>(&self, results: &O, outside: ScopeId, inside: ScopeId, entry: u32) -> O {
        let mut exit = entry;
        results.map(&mut |sig, _| {
            exit = exit.max(sig.stage());
            sig.clone()
        });
        let outputs = results.map(&mut |sig, _| {
            let last = sig.aligned(exit);
            if last.id() != sig.id() {
                self.state.borrow_mut().name_delayed_output(last.id(), sig.id());
            }
            self.not_an_input(&last)
        });
        let mut state = self.state.borrow_mut();
        state.design.scopes[inside.0 as usize].exit = exit;
        state.scope = outside;
        drop(state);
        let mut crossed: HashMap<NodeId, NodeId> = HashMap::new();
        outputs.map(&mut |sig, _| {
            let outer = *crossed.entry(sig.id()).or_insert_with(|| self.outer_copy(sig, inside));
            sig.at(outer)
        })
    }

    /// A signal that is not itself a port of the unit's input side.
    fn not_an_input(&self, sig: &Sig) -> Sig {
        let node = self.state.borrow().design.node(sig.id()).clone();
        let passes_through = match node.op {
            Op::Copy(from) => {
                let state = self.state.borrow();
                !node.registered()
                    && state.design.scope(node.scope).parent == Some(state.design.node(from).scope)
            }
            _ => false,
        };
        if !passes_through {
            return sig.clone();
        }
        let mut state = self.state.borrow_mut();
        let name = state.unique(node.scope, &format!("{}_out", node.name));
        let id = state.push(Node { op: Op::Copy(sig.id()), name, ..node });
        drop(state);
        sig.at(id)
    }

    fn outer_copy(&self, sig: &Sig, inside: ScopeId) -> NodeId {
        let mut state = self.state.borrow_mut();
        if state.is_constant(sig.id()).is_some() {
            return sig.id();
        }
        let node = state.design.node(sig.id()).clone();
        assert_eq!(node.scope, inside, "unit output `{}` belongs to another unit", node.name);
        let name = format!("{}_{}", state.design.scope(inside).instance, node.name);
        let (scope, register, fraction_bits) = (state.scope, Register::None, sig.fraction_bits());
        let name = state.unique(scope, &name);
        let id = state.push(Node {
            op: Op::Copy(sig.id()),
            register,
            fraction_bits,
            scope,
            name,
            ..node
        });
        state.nameable(id);
        id
    }
}

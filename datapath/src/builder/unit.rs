//! Units: modules with ports, made from what crosses their border.
use std::collections::HashMap;

use super::error::BuildError;
use super::{Builder, Bundle, Inputs, Sig};
use crate::design::{NodeId, Op, Range, ScopeId};
use crate::graph::{GroupId, Pace, Rule, Unit, Value};
use crate::names::CONTROL;

impl Builder {
    /// Opens a unit called `name` that computes `formula`.
    ///
    /// Its inputs become ports of the same stage; what `body` returns becomes its outputs, again of
    /// one stage, so a unit has one latency. Constants go in and out without a port. Values of the
    /// outside that are no inputs cannot be used in it: that is a [`BuildError`].
    pub fn unit<I: Inputs, O: Bundle>(
        &self,
        name: &str,
        formula: &str,
        inputs: I,
        body: impl FnOnce(&Builder, I::Values) -> O,
    ) -> O {
        let mut entering = vec![];
        inputs.map(&mut |sig, _| {
            entering.push(sig.id());
            sig.clone()
        });
        let (outside, inside) = self.enter(name, formula, entering);
        let values = inputs.map(&mut |sig, port| self.port(sig, port, outside, inside));
        let results = body(self, values);
        self.leave(&results, outside, inside)
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
        let together = self.group_of(&results);
        results.map(&mut |sig, _| self.behind_a_register(&sig.taken_with(together)))
    }

    /// What `body` describes has no registers.
    pub(super) fn without_registers<R>(&self, body: impl FnOnce() -> R) -> R {
        let pace = std::mem::replace(&mut self.state.borrow_mut().pace, Pace::Wire);
        let results = body();
        self.state.borrow_mut().pace = pace;
        results
    }

    /// Where what is around works within one clock, no register is wanted here.
    fn behind_a_register(&self, sig: &Sig) -> Sig {
        if self.state.borrow().pace == Pace::Wire {
            return sig.clone();
        }
        sig.registered("registered", Rule::Same(sig.real()))
    }

    /// The values of a bundle, taken together.
    fn group_of<O: Bundle>(&self, bundle: &O) -> GroupId {
        let mut members = vec![];
        bundle.map(&mut |sig, _| {
            members.push(sig.id());
            sig.clone()
        });
        self.state.borrow_mut().group(members)
    }

    fn enter(&self, name: &str, formula: &str, entering: Vec<NodeId>) -> (ScopeId, ScopeId) {
        let mut state = self.state.borrow_mut();
        let outside = state.scope;
        let inside = ScopeId(state.graph.units.len() as u32);
        let called = state.instance.take();
        let instance = state.unique(outside, called.as_deref().unwrap_or(name));
        let begins = state.begins();
        let inputs = state.group(entering.into_iter().chain(begins));
        let unit = Unit {
            name: name.into(),
            formula: formula.into(),
            instance,
            parent: Some(outside),
            inputs,
            outputs: inputs,
        };
        state.graph.units.push(unit);
        // The names of every module's control ports.
        for taken in CONTROL {
            state.unique(inside, taken);
        }
        state.scope = inside;
        if let Some(begins) = begins {
            let name = state.unique(inside, "components_begin");
            let bit = (Range::new(0, 1), 0);
            let port = state.add(Op::Copy(begins), Pace::Wire, Some(inputs), bit, name);
            state.begin_turns(port);
        }
        (outside, inside)
    }

    /// The input `sig` as the unit sees it.
    fn port(&self, sig: &Sig, port: &str, outside: ScopeId, inside: ScopeId) -> Sig {
        let mut state = self.state.borrow_mut();
        if state.is_constant(sig.id()).is_some() {
            return sig.clone();
        }
        if state.graph.value(sig.id()).scope != outside {
            let (signal, unit) = (state.full_name(sig.id()), state.graph.path(inside).join("."));
            state.fail(BuildError::ForeignInput { port: port.into(), unit, signal });
        }
        let (name, inputs) = (state.unique(inside, port), state.graph.unit(inside).inputs);
        let shape = (state.graph.value(sig.id()).range, sig.fraction_bits());
        let id = state.add(Op::Copy(sig.id()), Pace::Wire, Some(inputs), shape, name);
        drop(state);
        sig.at(id)
    }

    fn leave<O: Bundle>(&self, results: &O, outside: ScopeId, inside: ScopeId) -> O {
        let outputs = self.group_of(results);
        let mut state = self.state.borrow_mut();
        // A unit takes no less than no time: outputs that are constants leave with the inputs.
        state.graph.units[inside.0 as usize].outputs = outputs;
        state.scope = outside;
        drop(state);
        let mut crossed: HashMap<NodeId, NodeId> = HashMap::new();
        results.map(&mut |sig, _| {
            let outer =
                *crossed.entry(sig.id()).or_insert_with(|| self.outer_copy(sig, outside, inside));
            sig.at(outer)
        })
    }

    /// An output of a unit as the unit around it sees it.
    fn outer_copy(&self, sig: &Sig, outside: ScopeId, inside: ScopeId) -> NodeId {
        let mut state = self.state.borrow_mut();
        if state.is_constant(sig.id()).is_some() {
            return sig.id();
        }
        let value: Value = state.graph.value(sig.id()).clone();
        if value.scope != inside {
            let (signal, unit) = (state.full_name(sig.id()), state.graph.path(inside).join("."));
            state.fail(BuildError::ForeignOutput { unit, signal });
        }
        let unit = state.graph.unit(inside);
        let (outputs, name) = (unit.outputs, format!("{}_{}", unit.instance, value.name));
        let name = state.unique(outside, &name);
        let shape = (value.range, sig.fraction_bits());
        let id = state.add(Op::Copy(sig.id()), Pace::Wire, Some(outputs), shape, name);
        state.nameable(id);
        id
    }
}

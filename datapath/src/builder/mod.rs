//! The datapath builder: what units are written with.
//!
//! A value is a [`Sig`]. Operators derive the result's format, proven range, error bound and stage
//! from the operands'; operands of different stages are aligned by delay registers that are put in
//! and shared here. No unit counts its own registers.
//!
//! A [`Sig`] is a signal *and* the real value that it stands for. Signals whose raw values are the
//! same are one signal in the hardware, whatever they stand for; so all that is known of errors
//! belongs to the real value, and folding, merging and leaving out hardware cannot lose it. What
//! rules mean for errors stands in one place: the pass [`bounds`](fn@crate::pass::bounds).
mod accumulate;
mod arithmetic;
mod error;
mod logic;
mod memory;
mod narrow;
mod ports;
mod recurrence;
mod sig;
mod state;
mod time_slots;
mod turns;
mod unit;
mod vector;

use std::cell::RefCell;
use std::rc::Rc;

use crate::{Hold, InputPort};

use crate::design::{Design, NodeId, Op, Range};
use crate::graph::{Graph, Pace, Rule};
use crate::pass::{Bounds, Pipelining, compile};

pub use error::BuildError;
pub use ports::{Bundle, Inputs};
pub use recurrence::LoopInvariant;
pub use sig::Sig;
pub use time_slots::TimeSlots;
pub use vector::Vector;

use state::{SignalInfo, State};

/// Builds a [`Design`], one operator at a time.
#[derive(Clone)]
pub struct Builder {
    state: Rc<RefCell<State>>,
}

/// The control inputs of a core.
///
/// A span may pause in any clock: `valid` is then low, data inputs stay what they are until the
/// span's last pixel has gone in, and `start` may be anything. What goes from pixel to pixel waits.
pub struct Control {
    /// A pixel enters.
    pub valid: Sig,
    /// It is the first of its span; read only where `valid` is high.
    pub start: Sig,
}

impl Builder {
    /// A builder for a core called `name` that computes `formula`.
    pub fn new(name: &str, formula: &str) -> Builder {
        Builder { state: Rc::new(RefCell::new(State::new(name, formula))) }
    }

    /// Opens the control inputs.
    pub fn control(&self) -> Control {
        let mut state = self.state.borrow_mut();
        let [valid, start] =
            ["valid", "start"].map(|name| state.open_input(name, Range::new(0, 1), 0));
        (state.graph.valid, state.graph.start, state.graph.steps) = (valid, start, valid);
        drop(state);
        Control { valid: self.sig(valid, Rule::Exact), start: self.sig(start, Rule::Exact) }
    }

    /// Opens a data input. Its host rounded it to nearest, so it is off by half a unit in the last
    /// place at most; integers are exact. A port that is given one value only becomes a constant,
    /// which is off like any other input, and one that is given what an earlier one is becomes
    /// that.
    pub fn input(&self, port: &InputPort) -> Sig {
        let rule = if port.format.fraction_bits > 0 {
            Rule::Input { error: 0.5 * port.format.ulp(), real: port.real }
        } else {
            Rule::Exact
        };
        if let Some(twin) = port.same_as.as_deref().and_then(|twin| self.opened(twin)) {
            let mut state = self.state.borrow_mut();
            let name = &state.graph.value(twin).name;
            let why = format!("it is always what `{name}` is");
            state.leave_out(&format!("input `{}`", port.name), &why);
            state.graph.inputs.push(None);
            drop(state);
            return self.sig(twin, rule);
        }
        let range = Range::new(port.range.0, port.range.1);
        let id = match range.only() {
            Some(value) => {
                let mut state = self.state.borrow_mut();
                state.leave_out(
                    &format!("input `{}`", port.name),
                    &format!("it is always {}", port.format.value(value)),
                );
                let id = state.constant(value, port.format.fraction_bits);
                state.graph.inputs.push(None);
                id
            }
            None => {
                let mut state = self.state.borrow_mut();
                let id = state.open_input(&port.name, range, port.format.fraction_bits);
                state.graph.values[id.0 as usize].still = port.hold == Hold::Frame;
                state.graph.inputs.push(Some(id));
                id
            }
        };
        self.sig(id, rule)
    }

    /// The data input of that name.
    fn opened(&self, name: &str) -> Option<NodeId> {
        let state = self.state.borrow();
        state
            .graph
            .inputs
            .iter()
            .flatten()
            .copied()
            .find(|&input| state.graph.value(input).name == name)
    }

    /// The integer `value`, exactly.
    pub fn integer(&self, value: i64) -> Sig {
        self.constant(value, 0, Rule::Exact)
    }

    /// Closes the design: `outputs` leave it together, and with them a bit that says whether a
    /// pixel leaves: `valid`, as late as they are.
    ///
    /// # Errors
    /// The first [`BuildError`] that was made.
    pub fn finish(self, valid: &Sig, outputs: &[(&str, Sig)]) -> Result<Design, BuildError> {
        Ok(compile(&self.graph(valid, outputs)?, &Pipelining::EachOperator)?)
    }

    /// What is known so far of everything that has been described.
    pub fn bounds(&self) -> Bounds {
        self.state.borrow().bounds.clone()
    }

    /// As [`Builder::finish`], but before any pass: a graph without clocks and registers. Values that
    /// were described are of no use afterwards.
    ///
    /// # Errors
    /// The first [`BuildError`] that was made.
    pub fn graph(self, valid: &Sig, outputs: &[(&str, Sig)]) -> Result<Graph, BuildError> {
        self.graph_beside(valid, outputs, &[])
    }

    /// As [`Builder::graph`], with more outputs `beside` those that the design's error is about.
    ///
    /// # Errors
    /// The first [`BuildError`] that was made.
    pub fn graph_beside(
        self,
        valid: &Sig,
        outputs: &[(&str, Sig)],
        beside: &[(&str, Sig)],
    ) -> Result<Graph, BuildError> {
        let mut state = self.state.borrow_mut();
        state.graph.leaves = valid.id();
        state.graph.measured_outputs = outputs.len();
        for (name, sig) in outputs.iter().chain(beside) {
            state.graph.outputs.push(((*name).to_owned(), sig.real()));
        }
        state.close()
    }

    /// Notes hardware that is not built, and why nothing is lost.
    pub fn leave_out(&self, what: &str, why: &str) {
        self.state.borrow_mut().leave_out(what, why);
    }

    /// The value `id`, which stands for a real value by this rule.
    fn sig(&self, id: NodeId, rule: Rule) -> Sig {
        let fraction_bits = self.state.borrow().graph.value(id).fraction_bits;
        Sig::new(self, (id, fraction_bits), rule)
    }

    /// The same raw value at every clock.
    fn constant(&self, value: i64, fraction_bits: u32, rule: Rule) -> Sig {
        let id = self.state.borrow_mut().constant(value, fraction_bits);
        self.sig(id, rule)
    }

    /// Adds an operator.
    fn emit(&self, op: Op, pace: Pace, info: SignalInfo, rule: Rule) -> Sig {
        let id = self.state.borrow_mut().emit(op, pace, info);
        self.sig(id, rule)
    }
}

//! A datapath without clocks: values, what computes them, and what has to be taken together.
//!
//! The [`Builder`](crate::Builder) makes it; the passes make a [`Design`](crate::Design) of it. A
//! value knows its operator, its range and its [`Pace`], and no stage: in which clock an operator
//! runs is for the schedule to say.
mod real;

use crate::design::{Assumption, LeftOut, NodeId, Op, Range, ScopeId, Table};

pub use real::{RealId, RealValue, RealVector, Rule, VectorId, VectorRule};

/// Values of which the readers take the same pixel's: their stage is that of the latest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct GroupId(pub u32);

/// How an operator is clocked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pace {
    /// It has the registers that the target wants behind it.
    Target,
    /// Its result is there within the clock of its operands.
    Wire,
    /// It has one register.
    Register,
    /// It is a register of a loop: what it reads belongs to the pixel before, and what it gives to
    /// the pixel of its group. It takes that over with a valid pixel only.
    Feedback,
    /// It is a register of a loop that is 0 for a pixel whose bit, the first operand of its choice,
    /// is 1: it is cleared a clock before. For the others it has what the pixel before gave.
    Cleared,
    /// It is a choice without a register that the adders which read it make themselves, for a target
    /// whose carry chains can clear a summand.
    Gate,
    /// It is no operator: what a register of a loop has a clock after its pixel, which belongs to
    /// that pixel then.
    After,
    /// It is a register that takes its value over with a valid pixel only, and holds it else.
    Held,
    /// It has no register, and what it gives is what a register that holds its value will have in
    /// the next clock.
    Ahead,
    /// It is a register that counts a pixel's time slots: one of a loop that takes over with every
    /// valid clock, also where other loops wait for a pixel's last slot.
    Slots,
    /// It is no operator: its operand, taken together with a group.
    Meet,
    /// It is a register, and what it gives counts as there in the clock of its operand: it belongs to
    /// the clock before, in which a component waits for its turn in a multiplier.
    Waiting,
}

/// A value of a [`Graph`].
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// What computes it. Operands come earlier in the graph, except those of loops.
    pub op: Op,
    /// How it is clocked.
    pub pace: Pace,
    /// The values that its operands are taken together with, besides each other.
    pub together: Option<GroupId>,
    /// Every raw value it takes; its width and sign follow from this.
    pub range: Range,
    /// Bits right of the binary point.
    pub fraction_bits: u32,
    /// Whether it is still, as [`Graph::is_still`] says.
    pub still: bool,
    /// The unit it belongs to.
    pub scope: ScopeId,
    /// Its name, unique in its unit.
    pub name: String,
    /// Whether the name was given; the others say what computes the value, with a number behind.
    pub named: bool,
}

/// A unit of a [`Graph`].
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// What it is, such as `reflect`.
    pub name: String,
    /// Its formula and source.
    pub formula: String,
    /// Name of this instance, unique in the unit around it.
    pub instance: String,
    /// The unit around it; `None` for the design itself.
    pub parent: Option<ScopeId>,
    /// What enters it.
    pub inputs: GroupId,
    /// What leaves it.
    pub outputs: GroupId,
}

/// A datapath without clocks.
#[derive(Clone, Debug, PartialEq)]
pub struct Graph {
    /// Every value.
    pub values: Vec<Value>,
    /// Every real value that one of them stands for.
    pub reals: Vec<RealValue>,
    /// Every vector of which something is known as a whole.
    pub vectors: Vec<RealVector>,
    /// Every group of values.
    pub groups: Vec<Vec<NodeId>>,
    /// Every read-only memory.
    pub tables: Vec<Table>,
    /// Every unit; parents come before children.
    pub units: Vec<Unit>,
    /// Data inputs in the order in which they were opened; `None` where one is constant or another.
    pub inputs: Vec<Option<NodeId>>,
    /// The bit that says a pixel enters.
    pub valid: NodeId,
    /// The bit that says that the pixel is the first of its span.
    pub start: NodeId,
    /// Clocks from one pixel to the next.
    pub interval: u32,
    /// Whether values belong to a pixel in the last of these clocks alone.
    pub last_slot_only: bool,
    /// The bit with which loops take over what comes: `valid`, or a pixel's last time slot.
    pub steps: NodeId,
    /// The bit that says, as the inputs do, that what enters leaves as a pixel.
    pub leaves: NodeId,
    /// What leaves: a name, and what stands for which real value.
    pub outputs: Vec<(String, RealId)>,
    /// Number of outputs, the first ones, that the design's error is about.
    pub measured_outputs: usize,
    /// SignalInfo to be checked.
    pub assumptions: Vec<Assumption>,
    /// What was left out.
    pub left_out: Vec<LeftOut>,
}

impl Graph {
    /// A graph without values, of a unit of this name; there is room for so many.
    pub(crate) fn new(name: &str, formula: &str, values: usize) -> Graph {
        let (none, nothing) = (NodeId(0), GroupId(0));
        let top = Unit {
            name: name.into(),
            formula: formula.into(),
            instance: name.into(),
            parent: None,
            inputs: nothing,
            outputs: nothing,
        };
        Graph {
            values: Vec::with_capacity(values),
            reals: Vec::with_capacity(values),
            vectors: vec![],
            groups: vec![vec![]],
            tables: vec![],
            units: vec![top],
            inputs: vec![],
            valid: none,
            start: none,
            interval: 1,
            last_slot_only: false,
            steps: none,
            leaves: none,
            outputs: vec![],
            measured_outputs: 0,
            assumptions: vec![],
            left_out: vec![],
        }
    }

    /// The value `id`.
    pub fn value(&self, id: NodeId) -> &Value {
        &self.values[id.0 as usize]
    }

    /// The real value `id`.
    pub fn real(&self, id: RealId) -> &RealValue {
        &self.reals[id.0 as usize]
    }

    /// The values that leave.
    pub fn leaving(&self) -> impl Iterator<Item = (&str, NodeId)> {
        self.outputs.iter().map(|(name, id)| (name.as_str(), self.real(*id).value))
    }

    /// The real values that the design's error is about.
    pub fn measured(&self) -> impl Iterator<Item = RealId> {
        self.outputs.iter().take(self.measured_outputs).map(|(_, id)| *id)
    }

    /// The unit `id`.
    pub fn unit(&self, id: ScopeId) -> &Unit {
        &self.units[id.0 as usize]
    }

    /// The members of a group.
    pub fn group(&self, id: GroupId) -> &[NodeId] {
        &self.groups[id.0 as usize]
    }

    /// Registers from a loop's value to that of the pixel before: a pixel's time slots have values of
    /// their own unless loops wait for the last of them.
    pub fn loop_registers(&self) -> u32 {
        if self.last_slot_only { 1 } else { self.interval }
    }

    /// Whether a value is one that a register keeps from pixel to pixel.
    pub fn is_state(&self, value: &Value) -> bool {
        matches!(value.pace, Pace::Feedback | Pace::Cleared | Pace::Held | Pace::Slots)
    }

    /// Whether a value is the same at every clock.
    pub fn is_constant(&self, id: NodeId) -> bool {
        self.value(id).op.constant().is_some()
    }

    /// Whether a value is *still*: the same for every pixel that is under way, so that it is there at
    /// any time. That is an input that holds for a frame, a constant, or what is computed of such
    /// values outside loops.
    pub fn is_still(&self, id: NodeId) -> bool {
        self.value(id).still
    }

    /// Whether an operator gives what is still, of values that are there already. Of an input its
    /// port says so.
    pub fn gives_still(&self, op: Op, pace: Pace) -> bool {
        let outside_loops = matches!(pace, Pace::Target | Pace::Wire | Pace::Register | Pace::Meet);
        // What comes later is of a loop.
        let is_still = |id: NodeId| self.values.get(id.0 as usize).is_some_and(|value| value.still);
        outside_loops && op != Op::Input && op.operands().all(is_still)
    }

    /// The unit whose border a value crosses on its way out, if it does: the value is then a copy
    /// of one of a unit inside its own.
    pub fn left_unit(&self, value: &Value) -> Option<ScopeId> {
        let Op::Copy(from) = value.op else { return None };
        let inside = self.value(from).scope;
        let crosses = value.pace == Pace::Wire && self.unit(inside).parent == Some(value.scope);
        crosses.then_some(inside)
    }

    /// Names of the units from the design down to `scope`.
    pub fn path(&self, scope: ScopeId) -> Vec<&str> {
        let mut path = vec![];
        let mut at = Some(scope);
        while let Some(id) = at {
            path.push(self.unit(id).instance.as_str());
            at = self.unit(id).parent;
        }
        path.reverse();
        path
    }
}

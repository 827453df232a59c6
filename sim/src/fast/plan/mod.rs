//! From a design to steps over columns.
mod allocate;
mod fused;
mod reach;
mod select;

use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, Table};
use specula_kernels::{Arithmetic, Bits, InstructionSet};

use super::flow::{Flow, Recurrence, Source};
use super::fuse::{Fusion, fuse};
use super::idle;
use super::memory::{Memory, Place, fits_narrow};
use super::schedule::{Group, groups, in_components, needed, skews};
use super::serial::{Accumulator, Holder, Member, Serial};
use super::settings::Settings;
use super::step::{Step, Work};

/// A signal that the caller wants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Watched {
    /// Its value at clock c stands in lane c - `shift`.
    Column {
        /// The column.
        place: Place,
        /// Clocks between lane and value.
        shift: u64,
    },
    /// It is always the same.
    Constant(i64),
}

/// The column of an input.
#[derive(Clone, Copy, Debug)]
pub struct InputPlace {
    /// The column.
    pub place: Place,
    /// Clocks by which it runs ahead: not 0 of inputs alone that hold over the whole run.
    pub ahead: u64,
}

/// What is done for a batch of clocks.
#[derive(Clone)]
pub struct Plan {
    /// The columns.
    pub memory: Memory,
    /// The columns of the core's inputs that are needed, by signal.
    pub inputs: HashMap<NodeId, InputPlace>,
    /// The steps, in order.
    pub steps: Vec<Step>,
    /// The wanted signals, in the caller's order.
    pub watched: Vec<Watched>,
    /// The smallest shift of a watched column: no clock is shown before that column has reached it.
    /// `None` if no column is watched.
    pub least_shift: Option<u64>,
    /// Clocks by which the column furthest ahead, or the value furthest behind its column, is so.
    pub lead: u64,
    /// Clocks before its own whose inputs a watched value depends on, up to the beginning of the
    /// span that enters then.
    pub reach: u64,
    /// Whether all feedback is accumulators that every span loads, and registers that hold what the
    /// last pixel had, so that a run may begin with any span.
    pub restarts_with_spans: bool,
}

/// Makes the plan for `watched` and stimuli of one frame or of `several_frames`.
pub fn plan(
    design: &Design,
    watched: &[NodeId],
    several_frames: bool,
    Settings { batch, instruction_set, .. }: Settings,
) -> Plan {
    let mut flow = Flow::of(design);
    let (roots, in_component) = without_hidden_feedback(design, &mut flow, watched);
    let mut overflowing = idle::overflowing(design);
    // Time slots before a pixel's last are no pixel's either.
    if several_frames || design.last_slot_only {
        overflowing.extend(idle::overflowing_between_frames(design));
    }
    let alone = |id| in_component.contains(&id);
    let fusion = fuse(design, &mut flow, (&roots, watched), &alone, overflowing);
    // What has been fused into another is no root any more.
    let order = groups(design, &flow, &needed(design, &flow, watched));
    let skews = skews(design, &flow, &order, several_frames);
    let mut planner = Planner {
        design,
        flow: &flow,
        fusion: &fusion,
        skews: &skews,
        instruction_set,
        batch,
        memory: Memory::default(),
        places: HashMap::new(),
        constants: HashMap::new(),
        steps: vec![],
        tables: design.tables.clone().into(),
    };
    planner.allocate(&order, watched);
    for group in &order {
        planner.plan_group(group);
    }
    let watched_nodes = watched;
    let watched: Vec<Watched> = watched_nodes.iter().map(|&id| planner.watch(id)).collect();
    let shift = |watched: &Watched| {
        if let Watched::Column { shift, .. } = watched { Some(*shift) } else { None }
    };
    let least_shift = watched.iter().filter_map(shift).min();
    let inputs = planner
        .places
        .iter()
        .filter(|(id, _)| design.node(**id).op == Op::Input)
        .map(|(&id, &place)| (id, InputPlace { place, ahead: skews[&id] }))
        .collect();
    let reach = planner.reach(&order, watched_nodes);
    let restarts_with_spans = planner.restarts_with_spans(&order);
    // The first rows of a signal behind registers lie that many lanes back.
    let lead = skews
        .values()
        .copied()
        .chain(watched_nodes.iter().map(|&id| planner.shift(id)))
        .max()
        .unwrap_or(0);
    Plan {
        memory: planner.memory,
        inputs,
        steps: planner.steps,
        watched,
        least_shift,
        lead,
        reach,
        restarts_with_spans,
    }
}

/// The roots that are needed, and those of them that stand in components. A recurrence that feeds
/// back on others too becomes part of a component like any other signal.
fn without_hidden_feedback(
    design: &Design,
    flow: &mut Flow,
    watched: &[NodeId],
) -> (Vec<NodeId>, HashSet<NodeId>) {
    loop {
        let roots = needed(design, flow, watched);
        let in_component = in_components(&groups(design, flow, &roots));
        if !flow.drop_recurrences(&in_component) {
            return (roots, in_component);
        }
    }
}

struct Planner<'a> {
    design: &'a Design,
    flow: &'a Flow,
    fusion: &'a Fusion,
    skews: &'a HashMap<NodeId, u64>,
    instruction_set: InstructionSet,
    batch: usize,
    memory: Memory,
    places: HashMap<NodeId, Place>,
    constants: HashMap<(i64, bool), Place>,
    steps: Vec<Step>,
    tables: Arc<[Table]>,
}

impl Planner<'_> {
    fn node(&self, id: NodeId) -> &Node {
        self.design.node(id)
    }

    fn is_wide(&self, root: NodeId) -> bool {
        !fits_narrow(self.node(self.fusion.stored(root)).range)
    }

    fn shift(&self, id: NodeId) -> u64 {
        self.shift_of(self.flow.source(id))
    }

    fn shift_of(&self, source: Source) -> u64 {
        self.skews.get(&source.root).copied().unwrap_or(0) + u64::from(source.delay)
    }

    /// Clocks that a reader of skew `skew` looks back into the column of `operand`.
    fn back(&self, operand: Source, skew: u64) -> usize {
        // A group's skew is the smallest of its operands' shifts, so this is not negative.
        (self.shift_of(operand) - skew) as usize
    }

    fn watch(&mut self, id: NodeId) -> Watched {
        let root = self.flow.source(id).root;
        match self.node(root).op {
            Op::Constant(value) => Watched::Constant(value),
            _ => Watched::Column { place: self.places[&root], shift: self.shift(id) },
        }
    }

    fn plan_group(&mut self, group: &Group) {
        match group {
            Group::Column(root) => self.plan_root(*root),
            Group::Component(members) => self.plan_component(members),
        }
    }

    fn plan_root(&mut self, root: NodeId) {
        let node = self.node(root).clone();
        let skew = self.skews[&root];
        let out = self.places[&root];
        if let Some(recurrence) = self.flow.recurrences[root.0 as usize] {
            let work = self.recurrence(root, recurrence, skew);
            self.steps.push(Step { out, skew: Some(skew), work });
            return;
        }
        if let Some(fused) = self.flow.fused.get(&root) {
            let work = self.fused(root, fused);
            self.steps.push(Step { out, skew: Some(skew), work });
            return;
        }
        let post = self.fusion.post(root);
        let work = match node.op {
            Op::Input | Op::Constant(_) => return,
            Op::Copy(a) | Op::ShiftRight(a, _) | Op::Wrap(a) => {
                Some(self.arithmetic(Arithmetic::Copy, root, a, a, post))
            }
            Op::Add(a, b) => Some(self.arithmetic(Arithmetic::Add, root, a, b, post)),
            Op::Sub(a, b) => Some(self.arithmetic(Arithmetic::Sub, root, a, b, post)),
            Op::Mul(a, b) => Some(self.product(root, a, b, post)),
            Op::LessThan(a, b) => self.less_than(root, a, b),
            Op::Select(c, a, b) => self.select(root, c, a, b),
            Op::And(a, b) => self.bitwise(Bits::And, root, a, b),
            Op::Or(a, b) => self.bitwise(Bits::Or, root, a, b),
            Op::ShiftLeft(..) | Op::Not(_) => self.by_constant(root, node.op),
            Op::LookUp(address, table) => self.look_up(root, address, table),
        };
        match work {
            Some(work) => self.steps.push(Step { out, skew: Some(skew), work }),
            // Nothing of this kind comes from the builder; what does is evaluated clock by clock,
            // which is always right.
            None => self.plan_component(&[root]),
        }
    }

    /// The work of the recurrence that computes `root`.
    fn recurrence(&mut self, root: NodeId, recurrence: Recurrence, skew: u64) -> Work {
        let shape = |id: NodeId| (self.node(id).width(), self.node(id).range.signed());
        match recurrence {
            Recurrence::Accumulate { valid, first, start, step, state, registers } => {
                let (width, signed) = shape(state);
                Work::Serial(Serial::Accumulate(Accumulator {
                    valid: self.read(valid, skew),
                    first: self.read(first, skew),
                    start: self.read(start, skew),
                    step: self.read(step, skew),
                    width,
                    signed,
                    states: vec![0; registers],
                }))
            }
            Recurrence::Hold { enable, value } => {
                let (width, signed) = shape(root);
                Work::Serial(Serial::Hold(Holder {
                    enable: self.read(enable, skew),
                    value: self.read(value, skew),
                    width,
                    signed,
                    state: 0,
                }))
            }
        }
    }

    fn plan_component(&mut self, members: &[NodeId]) {
        let skew = self.skews[&members[0]];
        let member = |this: &mut Self, id: NodeId| {
            let node = this.node(id).clone();
            let mut reads = vec![];
            let op = node.op.map(|operand| {
                reads.push(operand);
                NodeId(reads.len() as u32 - 1)
            });
            let reads = reads.into_iter().map(|operand| this.read(operand, skew)).collect();
            let tables = this.tables.clone();
            Member {
                out: this.places[&id],
                op,
                reads,
                width: node.width(),
                signed: node.range.signed(),
                tables,
            }
        };
        let members: Vec<Member> = members.iter().map(|&id| member(self, id)).collect();
        let out = members[0].out;
        self.steps.push(Step { out, skew: Some(skew), work: Work::Component(members) });
    }
}

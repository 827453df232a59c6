//! Stages in which every path between registers meets a clock, with the fewest register bits.
//!
//! Each value has a variable a(v), the stage at which its operands are taken, and is there at
//! s(v) = a(v) + clocks(v). A value that is read m clocks later than it is there has m registers,
//! which all its readers share:
//!
//! ```text
//! a(reader) >= s(operand)
//! a(to)     >= s(from) + 1                       where the path between them takes too long
//! minimise     sum of width(v) (latest(v) - s(v))   with latest(v) >= a(reader)
//! ```
//!
//! What is still stands outside of that: it has a register behind each of its operators.
//!
//! [XLS and Vivado HLS schedule in this way: Cong and Zhang 2006, systems of difference
//! constraints.]
use super::Schedule;
use super::difference::{Differences, Solution, Variable};
use super::paths::{Paths, TooLong};
use crate::design::{NodeId, Op};
use crate::graph::{Graph, Pace, Value};
use crate::target::Target;

/// The schedule for a clock of so many MHz. Loops are in one clock whatever it is, as are operators
/// that take longer: which clock the result allows, the analysis of its paths says.
pub fn schedule(graph: &Graph, target: &Target, mhz: f64) -> Schedule {
    let Some(fabric) = &target.fabric else { return super::each_operator::schedule(graph) };
    let paths = Paths::new(graph, target, fabric, 1000.0 / mhz);
    let mut programme = Programme::new(graph, &paths);
    programme.separate_long_paths();
    programme.weigh();
    // Without the distances between long paths every graph has a schedule, and those that loops
    // contradict are left out.
    let solution = programme.differences.solution().expect("a graph without contradictions");
    programme.scheduled(&solution)
}

/// A path that no schedule can cut: through a single operator, or through a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncut {
    /// The value that it begins at.
    pub from: NodeId,
    /// The value that it ends at; the same of a single operator.
    pub to: NodeId,
    /// Whether it is part of a loop.
    pub in_loop: bool,
    /// Nanoseconds from register to register.
    pub delay: f64,
}

/// The longest path that no schedule can cut; none where no delays of the target are known.
pub fn longest(graph: &Graph, target: &Target, mhz: f64) -> Option<Uncut> {
    let fabric = target.fabric.as_ref()?;
    let paths = Paths::new(graph, target, fabric, 1000.0 / mhz);
    let programme = Programme::new(graph, &paths);
    let tied = programme.tied();
    let mut in_loops = paths.too_long(&tied);
    in_loops.retain(|path| tied(path.from, path.to));
    let in_loops = in_loops.into_iter().map(|path| {
        let TooLong { from, to, delay, .. } = path;
        Uncut { from, to, in_loop: true, delay }
    });
    let operator = paths.longest_operator();
    let operator = operator.map(|(id, delay)| Uncut { from: id, to: id, in_loop: false, delay });
    in_loops.chain(operator).max_by(|one, other| one.delay.total_cmp(&other.delay))
}

/// The linear programme of a graph.
struct Programme<'a> {
    graph: &'a Graph,
    paths: &'a Paths<'a>,
    differences: Differences,
    /// The stage 0.
    entry: Variable,
    /// The stage at which each value's operands are taken.
    taken: Vec<Variable>,
    groups: Vec<Variable>,
    last: Variable,
}

impl<'a> Programme<'a> {
    fn new(graph: &'a Graph, paths: &'a Paths<'a>) -> Programme<'a> {
        let mut differences = Differences::default();
        let entry = differences.variable();
        let groups: Vec<Variable> = graph.groups.iter().map(|_| differences.variable()).collect();
        let taken = graph.values.iter().map(|value| match (value.op, value.together) {
            (Op::Input, _) => entry,
            // Nothing depends on it.
            _ if value.still => entry,
            (_, Some(group)) => groups[group.0 as usize],
            (_, None) => differences.variable(),
        });
        let taken = taken.collect();
        let last = differences.variable();
        let mut programme = Programme { graph, paths, differences, entry, taken, groups, last };
        programme.order();
        programme
    }

    fn value(&self, id: NodeId) -> &'a Value {
        self.graph.value(id)
    }

    fn values(&self) -> impl Iterator<Item = (NodeId, &'a Value)> + use<'a> {
        self.graph.values.iter().zip(0..).map(|(value, index)| (NodeId(index), value))
    }

    fn taken(&self, id: NodeId) -> Variable {
        self.taken[id.0 as usize]
    }

    /// Clocks from a value's operands to the value.
    fn clocks(&self, value: &Value) -> i64 {
        match value.pace {
            Pace::Held | Pace::Ahead | Pace::After => 1,
            Pace::Target => self.paths.block_registers(value).into(),
            Pace::Wire | Pace::Gate | Pace::Meet | Pace::Register => 0,
            Pace::Feedback | Pace::Cleared | Pace::Slots | Pace::Waiting => 0,
        }
    }

    /// Asks that a value be there at a stage, so many clocks after it is at the earliest.
    fn there(&mut self, id: NodeId, stage: Variable, later: i64) {
        if !self.graph.is_still(id) {
            let clocks = self.clocks(self.value(id));
            self.differences.at_least(stage, self.taken(id), clocks + later);
        }
    }

    /// Operands before operators, members of a group before what is taken with it.
    fn order(&mut self) {
        for (members, number) in self.graph.groups.iter().zip(0..) {
            let group = self.groups[number];
            self.differences.at_least(group, self.entry, 0);
            members.iter().for_each(|&member| self.there(member, group, 0));
        }
        for (id, value) in self.values().filter(|(_, value)| !value.still) {
            self.differences.at_least(self.taken(id), self.entry, 0);
            if value.together.is_none()
                || matches!(value.pace, Pace::Feedback | Pace::Cleared | Pace::Slots)
            {
                for operand in value.op.operands() {
                    self.there(operand, self.taken(id), clears(value, operand).into());
                }
            }
        }
        let leaving: Vec<NodeId> = self.graph.leaving().map(|(_, id)| id).collect();
        self.differences.at_least(self.last, self.entry, 1);
        for id in leaving {
            let behind_register = self.graph.is_state(self.value(id));
            self.there(id, self.last, i64::from(!behind_register));
        }
    }

    /// Whether two values are in the one clock of a loop.
    fn tied(&self) -> impl Fn(NodeId, NodeId) -> bool + use<> {
        let sets = self.differences.tied();
        let taken = self.taken.clone();
        move |from, to| {
            let [from, to] = [from, to].map(|id| taken[id.0 as usize].index());
            from == to || sets[from].is_some() && sets[from] == sets[to]
        }
    }

    fn separate_long_paths(&mut self) {
        let tied = self.tied();
        let mut paths = self.paths.too_long(&tied);
        paths.retain(|path| !tied(path.from, path.to));
        for path in paths {
            let stage = self.taken(path.to);
            self.there(path.from, stage, 1 + i64::from(path.clocks));
        }
    }

    /// Weighs each value's registers by its width.
    fn weigh(&mut self) {
        for (id, value) in self.values() {
            if value.still {
                continue;
            }
            let width = i64::from(value.range.width());
            let read_at =
                |&reader: &NodeId| (self.taken(reader), -i64::from(clears(self.value(reader), id)));
            let mut stages: Vec<(Variable, i64)> =
                self.paths.readers(id).iter().map(read_at).collect();
            if self.graph.leaving().any(|(_, leaving)| leaving == id) {
                stages.push((self.last, 0));
            }
            if stages.is_empty() {
                continue;
            }
            let latest = match stages[..] {
                [(one, 0)] => one,
                _ => self.differences.variable(),
            };
            self.there(id, latest, 0);
            for (stage, gap) in stages.into_iter().filter(|&(stage, _)| stage != latest) {
                self.differences.at_least(latest, stage, gap);
            }
            self.differences.weigh(latest, width);
            self.differences.weigh(self.taken(id), -width);
        }
    }

    fn scheduled(&self, solution: &Solution) -> Schedule {
        let entry = solution.of(self.entry);
        let stage = |variable| (solution.of(variable) - entry) as u32;
        let mut taken: Vec<u32> = self.taken.iter().map(|&variable| stage(variable)).collect();
        let mut schedule = Schedule {
            groups: self.groups.iter().map(|&group| stage(group)).collect(),
            last: stage(self.last),
            ..Schedule::default()
        };
        for (id, value) in self.values() {
            if value.still {
                taken[id.0 as usize] = schedule.settled(value);
                self.settle(id, taken[id.0 as usize], &mut schedule);
                continue;
            }
            let own = taken[id.0 as usize];
            let there = own + self.clocks(value) as u32;
            let read_at = |reader: &NodeId| {
                taken[reader.0 as usize] - u32::from(clears(self.value(*reader), id))
            };
            // A register takes an operator's result at once where all who read it do so later.
            let late = self.paths.readers(id).iter().all(|reader| read_at(reader) > there);
            let is_alias = matches!(value.pace, Pace::Ahead | Pace::After);
            let merges = !self.is_port(value) && !is_alias && late;
            let (stage, registers) = match value.pace {
                Pace::Held => (there, 1),
                Pace::Feedback | Pace::Cleared | Pace::Slots | Pace::Waiting => (there, 1),
                _ if there > own && value.pace == Pace::Target => (there, there - own),
                _ if matches!(value.op, Op::Input | Op::Constant(_)) || !merges => (there, 0),
                _ => (there + 1, 1),
            };
            schedule.stages.push(stage);
            schedule.registers.push(registers);
            schedule.in_block.push(self.paths.in_block(value));
        }
        schedule.taken = taken;
        schedule
    }

    /// Adds a still value, whose operands have settled at a stage, with the registers of its operator.
    fn settle(&self, id: NodeId, settled: u32, schedule: &mut Schedule) {
        let value = self.value(id);
        let registers = match value.pace {
            Pace::Target if self.paths.in_block(value) => self.paths.block_registers(value),
            Pace::Target => super::each_operator::registers_after(&value.op),
            Pace::Register => 1,
            _ => 0,
        };
        schedule.stages.push(settled + registers);
        schedule.registers.push(registers);
        schedule.in_block.push(self.paths.in_block(value));
    }

    /// Whether a value crosses the border of a unit, as a wire.
    fn is_port(&self, value: &Value) -> bool {
        match value.op {
            Op::Copy(from) => self.value(from).scope != value.scope || value.pace == Pace::Meet,
            _ => false,
        }
    }
}

/// Whether a value reads an operand a clock before the others, to be cleared by it.
fn clears(value: &Value, operand: NodeId) -> bool {
    matches!(value.op, Op::Select(bit, ..) if value.pace == Pace::Cleared && bit == operand)
}

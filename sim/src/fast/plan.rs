//! From a design to steps over columns.
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use specula_hdl::Design;
use specula_hdl::design::{Node, NodeId, Op, Range, Table, TableId};
use specula_kernels::{
    Arithmetic, Bits, Level, Post, Shift, Wrap, bits, choose, less_than, narrow, narrow_through_wide, narrowing, wide, widening,
};

use super::flow::{Flow, Recurrence, raw_range};
use super::fuse::{Fusion, fuse};
use super::memory::{Memory, Place};
use super::schedule::{Group, Needed, groups, skews};
use super::step::{Accumulator, Holder, Member, Read, Step, Work};

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

/// What is done for a batch of clocks.
#[derive(Clone)]
pub struct Plan {
    /// The columns.
    pub memory: Memory,
    /// The columns of the core's inputs that are needed, by signal.
    pub inputs: HashMap<NodeId, Place>,
    /// The steps, in order.
    pub steps: Vec<Step>,
    /// The wanted signals, in the caller's order.
    pub watched: Vec<Watched>,
    /// Clocks by which the column furthest ahead is ahead.
    pub lead: u64,
    /// Clocks before its own whose inputs a watched value depends on, up to the beginning of the span that enters then.
    pub reach: u64,
    /// Whether all feedback is accumulators that every span loads, so that a run may begin with any span.
    pub restarts_with_spans: bool,
}

const NARROW: Range = Range::new(i32::MIN as i64, i32::MAX as i64);

fn fits_narrow(range: Range) -> bool {
    NARROW.low <= range.low && range.high <= NARROW.high
}

/// Makes the plan for `watched`, with batches of `batch` clocks.
pub fn plan(design: &Design, watched: &[NodeId], batch: usize, level: Level) -> Plan {
    let mut flow = Flow::of(design);
    let all = Needed::of(design, &flow, watched);
    let fusion = fuse(design, &mut flow, &all.roots, watched, &|id| all.in_component.contains(&id));
    let needed = Needed::of(design, &flow, watched);
    let order = groups(design, &flow, &needed.roots);
    let skews = skews(design, &flow, &order);
    let mut planner = Planner {
        design,
        flow: &flow,
        fusion: &fusion,
        skews: &skews,
        level,
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
    let watched = watched_nodes.iter().map(|&id| planner.watch(id)).collect();
    let inputs =
        planner.places.iter().filter(|(id, _)| design.node(**id).op == Op::Input).map(|(&id, &place)| (id, place)).collect();
    let reach = planner.reach(&order, watched_nodes);
    let restarts_with_spans = planner.restarts_with_spans(&order);
    let lead = skews.values().copied().max().unwrap_or(0);
    Plan { memory: planner.memory, inputs, steps: planner.steps, watched, lead, reach, restarts_with_spans }
}

struct Planner<'a> {
    design: &'a Design,
    flow: &'a Flow,
    fusion: &'a Fusion,
    skews: &'a HashMap<NodeId, u64>,
    level: Level,
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
        let source = self.flow.source(id);
        self.skews.get(&source.root).copied().unwrap_or(0) + u64::from(source.delay)
    }

    /// Clocks that a reader of skew `skew` looks back into the column of `operand`.
    fn back(&self, operand: NodeId, skew: u64) -> usize {
        // A group's skew is the smallest of its operands' shifts, so this is not negative.
        (self.shift(operand) - skew) as usize
    }

    /// Gives every root a column; those that are read in their own lane only, and not watched, share memory.
    fn allocate(&mut self, order: &[Group], watched: &[NodeId]) {
        let (history, last_use) = self.uses(order, watched);
        let lasting: HashSet<NodeId> = watched.iter().map(|&w| self.flow.source(w).root).collect();
        let mut free: [Vec<Place>; 2] = [vec![], vec![]];
        let mut ending: HashMap<usize, Vec<NodeId>> = HashMap::new();
        for (&root, &group) in &last_use {
            ending.entry(group).or_default().push(root);
        }
        for (number, group) in order.iter().enumerate() {
            for &root in group.members() {
                let keeps = history.get(&root).copied().unwrap_or(0);
                let shared = self.may_share(root, group, keeps, &lasting);
                let wide = self.is_wide(root);
                let reused = if shared { free[usize::from(wide)].pop() } else { None };
                let place = reused.unwrap_or_else(|| self.memory.add(wide, keeps, self.batch));
                self.places.insert(root, place);
            }
            let mut ended = ending.remove(&number).unwrap_or_default();
            ended.sort_unstable();
            for root in ended {
                let keeps = history.get(&root).copied().unwrap_or(0);
                let column = Group::Column(root);
                let holder = order.iter().find(|g| g.members().contains(&root)).unwrap_or(&column);
                if self.may_share(root, holder, keeps, &lasting) {
                    let place = self.places[&root];
                    free[usize::from(place.wide)].push(place);
                }
            }
        }
    }

    fn may_share(&self, root: NodeId, group: &Group, history: usize, lasting: &HashSet<NodeId>) -> bool {
        let plain = matches!(group, Group::Column(_)) && self.node(root).op != Op::Input;
        plain && history == 0 && !lasting.contains(&root)
    }

    /// For each root, the clocks that readers look back, and the last group that reads it.
    fn uses(&self, order: &[Group], watched: &[NodeId]) -> (HashMap<NodeId, usize>, HashMap<NodeId, usize>) {
        let mut history: HashMap<NodeId, usize> = HashMap::new();
        let mut last_use = HashMap::new();
        for (number, group) in order.iter().enumerate() {
            for &member in group.members() {
                let skew = self.skews[&member];
                for operand in self.flow.operands(self.design, member) {
                    let root = self.flow.source(operand).root;
                    if self.skews.contains_key(&root) {
                        let keeps = history.entry(root).or_default();
                        *keeps = (*keeps).max(self.back(operand, skew));
                        last_use.insert(root, number);
                    }
                }
            }
        }
        let earliest = watched.iter().map(|&w| self.shift(w)).min().unwrap_or(0);
        for &id in watched {
            let keeps = history.entry(self.flow.source(id).root).or_default();
            *keeps = (*keeps).max((self.shift(id) - earliest) as usize);
        }
        (history, last_use)
    }

    /// How far back the inputs lie that the watched values depend on.
    fn reach(&self, order: &[Group], watched: &[NodeId]) -> u64 {
        let mut reaches: HashMap<NodeId, u64> = HashMap::new();
        let reach_of = |reaches: &HashMap<NodeId, u64>, id: NodeId| reaches.get(&self.flow.source(id).root).copied().unwrap_or(0);
        for group in order {
            for &member in group.members() {
                let skew = self.skews[&member];
                let variable = |o: &NodeId| self.skews.contains_key(&self.flow.source(*o).root);
                let operands = self.flow.operands(self.design, member).into_iter().filter(variable);
                let reach = operands.map(|o| reach_of(&reaches, o) + self.back(o, skew) as u64).max().unwrap_or(0);
                reaches.insert(member, reach);
            }
        }
        watched.iter().map(|&id| self.shift(id) + reach_of(&reaches, id)).max().unwrap_or(0)
    }

    fn restarts_with_spans(&self, order: &[Group]) -> bool {
        order.iter().all(|group| match group {
            Group::Component(_) => false,
            Group::Column(root) => match self.flow.recurrences[root.0 as usize] {
                None => true,
                Some(Recurrence::Accumulate { first, .. }) => self.flow.source(first).root == self.design.start,
                Some(Recurrence::Hold { .. }) => false,
            },
        })
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
            let work = self.recurrence(recurrence, skew);
            self.steps.push(Step { out, skew: Some(skew), work });
            return;
        }
        let post = self.fusion.post(root);
        let work = match node.op {
            Op::Input | Op::Constant(_) => return,
            Op::Copy(a) | Op::ShiftRight(a, _) | Op::Wrap(a) => self.arithmetic(Arithmetic::Copy, root, a, a, post),
            Op::Add(a, b) => self.arithmetic(Arithmetic::Add, root, a, b, post),
            Op::Sub(a, b) => self.arithmetic(Arithmetic::Sub, root, a, b, post),
            Op::Mul(a, b) => self.arithmetic(Arithmetic::Mul, root, a, b, post),
            Op::LessThan(a, b) => Some(self.less_than(a, b, skew)),
            Op::Select(c, a, b) => self.select(root, c, a, b),
            Op::And(a, b) => self.bitwise(Bits::And, root, a, b),
            Op::Or(a, b) => self.bitwise(Bits::Or, root, a, b),
            Op::ShiftLeft(..) | Op::Not(_) => self.by_constant(root, node.op),
            Op::LookUp(address, table) => self.look_up(root, address, table),
        };
        match work {
            Some(work) => self.steps.push(Step { out, skew: Some(skew), work }),
            // Nothing of this kind comes from the builder; what does is evaluated clock by clock, which is always right.
            None => self.plan_component(&[root]),
        }
    }

    fn look_up(&mut self, root: NodeId, address: NodeId, table: TableId) -> Option<Work> {
        let address = self.read(address, self.skews[&root]);
        let entries = self.design.tables.get(table.0 as usize)?.entries.clone();
        (!address.place.wide && self.stays_within(root)).then(|| Work::LookUp(entries.into(), address))
    }

    /// Operators with a constant operand that they do not name.
    fn by_constant(&mut self, root: NodeId, op: Op) -> Option<Work> {
        let skew = self.skews[&root];
        let post = self.fusion.post(root);
        match op {
            Op::Not(a) => {
                let one = self.constant(1, false);
                let a = self.read(a, skew);
                (!a.place.wide).then(|| Work::Narrow(narrow(Arithmetic::Sub, post, self.level), one, a))
            }
            Op::ShiftLeft(a, bits) if bits < 62 => {
                let a = self.read(a, skew);
                let out_wide = self.places[&root].wide;
                let factor = self.constant(1 << bits, a.place.wide || bits > 30);
                match (a.place.wide, factor.place.wide, out_wide) {
                    (false, false, false) => Some(Work::Narrow(narrow(Arithmetic::Mul, post, self.level), a, factor)),
                    (false, false, true) => Some(Work::Widening(widening(Arithmetic::Mul, post, self.level), a, factor)),
                    (_, _, true) => {
                        let a = self.widened(a);
                        Some(Work::Wide(wide(Arithmetic::Mul, post, self.level), a, factor))
                    }
                    (_, _, false) => None,
                }
            }
            _ => None,
        }
    }

    fn recurrence(&mut self, recurrence: Recurrence, skew: u64) -> Work {
        match recurrence {
            Recurrence::Accumulate { first, start, step, state } => {
                let range = self.node(state).range;
                let (width, signed) = (range.width(), range.signed());
                let (first, start, step) = (self.read(first, skew), self.read(start, skew), self.read(step, skew));
                Work::Accumulate(Accumulator { first, start, step, width, signed, state: 0 })
            }
            Recurrence::Hold { enable, value } => {
                Work::Hold(Holder { enable: self.read(enable, skew), value: self.read(value, skew), state: 0 })
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
            Member { out: this.places[&id], op, reads, width: node.width(), signed: node.range.signed(), tables }
        };
        let members: Vec<Member> = members.iter().map(|&id| member(self, id)).collect();
        let out = members[0].out;
        self.steps.push(Step { out, skew: Some(skew), work: Work::Component(members) });
    }

    fn constant(&mut self, value: i64, wide: bool) -> Read {
        let batch = self.batch;
        let memory = &mut self.memory;
        let place = *self.constants.entry((value, wide)).or_insert_with(|| {
            let place = memory.add(wide, 0, batch);
            memory.fill(place, 0, batch, value);
            place
        });
        Read { place, back: 0 }
    }

    /// An operand as a reader of skew `skew` sees it.
    fn read(&mut self, operand: NodeId, skew: u64) -> Read {
        let root = self.flow.source(operand).root;
        match self.node(root).op {
            Op::Constant(value) => self.constant(value, !fits_narrow(Range::single(value))),
            _ => Read { place: self.places[&root], back: self.back(operand, skew) },
        }
    }

    /// The same operand with lanes of 64 bits.
    fn widened(&mut self, read: Read) -> Read {
        if read.place.wide {
            return read;
        }
        if let Some((&(value, _), _)) = self.constants.iter().find(|(_, place)| **place == read.place) {
            return self.constant(value, true);
        }
        // Columns that share memory change owners, so a copy serves one reader only; it keeps the original's history.
        let history = self.memory.history(read.place);
        let twin = self.memory.add(true, history, self.batch);
        let source = Read { place: read.place, back: 0 };
        let work = Work::Widening(widening(Arithmetic::Copy, Post::default(), self.level), source, source);
        self.steps.push(Step { out: twin, skew: None, work });
        Read { place: twin, back: read.back }
    }

    fn arithmetic(&mut self, operator: Arithmetic, root: NodeId, a: NodeId, b: NodeId, post: Post) -> Option<Work> {
        let skew = self.skews[&root];
        let raw = raw_range(self.design, raw_operator(self.node(root).op)).narrow().ok()?;
        let post = self.checked_post(root, raw, post)?;
        let (a, b) = (self.read(a, skew), self.read(b, skew));
        let (wide_operands, wide_result) = (a.place.wide || b.place.wide, self.places[&root].wide);
        // Rounding adds 1 to the raw result, so it must not be at the lane's end.
        let narrow_compute = fits_narrow(Range::new(raw.low, raw.high.saturating_add(1)));
        let level = self.level;
        Some(match (wide_operands, narrow_compute, wide_result) {
            (false, true, false) => Work::Narrow(narrow(operator, post, level), a, b),
            (false, false, false) => Work::Narrow(narrow_through_wide(operator, post, level), a, b),
            (false, _, true) => Work::Widening(widening(operator, post, level), a, b),
            (true, _, false) => {
                let (a, b) = (self.widened(a), self.widened(b));
                Work::Narrowing(narrowing(operator, post, level), a, b)
            }
            (true, _, true) => {
                let (a, b) = (self.widened(a), self.widened(b));
                Work::Wide(wide(operator, post, level), a, b)
            }
        })
    }

    /// The post-operation, with the wrapping that the signal's width asks for where its range does not hold every raw result.
    fn checked_post(&self, root: NodeId, raw: Range, post: Post) -> Option<Post> {
        let own = self.node(root).range;
        let contained = own.low <= raw.low && raw.high <= own.high;
        let plain = matches!(self.node(root).op, Op::Add(..) | Op::Sub(..) | Op::Mul(..));
        match (contained || !plain, post == Post::default()) {
            (true, _) => Some(post),
            (false, true) if own.signed() => Some(Post { shift: Shift::None, wrap: Wrap::Signed(own.width()) }),
            (false, true) => Some(Post { shift: Shift::None, wrap: Wrap::Unsigned(own.width()) }),
            (false, false) => None,
        }
    }

    fn less_than(&mut self, a: NodeId, b: NodeId, skew: u64) -> Work {
        let (a, b) = (self.read(a, skew), self.read(b, skew));
        if a.place.wide || b.place.wide {
            let (a, b) = (self.widened(a), self.widened(b));
            return Work::Narrowing(less_than::<i64>(self.level), a, b);
        }
        Work::Narrow(less_than::<i32>(self.level), a, b)
    }

    /// Whether an operator that has no post-operation stays within its signal's range.
    fn stays_within(&self, root: NodeId) -> bool {
        let own = self.node(root).range;
        raw_range(self.design, self.node(root).op).narrow().is_ok_and(|raw| own.low <= raw.low && raw.high <= own.high)
    }

    fn select(&mut self, root: NodeId, c: NodeId, a: NodeId, b: NodeId) -> Option<Work> {
        let skew = self.skews[&root];
        let (c, a, b) = (self.read(c, skew), self.read(a, skew), self.read(b, skew));
        if c.place.wide || !self.stays_within(root) {
            return None;
        }
        if self.places[&root].wide {
            let (a, b) = (self.widened(a), self.widened(b));
            return Some(Work::ChooseWide(choose::<i64>(self.level), c, a, b));
        }
        (!a.place.wide && !b.place.wide).then(|| Work::ChooseNarrow(choose::<i32>(self.level), c, a, b))
    }

    fn bitwise(&mut self, operator: Bits, root: NodeId, a: NodeId, b: NodeId) -> Option<Work> {
        let skew = self.skews[&root];
        let (a, b) = (self.read(a, skew), self.read(b, skew));
        let own = self.node(root).range;
        // Bits of operands as wide as the result, in the same sign, need no wrapping.
        if [a, b].iter().any(|r| r.place.wide) != self.places[&root].wide
            || own != Range::whole(own.width(), false) && !self.stays_within(root)
        {
            return None;
        }
        if self.places[&root].wide {
            let (a, b) = (self.widened(a), self.widened(b));
            return Some(Work::Wide(bits::<i64>(operator, self.level), a, b));
        }
        Some(Work::Narrow(bits::<i32>(operator, self.level), a, b))
    }
}

/// The operator whose raw result a kernel computes before its post-operation.
fn raw_operator(op: Op) -> Op {
    match op {
        Op::ShiftRight(a, _) | Op::Wrap(a) => Op::Copy(a),
        op => op,
    }
}

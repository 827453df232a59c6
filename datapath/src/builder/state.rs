//! The graph while it grows.
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};

use super::error::BuildError;
use crate::design::{LeftOut, NodeId, Op, Range, ScopeId, WideRange};
use crate::graph::{
    Graph, GroupId, Pace, RealId, RealValue, RealVector, Rule, Value, VectorId, VectorRule,
};
use crate::names::{CONTROL, unique};
use crate::pass::Bounds;
use crate::pass::fold::{Folded, folded};

/// What is known of a new value besides its operator.
#[derive(Clone, Copy)]
pub(super) struct SignalInfo {
    pub range: WideRange,
    pub fraction_bits: u32,
    /// What to call it until it gets a name.
    pub kind: &'static str,
}

pub(super) struct State {
    pub graph: Graph,
    /// What is known of its real values.
    pub bounds: Bounds,
    /// The unit that operators are added to.
    pub scope: ScopeId,
    /// How operators are clocked that are added now.
    pub pace: Pace,
    names: FxHashSet<(ScopeId, String)>,
    /// Values whose name is a stand-in: their kind and a number, or, without those here, the port of
    /// the unit they come from.
    unnamed: FxHashMap<NodeId, Option<(&'static str, u32)>>,
    /// The first number of each kind that may be free in a unit.
    numbers: FxHashMap<(ScopeId, &'static str), u32>,
    /// What computes which value, so that nothing is built twice in a unit.
    computed: FxHashMap<(ScopeId, Op, Pace), NodeId>,
    /// Values that are taken together with a group already.
    met: FxHashMap<(NodeId, GroupId), NodeId>,
    /// The bit that begins the turns of components, as each unit sees it.
    begins: FxHashMap<ScopeId, NodeId>,
    /// What the next unit's instance is to be called, if not after the unit.
    pub instance: Option<String>,
    fault: Option<BuildError>,
}

/// Room for the values of most cores: what grows is copied, and searches for formats describe hundreds
/// of cores.
const MANY_VALUES: usize = 4096;

fn with_room<K, V>() -> FxHashMap<K, V> {
    FxHashMap::with_capacity_and_hasher(MANY_VALUES, FxBuildHasher)
}

impl State {
    pub fn new(name: &str, formula: &str) -> State {
        // A signal of the module's own name would hide the module.
        let taken = CONTROL.into_iter().chain([name]);
        let mut names = FxHashSet::with_capacity_and_hasher(MANY_VALUES, FxBuildHasher);
        names.extend(taken.map(|taken| (ScopeId::TOP, taken.to_owned())));
        State {
            graph: Graph::new(name, formula, MANY_VALUES),
            bounds: Bounds::default(),
            scope: ScopeId::TOP,
            pace: Pace::Target,
            names,
            unnamed: with_room(),
            numbers: FxHashMap::default(),
            computed: with_room(),
            met: with_room(),
            begins: FxHashMap::default(),
            instance: None,
            fault: None,
        }
    }

    pub fn is_constant(&self, id: NodeId) -> Option<i64> {
        self.graph.value(id).op.constant()
    }

    pub fn leave_out(&mut self, what: &str, why: &str) {
        let unit = self.graph.path(self.scope).join(".");
        self.graph.left_out.push(LeftOut { unit, what: what.into(), why: why.into() });
    }

    /// Notes a mistake in using the builder; the first one is what building ends with.
    pub fn fail(&mut self, fault: BuildError) {
        self.fault.get_or_insert(fault);
    }

    /// A value's name with the units around it.
    pub fn full_name(&self, id: NodeId) -> String {
        let value = self.graph.value(id);
        format!("{}.{}", self.graph.path(value.scope).join("."), value.name)
    }

    pub fn constant(&mut self, value: i64, fraction_bits: u32) -> NodeId {
        let (op, range, pace) = (Op::Constant(value), Range::single(value), Pace::Wire);
        self.add(op, pace, None, (range, fraction_bits), String::new())
    }

    pub fn open_input(&mut self, name: &str, range: Range, fraction_bits: u32) -> NodeId {
        let name = self.unique(self.scope, name);
        self.add(Op::Input, Pace::Wire, None, (range, fraction_bits), name)
    }

    /// Adds an operator, or gives the value whose raw values are the same anyway: what it folds to,
    /// or its twin. That value may stand for another real one, so errors belong to the
    /// [`RealValue`] that it stands for. Operands are in this unit.
    pub fn emit(&mut self, op: Op, pace: Pace, info: SignalInfo) -> NodeId {
        if let Some(id) = self.folded(op, &info) {
            return id;
        }
        let key = (self.scope, op, pace);
        if let Some(&same) = self.computed.get(&key).filter(|&&same| self.agrees(same, &info)) {
            return same;
        }
        let (name, number) = self.numbered(info.kind);
        let range = self.fitted(info.range, &name);
        let id = self.add(op, pace, None, (range, info.fraction_bits), name);
        self.unnamed.insert(id, Some((info.kind, number)));
        self.computed.insert(key, id);
        id
    }

    /// The value that takes an operator's place, where one does; what that saves is noted.
    fn folded(&mut self, op: Op, info: &SignalInfo) -> Option<NodeId> {
        let range = info.range.narrow().ok();
        let (folded, saved) = folded(&self.graph, op, range, info.fraction_bits)?;
        if let Some(saved) = saved {
            self.leave_out(&saved.what, &saved.why);
        }
        Some(match folded {
            Folded::Constant(value) => self.constant(value, info.fraction_bits),
            Folded::ShiftLeft(factor, bits) => {
                self.emit(Op::ShiftLeft(factor, bits), Pace::Wire, *info)
            }
            Folded::Same(id) => id,
        })
    }

    fn agrees(&self, id: NodeId, info: &SignalInfo) -> bool {
        let value = self.graph.value(id);
        info.range.narrow() == Ok(value.range) && value.fraction_bits == info.fraction_bits
    }

    /// Notes what a value stands for.
    pub fn real(&mut self, value: NodeId, fraction_bits: u32, rule: Rule) -> RealId {
        let real = RealValue { value, fraction_bits, rule };
        self.bounds.add(&self.graph, &real);
        self.graph.reals.push(real);
        RealId(self.graph.reals.len() as u32 - 1)
    }

    /// Notes what is known of a vector as a whole.
    pub fn vector(&mut self, components: [RealId; 3], rule: VectorRule) -> VectorId {
        let vector = RealVector { components, rule };
        self.bounds.add_vector(&self.graph, &vector);
        self.graph.vectors.push(vector);
        VectorId(self.graph.vectors.len() as u32 - 1)
    }

    /// A group of values that are taken together.
    pub fn group(&mut self, members: impl IntoIterator<Item = NodeId>) -> GroupId {
        self.graph.groups.push(members.into_iter().collect());
        GroupId(self.graph.groups.len() as u32 - 1)
    }

    /// A value as it is where all of a group are there.
    pub fn meet(&mut self, id: NodeId, group: GroupId) -> NodeId {
        if self.is_constant(id).is_some() {
            return id;
        }
        if let Some(&met) = self.met.get(&(id, group)) {
            return met;
        }
        let value = self.graph.value(id).clone();
        let (op, pace, together) = (Op::Copy(id), Pace::Meet, Some(group));
        let met = self.push(Value { op, pace, together, ..value });
        self.met.insert((id, group), met);
        met
    }

    /// The bit that begins the turns of components as the unit that is open sees it; none where they
    /// do not take turns.
    pub fn begins(&self) -> Option<NodeId> {
        self.begins.get(&self.scope).copied()
    }

    /// Lets the unit that is open, and those in it, see the bit that begins the turns of components.
    pub fn begin_turns(&mut self, begins: NodeId) {
        self.begins.insert(self.scope, begins);
    }

    /// A value so many clocks later, for its turn; what is still waits for nothing. In the clock that
    /// it counts as there in, it is whatever was there before: anything that it has bits for.
    pub fn waiting(&mut self, id: NodeId, clocks: u32) -> NodeId {
        if self.graph.is_still(id) {
            return id;
        }
        let Value { range, fraction_bits, .. } = *self.graph.value(id);
        let range = Range::whole(range.width(), range.signed()).into();
        let info = SignalInfo { range, fraction_bits, kind: "waiting" };
        (0..clocks).fold(id, |before, _| self.emit(Op::Copy(before), Pace::Waiting, info))
    }

    /// Lets a later name take the place of the one the value has.
    pub fn nameable(&mut self, id: NodeId) {
        self.unnamed.insert(id, None);
    }

    /// Gives a value a name if it has none yet.
    pub fn name(&mut self, id: NodeId, name: &str) {
        let Some(stand_in) = self.unnamed.remove(&id) else { return };
        let value = &mut self.graph.values[id.0 as usize];
        let (scope, old) = (value.scope, std::mem::take(&mut value.name));
        self.names.remove(&(scope, old));
        if let Some((kind, number)) = stand_in {
            let first = self.numbers.entry((scope, kind)).or_insert(number);
            *first = number.min(*first);
        }
        self.graph.values[id.0 as usize].name = self.unique(scope, name);
    }

    /// `name`, or with a number behind it where the unit has it already.
    pub fn unique(&mut self, scope: ScopeId, name: &str) -> String {
        unique(&mut self.names, scope, name)
    }

    /// The kind with the first number behind it that is free in the unit that is open.
    fn numbered(&mut self, kind: &'static str) -> (String, u32) {
        let mut number = self.numbers.get(&(self.scope, kind)).copied().unwrap_or(1);
        let name = loop {
            let candidate = format!("{kind}_{number}");
            if self.names.insert((self.scope, candidate.clone())) {
                break candidate;
            }
            number += 1;
        };
        self.numbers.insert((self.scope, kind), number + 1);
        (name, number)
    }

    /// The range, or (noting the fault) a stand-in for one that does not fit 63 bits.
    fn fitted(&mut self, range: WideRange, name: &str) -> Range {
        range.narrow().unwrap_or_else(|width| {
            let signal = format!("{}.{name}", self.graph.path(self.scope).join("."));
            self.fail(BuildError::SignalTooWide { signal, width });
            Range::new(0, 1)
        })
    }

    /// Adds a value to the unit that is open.
    pub fn add(
        &mut self,
        op: Op,
        pace: Pace,
        together: Option<GroupId>,
        (range, fraction_bits): (Range, u32),
        name: String,
    ) -> NodeId {
        let (scope, still) = (self.scope, self.graph.gives_still(op, pace));
        let named = true;
        self.push(Value { op, pace, together, range, fraction_bits, still, scope, name, named })
    }

    /// Adds a value, which counts as named until something else is said of it.
    pub fn push(&mut self, value: Value) -> NodeId {
        self.graph.values.push(Value { named: true, ..value });
        NodeId(self.graph.values.len() as u32 - 1)
    }

    /// The whole graph, of which nothing is left here.
    pub fn close(&mut self) -> Result<Graph, BuildError> {
        if let Some(fault) = self.fault.take() {
            return Err(fault);
        }
        let mut graph = std::mem::replace(&mut self.graph, Graph::new("", "", 0));
        for NodeId(index) in self.unnamed.keys() {
            graph.values[*index as usize].named = false;
        }
        Ok(graph)
    }
}

//! Tables, and registers that hold their value.
use super::Sig;
use super::error::BuildError;
use super::state::SignalInfo;
use crate::design::{NodeId, Op, Range, Table, TableId};
use crate::format::power_of_two;
use crate::graph::{GroupId, Pace, Rule};

impl Sig {
    /// The entry of a table at this address, an unsigned integer; `entries` are raw values with
    /// `fraction_bits`, each off by no more than `error` units of the last place. An address behind
    /// the last entry reads 0.
    pub fn looked_up(&self, entries: Vec<i64>, fraction_bits: u32, error: f64) -> Sig {
        if self.range().low < 0 {
            let mut state = self.builder.state.borrow_mut();
            let signal = state.full_name(self.id());
            state.fail(BuildError::NegativeAddress { signal });
        }
        let beyond = self.range().high >= entries.len() as i64;
        let values = entries.iter().copied().chain(beyond.then_some(0));
        let single = |value: i64| Range::single(value);
        let range = values.map(single).reduce(Range::hull).unwrap_or(single(0));
        let table = self.builder.add_table(entries);
        let shape = (range.plus(single(0)), fraction_bits);
        let rule = Rule::Table { error: error * power_of_two(-i64::from(fraction_bits)) };
        Sig::operator([self], |[address]| Op::LookUp(address, table), shape, ("entry", rule))
    }

    /// A register that takes this value over while `enable` is 1 and holds what it has while it
    /// is 0, or no pixel is there. Like all registers of data it has no reset, so it must be enabled
    /// before it is read.
    pub fn held(&self, enable: &Sig) -> Sig {
        let together = self.builder.group([self, enable]);
        let [value, enable] = [self, enable].map(|sig| sig.taken_with(together));
        let range = value.range().hull(Range::single(0));
        let id = self.builder.own_register(range, self.fraction_bits(), together, |own| {
            Op::Select(enable.id(), value.id(), own)
        });
        self.at(id)
    }

    /// A register that takes over `loaded` while `load` is 1, else this value while `enable` is 1,
    /// and else holds what it has, as it does where no pixel is there. It has no reset, so it must
    /// be enabled or loaded before it is read.
    pub fn held_or_loaded(&self, enable: &Sig, load: &Sig, loaded: &Sig) -> Sig {
        let fraction_bits = self.fraction_bits().max(loaded.fraction_bits());
        let (value, loaded) =
            (self.with_fraction_bits(fraction_bits), loaded.with_fraction_bits(fraction_bits));
        let together = self.builder.group([&value, &loaded, enable, load]);
        let [value, loaded, enable, load] =
            [&value, &loaded, enable, load].map(|sig| sig.taken_with(together));
        let range = value.range().hull(loaded.range()).hull(Range::single(0));
        let rule = Rule::Choice(value.real(), loaded.real());
        let builder = &self.builder;
        // The register is placed before the multiplexers that read it, and its operand is set when
        // they are there.
        let state = builder.own_register(range, fraction_bits, together, Op::Copy);
        let ahead = |op, kind| {
            let info = SignalInfo { range: range.into(), fraction_bits, kind };
            builder.ahead(op, together, info)
        };
        let kept = ahead(Op::Select(enable.id(), value.id(), state), "kept");
        let next = ahead(Op::Select(load.id(), loaded.id(), kept), "next");
        builder.state.borrow_mut().graph.values[state.0 as usize].op = Op::Copy(next);
        Sig::new(builder, (state, fraction_bits), rule)
    }
}

impl super::Builder {
    fn add_table(&self, entries: Vec<i64>) -> TableId {
        let tables = &mut self.state.borrow_mut().graph.tables;
        tables.push(Table { entries });
        TableId(tables.len() as u32 - 1)
    }

    /// A register whose operand may be itself.
    fn own_register(
        &self,
        range: Range,
        fraction_bits: u32,
        together: GroupId,
        op: impl Fn(NodeId) -> Op,
    ) -> NodeId {
        let mut state = self.state.borrow_mut();
        let (scope, own) = (state.scope, NodeId(state.graph.values.len() as u32));
        let name = state.unique(scope, "held");
        let shape = (range, fraction_bits);
        let id = state.add(op(own), Pace::Held, Some(together), shape, name);
        state.nameable(id);
        id
    }

    /// What a register that holds its value will have in the next clock, unless it is loaded.
    fn ahead(&self, op: Op, together: GroupId, info: SignalInfo) -> NodeId {
        let mut state = self.state.borrow_mut();
        let id = state.emit(op, Pace::Ahead, info);
        state.graph.values[id.0 as usize].together = Some(together);
        id
    }
}

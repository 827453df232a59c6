//! Tables, and registers that hold their value.
use super::Sig;
use super::state::Facts;
use crate::design::{Node, NodeId, Op, Range, Register, Table, TableId};

impl Sig {
    /// The entry of a table at this address, an unsigned integer; `entries` are raw values with
    /// `fraction_bits`, each off by no more than `error` units of the last place. An address behind
    /// the last entry reads 0.
    pub fn looked_up(&self, entries: Vec<i64>, fraction_bits: u32, error: f64) -> Sig {
        assert!(self.range().low >= 0, "an address is unsigned");
        let beyond = self.range().high >= entries.len() as i64;
        let values = entries.iter().copied().chain(beyond.then_some(0));
        let single = |value: i64| Range::single(value);
        let range = values.map(single).reduce(Range::hull).unwrap_or(single(0));
        let table = self.builder.add_table(entries);
        let facts = (range.plus(single(0)), fraction_bits, error);
        Sig::operator([self], |[address]| Op::LookUp(address, table), facts, "entry")
    }

    /// A register that takes this value over while `enable` is 1 and holds what it has while it
    /// is 0. Like all registers of data it has no reset, so it must be enabled before it is read.
    pub fn held(&self, enable: &Sig) -> Sig {
        let stage = self.stage().max(enable.stage());
        let (value, enable) = (self.aligned(stage), enable.aligned(stage));
        let range = value.range().hull(Range::single(0));
        self.builder.own_register(range, (self.fraction_bits(), self.error()), stage + 1, |own| {
            Op::Select(enable.id(), value.id(), own)
        })
    }

    /// A register that takes over `loaded` while `load` is 1, else this value while `enable` is 1,
    /// and else holds what it has. It has no reset, so it must be enabled or loaded before it is
    /// read.
    pub fn held_or_loaded(&self, enable: &Sig, load: &Sig, loaded: &Sig) -> Sig {
        let fraction_bits = self.fraction_bits().max(loaded.fraction_bits());
        let (value, loaded) =
            (self.with_fraction_bits(fraction_bits), loaded.with_fraction_bits(fraction_bits));
        let stage = [&value, &loaded, enable, load].map(Sig::stage).into_iter().max().unwrap_or(0);
        let [value, loaded, enable, load] =
            [&value, &loaded, enable, load].map(|sig| sig.aligned(stage));
        let range = value.range().hull(loaded.range()).hull(Range::single(0));
        let error = value.error().max(loaded.error());
        let builder = &self.builder;
        // The register is placed before the multiplexer that reads it, and its operand is set when
        // that is there.
        let state = builder.own_register(range, (fraction_bits, error), stage + 1, Op::Copy);
        let facts = Facts { range: range.into(), fraction_bits, error, kind: "kept" };
        let kept =
            builder.emit(Op::Select(enable.id(), value.id(), state.id()), Register::None, facts);
        builder.state.borrow_mut().design.nodes[state.id().0 as usize].op =
            Op::Select(load.id(), loaded.id(), kept.id());
        state
    }
}

impl super::Builder {
    fn add_table(&self, entries: Vec<i64>) -> TableId {
        let tables = &mut self.state.borrow_mut().design.tables;
        tables.push(Table { entries });
        TableId(tables.len() as u32 - 1)
    }

    /// A register whose operand may be itself.
    fn own_register(
        &self,
        range: Range,
        (fraction_bits, error): (u32, f64),
        stage: u32,
        op: impl Fn(NodeId) -> Op,
    ) -> Sig {
        let id = {
            let mut state = self.state.borrow_mut();
            let (scope, own) = (state.scope, NodeId(state.design.nodes.len() as u32));
            let name = state.unique(scope, "held");
            let id = state.push(Node {
                op: op(own),
                register: Register::Data,
                range,
                fraction_bits,
                stage,
                scope,
                name,
                named: true,
            });
            state.nameable(id);
            id
        };
        self.sig(id, error)
    }
}

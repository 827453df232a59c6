//! The kernel for an operator: which lanes it reads, computes and writes.
use specula_datapath::design::{NodeId, Op, Range, TableId};
use specula_kernels::{
    Arithmetic, Bits, Post, bits, choose, less_than, narrow, narrow_through_wide, narrowing, wide,
    widening,
};

use super::Planner;
use super::fused::computes_narrow;
use crate::fast::flow::raw_range;
use crate::fast::memory::fits_narrow;
use crate::fast::read::Read;
use crate::fast::serial::Serial;
use crate::fast::step::{Step, Work};

impl Planner<'_> {
    pub(super) fn constant(&mut self, value: i64, wide: bool) -> Read {
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
    pub(super) fn read(&mut self, operand: NodeId, skew: u64) -> Read {
        let source = self.flow.source(operand);
        match self.node(source.root).op {
            Op::Constant(value) => self.constant(value, !fits_narrow(Range::single(value))),
            _ => Read { place: self.places[&source.root], back: self.back(source, skew) },
        }
    }

    /// The same operand with lanes of 64 bits.
    fn widened(&mut self, read: Read) -> Read {
        if read.place.wide {
            return read;
        }
        if let Some((&(value, _), _)) =
            self.constants.iter().find(|(_, place)| **place == read.place)
        {
            return self.constant(value, true);
        }
        // Columns that share memory change owners, so a copy serves one reader only; it keeps the
        // original's history.
        let history = self.memory.history(read.place);
        let twin = self.memory.add(true, history, self.batch);
        let source = Read { place: read.place, back: 0 };
        let work = Work::Widening(
            widening(Arithmetic::Copy, Post::default(), self.instruction_set),
            source,
            source,
        );
        self.steps.push(Step { out: twin, skew: None, work });
        Read { place: twin, back: read.back }
    }

    /// The kernel of an arithmetic operator. A signal's range is proven, so its raw result needs no
    /// wrapping.
    pub(super) fn arithmetic(
        &mut self,
        operator: Arithmetic,
        root: NodeId,
        a: NodeId,
        b: NodeId,
        post: Post,
    ) -> Work {
        let skew = self.skews[&root];
        // Where operands depend on each other, the signal's own range may be narrower than what
        // theirs give.
        let raw = raw_range(self.design, raw_operator(self.node(root).op))
            .narrow()
            .unwrap_or(self.node(root).range);
        let (a, b) = (self.read(a, skew), self.read(b, skew));
        let (wide_operands, wide_result) = (a.place.wide || b.place.wide, self.places[&root].wide);
        let narrow_compute = computes_narrow(raw, post);
        let instruction_set = self.instruction_set;
        match (wide_operands, narrow_compute, wide_result) {
            (false, true, false) => Work::Narrow(narrow(operator, post, instruction_set), a, b),
            (false, false, false) => {
                Work::Narrow(narrow_through_wide(operator, post, instruction_set), a, b)
            }
            (false, _, true) => Work::Widening(widening(operator, post, instruction_set), a, b),
            (true, _, false) => {
                let (a, b) = (self.widened(a), self.widened(b));
                Work::Narrowing(narrowing(operator, post, instruction_set), a, b)
            }
            (true, _, true) => {
                let (a, b) = (self.widened(a), self.widened(b));
                Work::Wide(wide(operator, post, instruction_set), a, b)
            }
        }
    }

    pub(super) fn less_than(&mut self, root: NodeId, a: NodeId, b: NodeId) -> Option<Work> {
        let skew = self.skews[&root];
        let (a, b) = (self.read(a, skew), self.read(b, skew));
        if self.places[&root].wide {
            return None;
        }
        if a.place.wide || b.place.wide {
            let (a, b) = (self.widened(a), self.widened(b));
            return Some(Work::Narrowing(less_than::<i64>(self.instruction_set), a, b));
        }
        Some(Work::Narrow(less_than::<i32>(self.instruction_set), a, b))
    }

    /// Whether an operator that has no post-operation stays within its signal's range.
    fn stays_within(&self, root: NodeId) -> bool {
        let own = self.node(root).range;
        raw_range(self.design, self.node(root).op)
            .narrow()
            .is_ok_and(|raw| own.low <= raw.low && raw.high <= own.high)
    }

    pub(super) fn select(&mut self, root: NodeId, c: NodeId, a: NodeId, b: NodeId) -> Option<Work> {
        let skew = self.skews[&root];
        let (c, a, b) = (self.read(c, skew), self.read(a, skew), self.read(b, skew));
        if c.place.wide || !self.stays_within(root) {
            return None;
        }
        if self.places[&root].wide {
            let (a, b) = (self.widened(a), self.widened(b));
            return Some(Work::ChooseWide(choose::<i64>(self.instruction_set), c, a, b));
        }
        (!a.place.wide && !b.place.wide)
            .then(|| Work::ChooseNarrow(choose::<i32>(self.instruction_set), c, a, b))
    }

    pub(super) fn bitwise(
        &mut self,
        operator: Bits,
        root: NodeId,
        a: NodeId,
        b: NodeId,
    ) -> Option<Work> {
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
            return Some(Work::Wide(bits::<i64>(operator, self.instruction_set), a, b));
        }
        Some(Work::Narrow(bits::<i32>(operator, self.instruction_set), a, b))
    }

    pub(super) fn look_up(
        &mut self,
        root: NodeId,
        address: NodeId,
        table: TableId,
    ) -> Option<Work> {
        let address = self.read(address, self.skews[&root]);
        let entries = self.design.tables.get(table.0 as usize)?.entries.clone();
        (!address.place.wide && self.stays_within(root))
            .then(|| Work::Serial(Serial::LookUp(entries.into(), address)))
    }

    /// Operators with a constant operand that they do not name.
    pub(super) fn by_constant(&mut self, root: NodeId, op: Op) -> Option<Work> {
        let skew = self.skews[&root];
        let post = self.fusion.post(root);
        match op {
            Op::Not(a) => {
                let one = self.constant(1, false);
                let a = self.read(a, skew);
                (!a.place.wide && !self.places[&root].wide).then(|| {
                    Work::Narrow(narrow(Arithmetic::Sub, post, self.instruction_set), one, a)
                })
            }
            Op::ShiftLeft(a, bits) if bits < 62 => {
                let a = self.read(a, skew);
                let out_wide = self.places[&root].wide;
                let factor = self.constant(1 << bits, a.place.wide || bits > 30);
                match (a.place.wide, factor.place.wide, out_wide) {
                    (false, false, false) => Some(Work::Narrow(
                        narrow(Arithmetic::Mul, post, self.instruction_set),
                        a,
                        factor,
                    )),
                    (false, false, true) => Some(Work::Widening(
                        widening(Arithmetic::Mul, post, self.instruction_set),
                        a,
                        factor,
                    )),
                    (_, _, true) => {
                        let a = self.widened(a);
                        Some(Work::Wide(
                            wide(Arithmetic::Mul, post, self.instruction_set),
                            a,
                            factor,
                        ))
                    }
                    (_, _, false) => None,
                }
            }
            _ => None,
        }
    }
}

/// The operator whose raw result a kernel computes before its post-operation.
fn raw_operator(op: Op) -> Op {
    match op {
        Op::ShiftRight(a, _) | Op::Wrap(a) => Op::Copy(a),
        op => op,
    }
}

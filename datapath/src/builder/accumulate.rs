//! The usual feedback: a value that grows by a step with each pixel of a span.
use super::state::Facts;
use super::{Builder, Sig};
use crate::design::{Node, NodeId, Op, Range, Register};

impl Sig {
    /// `start` at the first pixel of a span (where `first` is 1), and from then on `step` more with
    /// each pixel.
    ///
    /// The unit assumes by `fact` that the value stays from `low` to `high` while the span lasts;
    /// behind its last pixel the register may wrap, and the next span loads it anew. With errors e
    /// of start and step it is off by e_start + i e_step at pixel i, so by e_start + `steps` ·
    /// e_step at most.
    pub fn accumulated(
        first: &Sig,
        start: &Sig,
        step: &Sig,
        (low, high): (f64, f64),
        steps: u32,
        fact: &str,
    ) -> Sig {
        let fraction_bits = start.fraction_bits().max(step.fraction_bits());
        let (start, step) =
            (start.with_fraction_bits(fraction_bits), step.with_fraction_bits(fraction_bits));
        let error = start.error() + f64::from(steps) * step.error();
        if step.range() == Range::single(0) {
            return start.never_growing(error);
        }
        let builder = first.builder.clone();
        let stage = [first, &start, &step].map(Sig::stage).into_iter().max().unwrap_or(0);
        let (first, start, step) =
            (first.aligned(stage), start.aligned(stage), step.aligned(stage));

        let raw = |value: f64| value / start.ulp();
        let assumed =
            Range::new(raw(low).floor() as i64, raw(high).ceil() as i64).hull(start.range());
        let whole = Range::whole(assumed.width(), assumed.signed());
        let state = builder.feedback_register(whole, fraction_bits, stage);
        let facts = |range: Range, kind| Facts { range: range.into(), fraction_bits, error, kind };
        let select = Op::Select(first.id(), start.id(), builder.kept_for_a_pixel(state));
        let value = builder.emit(select, Register::None, facts(whole.hull(start.range()), "value"));
        let next_range = Facts { range: value.range().plus(step.range()), ..facts(whole, "next") };
        let next = builder.emit(Op::Add(value.id(), step.id()), Register::None, next_range);
        builder.state.borrow_mut().design.nodes[state.0 as usize].op = Op::Wrap(next.id());
        let value = value.assumed(low, high, fact);
        builder.emit(Op::Copy(value.id()), Register::Data, facts(value.range(), "accumulated"))
    }

    /// `start` and the `term` of every clock since `first` was 1, this one included.
    ///
    /// By `fact` that stays from `low` to `high` while the pixel lasts. With errors e of start and
    /// term it is off by e_start + n e_term after n terms, so by e_start + `most` · e_term at most.
    pub fn summed(
        first: &Sig,
        start: &Sig,
        term: &Sig,
        (low, high): (f64, f64),
        most: u32,
        fact: &str,
    ) -> Sig {
        let fraction_bits = start.fraction_bits().max(term.fraction_bits());
        let (start, term) =
            (start.with_fraction_bits(fraction_bits), term.with_fraction_bits(fraction_bits));
        let builder = first.builder.clone();
        let stage = [first, &start, &term].map(Sig::stage).into_iter().max().unwrap_or(0);
        let (first, start, term) =
            (first.aligned(stage), start.aligned(stage), term.aligned(stage));
        let error = start.error() + f64::from(most) * term.error();

        let raw = |value: f64| value / start.ulp();
        let stated = Range::new(raw(low).floor() as i64, raw(high).ceil() as i64);
        let whole = Range::whole(stated.width(), stated.signed());
        let state = builder.feedback_register(whole, fraction_bits, stage);
        let select = Op::Select(first.id(), start.id(), state);
        let facts = |range: Range, kind| Facts { range: range.into(), fraction_bits, error, kind };
        let before =
            builder.emit(select, Register::None, facts(whole.hull(start.range()), "before"));
        let range = before.range().plus(term.range());
        let sum = builder.emit(
            Op::Add(before.id(), term.id()),
            Register::None,
            Facts { range, ..facts(whole, "sum") },
        );
        builder.state.borrow_mut().design.nodes[state.0 as usize].op = Op::Wrap(sum.id());
        let sum = sum.assumed(low, high, fact);
        builder.emit(Op::Copy(sum.id()), Register::Data, facts(sum.range(), "summed"))
    }

    /// What starts here and never changes: inputs are held while their span goes in, so no register
    /// need keep it. A step of 0 may be one that the host rounded to 0, so `error` is that of any
    /// accumulated value.
    fn never_growing(&self, error: f64) -> Sig {
        self.builder.leave_out(
            &format!("accumulator {} bits", self.range().width()),
            "its step is always 0",
        );
        let facts = Facts {
            range: self.range().into(),
            fraction_bits: self.fraction_bits(),
            error,
            kind: "accumulated",
        };
        self.builder.emit(Op::Copy(self.id()), Register::Data, facts)
    }
}

impl Builder {
    /// A feedback register's value of the pixel before, where pixels take several clocks.
    pub(super) fn kept_for_a_pixel(&self, register: NodeId) -> NodeId {
        let mut state = self.state.borrow_mut();
        (1..state.design.interval).fold(register, |before, _| {
            let node = state.design.node(before).clone();
            let name = state.unique(node.scope, "state");
            state.push(Node { op: Op::Copy(before), name, ..node })
        })
    }

    /// A register whose operand comes later. Until then it reads itself.
    pub(super) fn feedback_register(&self, range: Range, fraction_bits: u32, stage: u32) -> NodeId {
        let mut state = self.state.borrow_mut();
        let (scope, own) = (state.scope, NodeId(state.design.nodes.len() as u32));
        let name = state.unique(scope, "state");
        let (op, register) = (Op::Copy(own), Register::Data);
        state.push(Node { op, register, range, fraction_bits, stage, scope, name, named: true })
    }
}

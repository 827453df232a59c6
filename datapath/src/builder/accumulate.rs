//! The usual feedback: a value that grows by a step with each pixel of a span.
use super::{Builder, Sig};
use crate::design::{NodeId, Op, Range};
use crate::graph::{GroupId, Pace, Rule, Value};

impl Sig {
    /// `start` at the first pixel of a span (where `first` is 1), and from then on `step` more with
    /// each pixel; in clocks without one the value waits.
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
        let rule = Rule::Accumulated { start: start.real(), step: step.real(), steps };
        if step.range() == Range::single(0) {
            return start.never_growing(rule);
        }
        let builder = first.builder.clone();
        let round = builder.group([first, &start, &step]);
        let [first, start, step] = [first, &start, &step].map(|sig| sig.taken_with(round));

        let raw = |value: f64| value / start.ulp();
        let assumed =
            Range::new(raw(low).floor() as i64, raw(high).ceil() as i64).hull(start.range());
        let whole = Range::whole(assumed.width(), assumed.signed());
        let state = builder.feedback_register(whole, fraction_bits, round);
        let select = Op::Select(first.id(), start.id(), builder.kept_for_a_pixel(state));
        let value = start.wired(select, whole.hull(start.range()), "value", rule);
        let grown = Rule::Sum(value.real(), step.real());
        let sum = value.range().plus(step.range());
        let next = value.wired(Op::Add(value.id(), step.id()), sum, "next", grown);
        builder.close_loop(state, &next);
        let value = value.assumed(low, high, fact);
        value.registered("accumulated", Rule::Same(value.real()))
    }

    /// `start` and the `term` of every valid clock since `first` was 1, this one included.
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
        let round = builder.group([first, &start, &term]);
        let [first, start, term] = [first, &start, &term].map(|sig| sig.taken_with(round));
        let rule = Rule::Accumulated { start: start.real(), step: term.real(), steps: most };

        let raw = |value: f64| value / start.ulp();
        let stated = Range::new(raw(low).floor() as i64, raw(high).ceil() as i64);
        let whole = Range::whole(stated.width(), stated.signed());
        let state = builder.feedback_register(whole, fraction_bits, round);
        let select = Op::Select(first.id(), start.id(), state);
        let before = start.wired(select, whole.hull(start.range()), "before", rule);
        let grown = Rule::Same(before.real());
        let range = before.range().plus(term.range());
        let sum = before.wired(Op::Add(before.id(), term.id()), range, "sum", grown);
        builder.close_loop(state, &sum);
        let sum = sum.assumed(low, high, fact);
        sum.registered("summed", Rule::Same(sum.real()))
    }

    /// What starts here and never changes: inputs are held while their span goes in, so no register
    /// need keep it. A step of 0 may be one that the host rounded to 0, so it is off as any
    /// accumulated value is.
    fn never_growing(&self, rule: Rule) -> Sig {
        self.builder.leave_out(
            &format!("accumulator {} bits", self.range().width()),
            "its step is always 0",
        );
        self.registered("accumulated", rule)
    }
}

impl Builder {
    /// Values that are taken together.
    pub(super) fn group<'a>(&self, members: impl IntoIterator<Item = &'a Sig>) -> GroupId {
        self.state.borrow_mut().group(members.into_iter().map(Sig::id))
    }

    /// A feedback register's value of the pixel before, where pixels take several clocks.
    pub(super) fn kept_for_a_pixel(&self, register: NodeId) -> NodeId {
        let mut state = self.state.borrow_mut();
        (1..state.graph.loop_registers()).fold(register, |before, _| {
            let value = state.graph.value(before).clone();
            let name = state.unique(value.scope, "state");
            state.push(Value { op: Op::Copy(before), name, ..value })
        })
    }

    /// A register of a loop. What it reads comes later; until then it reads itself.
    pub(super) fn feedback_register(
        &self,
        range: Range,
        fraction_bits: u32,
        round: GroupId,
    ) -> NodeId {
        self.loop_register(Pace::Feedback, (range, fraction_bits), round)
    }

    /// A register of a loop that is clocked in this way.
    pub(super) fn loop_register(
        &self,
        pace: Pace,
        (range, fraction_bits): (Range, u32),
        round: GroupId,
    ) -> NodeId {
        let mut state = self.state.borrow_mut();
        let (scope, own) = (state.scope, NodeId(state.graph.values.len() as u32));
        let name = state.unique(scope, "state");
        state.add(Op::Copy(own), pace, Some(round), (range, fraction_bits), name)
    }

    /// Lets a register of a loop read the value of the pixel that follows.
    pub(super) fn close_loop(&self, register: NodeId, next: &Sig) {
        self.state.borrow_mut().graph.values[register.0 as usize].op = Op::Wrap(next.id());
    }
}

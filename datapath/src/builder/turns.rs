//! Pixels of several clocks: what there is of several, such as lights, takes turns in one pipeline.
use super::{Builder, Control, Sig};
use crate::design::{NodeId, Op, Range};
use crate::graph::Rule;

/// Whose turn it is.
pub struct Turns {
    count: u32,
    /// Which turn it is, 0 to `count` - 1.
    turn: Sig,
    /// 1 in every turn of the first pixel of a span.
    pub first_pixel: Sig,
    /// 1 in a pixel's first turn.
    pub begins: Sig,
    /// 1 in the last turn of a pixel that is valid.
    pub valid_at_last: Sig,
}

impl Builder {
    /// Lets every pixel take `count` clocks, its turns. All feedback that is described from here on
    /// goes back over a whole pixel, so that each turn has values of its own.
    ///
    /// The turns are counted from `control.start`, in one clock with the inputs.
    pub fn take_turns(&self, control: &Control, count: u32) -> Turns {
        let one = self.integer(1);
        if count == 1 {
            let (first_pixel, valid_at_last) = (control.start.clone(), control.valid.clone());
            return Turns { count, turn: self.integer(0), first_pixel, begins: one, valid_at_last };
        }
        let zero = self.integer(0);
        let (turn, later_turn) = self.loaded(&control.start, &zero, count - 1, "turn");
        let (first, later_first) = self.loaded(&control.start, &one, 1, "first_pixel");
        let (begins, valid_at_last) = self.without_registers(|| {
            let last = turn.at_least(&self.integer(i64::from(count) - 1)).named("last_turn");
            self.close_loop(later_turn, &last.choose(&zero, &(&turn + &one)));
            self.close_loop(later_first, &last.choose(&zero, &first));
            (turn.less_than(&one).named("begins"), control.valid.and(&last).named("valid_at_last"))
        });
        self.state.borrow_mut().graph.interval = count;
        Turns { count, turn, first_pixel: first, begins, valid_at_last }
    }

    /// What is `start` where `first` is 1 and what a register keeps elsewhere, 0 to `largest`, and
    /// that register.
    fn loaded(&self, first: &Sig, start: &Sig, largest: u32, name: &str) -> (Sig, NodeId) {
        let range = Range::new(0, i64::from(largest));
        let whole = Range::whole(range.width(), false);
        let round = self.group([first]);
        let register = self.feedback_register(whole, 0, round);
        let select = Op::Select(first.id(), start.id(), register);
        let value = start.wired(select, whole, "value", Rule::Exact);
        (value.named(name), register)
    }
}

impl Turns {
    /// How many there are.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// That of the values, one for each turn, whose turn it is: inputs, or constants. One that is
    /// the same in every turn is taken as it is.
    pub fn select(&self, values: &[Sig]) -> Sig {
        let (last, others) = values.split_last().expect("there is a turn");
        if others.iter().all(|value| value.is(last)) {
            return last.clone().off_as_any_of(others);
        }
        let builder = &self.turn.builder;
        builder.in_one_clock(|| {
            let chosen = |rest: Sig, (k, value): (usize, &Sig)| {
                self.turn.less_than(&builder.integer(k as i64 + 1)).choose(value, &rest)
            };
            others.iter().enumerate().rev().fold(last.clone(), chosen)
        })
    }
}

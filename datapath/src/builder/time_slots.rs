//! Pixels of several clocks: what there is of several, such as lights, shares one pipeline, in a
//! time slot each.
use super::{Builder, Control, Sig};
use crate::design::{NodeId, Op, Range};
use crate::graph::Rule;

/// The clocks of a pixel, and which of them this one is.
pub struct TimeSlots {
    count: u32,
    /// Which time slot of its pixel this clock is, 0 to `count` - 1.
    slot: Sig,
    /// 1 in every time slot of the first pixel of a span.
    pub first_pixel: Sig,
    /// 1 in a pixel's first time slot.
    pub first_slot: Sig,
    /// 1 in the last time slot of a pixel that is valid.
    pub valid_in_last_slot: Sig,
}

impl Builder {
    /// Gives every pixel `count` clocks, its time slots. All feedback that is described from here
    /// on goes back over a whole pixel, so that each time slot has values of its own.
    ///
    /// The time slots are counted from `control.start`, in one clock with the inputs, and only
    /// where `control.valid` is 1: a pause may come between any two of them.
    pub fn time_slots(&self, control: &Control, count: u32) -> TimeSlots {
        if count == 1 {
            return TimeSlots::one(control.start.clone(), control.valid.clone());
        }
        let one = self.integer(1);
        let zero = self.integer(0);
        let (slot, later_slot) = self.loaded(&control.start, &zero, count - 1, "turn");
        let (first_pixel, later_first) = self.loaded(&control.start, &one, 1, "first_pixel");
        let (first_slot, valid_in_last_slot) = self.without_registers(|| {
            let last = slot.at_least(&self.integer(i64::from(count) - 1)).named("last_turn");
            self.close_loop(later_slot, &last.choose(&zero, &(&slot + &one)));
            self.close_loop(later_first, &last.choose(&zero, &first_pixel));
            let first_slot = slot.less_than(&one).named("begins");
            (first_slot, control.valid.and(&last).named("valid_at_last"))
        });
        self.state.borrow_mut().graph.interval = count;
        TimeSlots { count, slot, first_pixel, first_slot, valid_in_last_slot }
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

impl TimeSlots {
    /// One for each pixel.
    pub(super) fn one(first_pixel: Sig, valid_in_last_slot: Sig) -> TimeSlots {
        let builder = first_pixel.builder.clone();
        let (first_slot, slot) = (builder.integer(1), builder.integer(0));
        TimeSlots { count: 1, slot, first_pixel, first_slot, valid_in_last_slot }
    }

    /// How many there are.
    pub fn count(&self) -> u32 {
        self.count
    }

    /// That of the values, one for each time slot, whose time slot it is: inputs, or constants. One
    /// that is the same in every time slot is taken as it is.
    pub fn multiplexed(&self, values: &[Sig]) -> Sig {
        let (last, others) = values.split_last().expect("there is a time slot");
        if others.iter().all(|value| value.is(last)) {
            return last.clone().off_as_any_of(others);
        }
        let builder = &self.slot.builder;
        builder.in_one_clock(|| {
            let chosen = |rest: Sig, (k, value): (usize, &Sig)| {
                self.slot.less_than(&builder.integer(k as i64 + 1)).choose(value, &rest)
            };
            others.iter().enumerate().rev().fold(last.clone(), chosen)
        })
    }
}

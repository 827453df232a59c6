//! Clocks over which a core's inputs are held.
use std::ops::Range;

use super::Stimulus;

/// What goes in over some clocks in which nothing but `start` changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputHold {
    /// The clocks.
    pub clocks: Range<u64>,
    /// Whether pixels enter.
    pub valid: bool,
    /// Whether `start` is high in the first clock; in the others it is low.
    pub starts: bool,
    /// The span whose inputs are held; `None` if there is no span at all.
    pub span: Option<usize>,
    /// Raw values of the core's data inputs.
    pub inputs: Vec<i64>,
}

/// An [`InputHold`] without its inputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct HoldRange {
    pub clocks: Range<u64>,
    pub valid: bool,
    pub starts: bool,
    /// The span whose inputs are held; `None` if there is no span at all.
    pub span: Option<usize>,
}

/// The ranges of a run.
pub(crate) struct HoldRanges<'a> {
    stimulus: &'a Stimulus<'a>,
    clock: u64,
    /// The span of the time slot that goes in at `clock` or next, or one behind the last.
    span: usize,
    /// The numbers of its time slots.
    own: Range<u64>,
}

impl<'a> HoldRanges<'a> {
    /// Those of the clocks of a stimulus.
    pub fn of(stimulus: &'a Stimulus<'a>) -> HoldRanges<'a> {
        let clock = stimulus.clocks.start;
        let pixel = stimulus.slots.before(clock) / stimulus.interval;
        let span = stimulus.first_pixels.span_of(pixel);
        HoldRanges { stimulus, clock, span, own: stimulus.slots_of(span) }
    }

    /// Time slots of the span that go in without a bubble, from number `slot` on.
    fn fed(&self, slot: u64) -> HoldRange {
        let Stimulus { slots, clocks, .. } = self.stimulus;
        let run = slots.run_from(slot, self.own.end);
        HoldRange {
            clocks: run.start..run.end.min(clocks.end),
            valid: true,
            starts: slot == self.own.start,
            span: Some(self.span),
        }
    }

    /// A clock without a pixel before the time slot number `slot`. Within a span its inputs are
    /// held and `start` means nothing. Else they may be those of either span, and `start` is high;
    /// between frames those of the one before until its last pixel has left, then the next one's.
    fn idle(&self, slot: u64) -> HoldRange {
        let Stimulus { slots, first_pixels, frames, .. } = self.stimulus;
        let nonsense = slots.nonsense(self.clock);
        let next = Some(self.span).filter(|&span| span < first_pixels.spans());
        let within = next.is_some() && slot > self.own.start;
        let before = self.span.checked_sub(1);
        let clocks = self.clock..self.clock + 1;
        let (starts, span) = if within {
            (nonsense, next)
        } else if slot > 0 && frames.begin_with(self.span) {
            let drained = frames.have_drained(slots.clock_of(slot - 1), self.clock);
            (true, if drained { next } else { before })
        } else if nonsense {
            (true, before.or(next))
        } else {
            (true, next.or(before))
        };
        HoldRange { clocks, valid: false, starts, span }
    }
}

impl Iterator for HoldRanges<'_> {
    type Item = HoldRange;

    fn next(&mut self) -> Option<HoldRange> {
        let Stimulus { slots, clocks, first_pixels, .. } = self.stimulus;
        if self.clock >= clocks.end {
            return None;
        }
        let slot = slots.before(self.clock);
        // Spans have at least one pixel, so each begins after the one before.
        if slot == self.own.end && self.span < first_pixels.spans() {
            self.span += 1;
            self.own = self.stimulus.slots_of(self.span);
        }
        let goes_in = slot < self.own.end && slots.clock_of(slot) == self.clock;
        let range = if goes_in { self.fed(slot) } else { self.idle(slot) };
        self.clock = range.clocks.end;
        Some(range)
    }
}

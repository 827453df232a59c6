//! What goes into a core, clock by clock: span after span, then idle clocks until the last pixel is
//! out. A pixel takes as many clocks as the design's interval, its time slots. They follow each
//! other without an idle clock, or with random bubbles between them: clocks in which `valid` is low.
//!
//! In bubbles within a span `start` means nothing and is high or low at random. In idle clocks
//! between spans and behind the last one it is high, so that what a core shows then is what it has
//! at the first pixel of a span: with `start` low it would show a pixel behind the last one of the
//! span, for which no unit answers. What overflows there is nobody's business in hardware, but has
//! to be the same in every engine.
//!
//! Spans may be of several frames. What holds for a frame is then changed between them by the rule
//! that [`Hold::Frame`](specula_datapath::Hold::Frame) states: when the last pixel has left, and as
//! early before the next one as the design's [`settling`](Design::settling) asks for.
mod bubbles;
mod frames;
mod hold;
mod spans;

use std::ops::Range;
use std::sync::Arc;

use specula_datapath::Design;

use bubbles::SlotClocks;
use frames::Frames;
pub use hold::InputHold;
pub(crate) use hold::{HoldRange, HoldRanges};
pub use spans::{FirstPixels, SpanSource};

/// The stimulus of a run.
#[derive(Clone)]
pub struct Stimulus<'a> {
    spans: &'a dyn SpanSource,
    first_pixels: FirstPixels,
    frames: Frames,
    /// Clocks of a pixel.
    interval: u64,
    /// The clocks in which time slots go in.
    slots: SlotClocks,
    /// The clocks of this run.
    clocks: Range<u64>,
}

impl<'a> Stimulus<'a> {
    /// All spans of the source, then idle clocks until the last pixel has left a core of this
    /// design.
    pub fn whole(spans: &'a dyn SpanSource, design: &Design) -> Stimulus<'a> {
        Stimulus::in_order(spans, &FirstPixels::of(spans), design)
    }

    /// As [`Stimulus::whole`], with the source's first pixels, which are not looked for again.
    pub fn in_order(
        spans: &'a dyn SpanSource,
        first_pixels: &FirstPixels,
        design: &Design,
    ) -> Stimulus<'a> {
        let interval = u64::from(design.interval);
        let (frames, count) = (Frames::of(spans, design), first_pixels.pixels() * interval);
        let slots = SlotClocks::Consecutive { first: frames.wait_for(0), count };
        let clocks = 0..slots.clock_of(count) + u64::from(design.latency()) + 1;
        let first_pixels = first_pixels.clone();
        let run = Stimulus { spans, first_pixels, frames, interval, slots, clocks };
        if run.frames.are_several() { run.paused(None) } else { run }
    }

    /// The same whole run with random bubbles of 0 to 4 clocks before each time slot. The same seed
    /// gives the same bubbles.
    pub fn with_bubbles(self, seed: u64) -> Stimulus<'a> {
        self.paused(Some(seed))
    }

    /// The same whole run with its time slots in these clocks: one for each, in order, none before
    /// the core's inputs for a frame have settled.
    pub fn entering_at(self, clocks: &Arc<[u64]>) -> Stimulus<'a> {
        let idle = self.clocks.end - self.slots.clock_of(self.slots.count());
        let slots = SlotClocks::given(clocks.clone());
        Stimulus { clocks: 0..slots.clock_of(slots.count()) + idle, slots, ..self }
    }

    /// The same whole run with the clocks that frames need between them, and with a seed random
    /// bubbles.
    fn paused(self, seed: Option<u64>) -> Stimulus<'a> {
        let count = self.slots.count();
        let idle = self.clocks.end - self.slots.clock_of(count);
        let wait = |slot: u64| {
            let span = self.first_pixels.span_of(slot / self.interval);
            if slot == self.first_slot(span) { self.frames.wait_for(span) } else { 0 }
        };
        let slots = SlotClocks::paused(count, seed, wait);
        Stimulus { clocks: 0..slots.clock_of(count) + idle, slots, ..self }
    }

    /// The part of the run that `window` needs: from the beginning of a span early enough that at
    /// the window's first clock every register holds what it would hold in the whole run.
    ///
    /// Data takes at most the latency through the core, and the clocks in which it settles if it
    /// holds for a frame; and accumulators are loaded at the beginning of a span.
    pub fn leading_to(&self, window: &Range<u64>, design: &Design) -> Stimulus<'a> {
        // A component that waits for its turn does so for up to two clocks, and its product counts as
        // there two stages later: what is left of a pixel stays twice as long at most.
        let waiting = if design.last_slot_only { design.depth() } else { 0 };
        let clocks = [design.latency(), design.settling(), waiting];
        self.reaching_back(window, clocks.into_iter().map(u64::from).sum())
    }

    /// The part of the run from `clocks` before the beginning of a span to the window's end. Of the
    /// span the first pixel has gone in `clocks` before `window`, and with it all that it loads.
    pub(crate) fn reaching_back(&self, window: &Range<u64>, clocks: u64) -> Stimulus<'a> {
        let early = window.start.saturating_sub(clocks);
        let gone_in = self.slots.before(early + 1) / self.interval;
        let span = gone_in.checked_sub(1).map_or(0, |pixel| self.first_pixels.span_of(pixel));
        // What a span loads may be added to by something that is older by up to as many clocks.
        let first = self.begin_of(span).saturating_sub(clocks).min(early);
        let end = window.end.min(self.clocks.end);
        Stimulus { clocks: first.max(self.clocks.start)..end, ..self.clone() }
    }

    /// Whether its spans are of several frames.
    pub(crate) fn has_frames(&self) -> bool {
        self.frames.are_several()
    }

    /// The clocks of the run.
    pub fn clocks(&self) -> Range<u64> {
        self.clocks.clone()
    }

    /// Pixels that enter during the whole run.
    pub fn pixels(&self) -> u64 {
        self.first_pixels.pixels()
    }

    /// Time slots of all pixels of the whole run: the clocks in which `valid` is high.
    pub fn fed_clocks(&self) -> u64 {
        self.slots.count()
    }

    /// The clock at which span `index` begins; that after the last pixel for an index behind the
    /// last.
    pub fn begin_of(&self, index: usize) -> u64 {
        self.slots.clock_of(self.first_slot(index))
    }

    /// The number of the first time slot of span `index`; how many there are for an index behind the
    /// last.
    fn first_slot(&self, index: usize) -> u64 {
        self.first_pixels.of_span(index) * self.interval
    }

    /// The numbers of the time slots of span `index`; none for an index behind the last.
    fn slots_of(&self, index: usize) -> Range<u64> {
        self.first_slot(index)..self.first_slot(index + 1)
    }

    /// Whether a time slot of a pixel goes in at `clock`.
    pub fn feeds(&self, clock: u64) -> bool {
        self.slots.at(clock).is_some()
    }

    /// Whether the last time slot of a pixel goes in at `clock`.
    pub fn completes(&self, clock: u64) -> bool {
        self.slots.at(clock).is_some_and(|slot| (slot + 1).is_multiple_of(self.interval))
    }

    /// The clock in which the last time slot of pixel number `pixel` of span number `span` goes in.
    pub fn completion_of(&self, span: usize, pixel: u32) -> u64 {
        let next = self.first_pixels.of_span(span) + u64::from(pixel) + 1;
        self.slots.clock_of(next * self.interval - 1)
    }

    /// Those of `clocks` in which time slots go in, row after row without a bubble.
    pub fn fed_rows(&self, clocks: Range<u64>) -> impl Iterator<Item = Range<u64>> + '_ {
        let (mut slot, end) = (self.slots.before(clocks.start), self.slots.before(clocks.end));
        std::iter::from_fn(move || {
            let row = (slot < end).then(|| self.slots.run_from(slot, end))?;
            slot += row.end - row.start;
            Some(row)
        })
    }

    /// What is held over which clocks, in order.
    pub fn holds(&self) -> impl Iterator<Item = InputHold> + '_ {
        self.hold_ranges().map(|range| {
            let mut inputs = vec![];
            self.append_inputs(&range, &mut inputs);
            let HoldRange { clocks, valid, starts, span } = range;
            InputHold { clocks, valid, starts, span, inputs }
        })
    }

    /// The holds without their inputs.
    pub(crate) fn hold_ranges(&self) -> HoldRanges<'_> {
        HoldRanges::of(self)
    }

    /// Appends the inputs that are held during a range.
    pub(crate) fn append_inputs(&self, range: &HoldRange, inputs: &mut Vec<i64>) {
        if let Some(span) = range.span {
            self.spans.append_inputs(span, inputs);
        }
    }
}

#[cfg(test)]
mod tests {
    use specula_datapath::SpanPacket;
    use specula_fixtures::designs;

    use super::*;

    fn packets() -> Vec<SpanPacket> {
        [3, 1, 4]
            .iter()
            .enumerate()
            .map(|(i, &length)| SpanPacket { length, inputs: vec![i as i64] })
            .collect()
    }

    /// Of pixels of so many clocks, with two idle clocks behind the last.
    fn stimulus(packets: &Vec<SpanPacket>, interval: u64) -> Stimulus<'_> {
        let slots = SlotClocks::Consecutive { first: 0, count: 8 * interval };
        let (first_pixels, clocks) = (FirstPixels::of(packets), 0..8 * interval + 2);
        let frames = Frames::of(packets, &designs::empty("nothing"));
        Stimulus { spans: packets, first_pixels, frames, interval, slots, clocks }
    }

    #[test]
    fn spans_follow_each_other_without_an_idle_clock() {
        let packets = packets();
        let clocks: Vec<_> = stimulus(&packets, 1)
            .holds()
            .map(|s| (s.clocks, s.valid, s.starts, s.inputs))
            .collect();
        let span = |clocks, i| (clocks, true, true, vec![i]);
        let idle = |clocks| (clocks, false, true, vec![2]);
        assert_eq!(clocks, [span(0..3, 0), span(3..4, 1), span(4..8, 2), idle(8..9), idle(9..10)]);
    }

    /// What goes in at each clock: whether a pixel does, `start`, and the span whose inputs are held.
    fn rows(stimulus: &Stimulus) -> Vec<(bool, bool, i64)> {
        let row = |hold: &InputHold, clock| {
            (hold.valid, hold.starts && clock == hold.clocks.start, hold.inputs[0])
        };
        let rows = |hold: InputHold| hold.clocks.clone().map(move |clock| row(&hold, clock));
        stimulus.holds().flat_map(rows).collect()
    }

    #[test]
    fn bubbles_leave_the_order_of_time_slots_as_it_is() {
        let packets = packets();
        for interval in [1, 3] {
            let plain = rows(&stimulus(&packets, interval));
            for seed in 0..20 {
                let paused = stimulus(&packets, interval).with_bubbles(seed);
                let all = rows(&paused);
                assert_eq!(all.len() as u64, paused.clocks().end);
                let fed: Vec<_> = all.iter().copied().filter(|row| row.0).collect();
                let wanted: Vec<_> = plain.iter().copied().filter(|row| row.0).collect();
                assert_eq!(fed, wanted);
                within_spans_inputs_are_held(&all);
                let completed = (0..paused.clocks().end).filter(|&clock| paused.completes(clock));
                let of_pixels = packets
                    .iter()
                    .enumerate()
                    .flat_map(|(span, packet)| (0..packet.length).map(move |pixel| (span, pixel)));
                let completions = of_pixels.map(|(span, pixel)| paused.completion_of(span, pixel));
                assert!(completed.eq(completions));
            }
        }
    }

    /// From the first time slot of a span to its last, whatever `start` is; else `start` is high.
    fn within_spans_inputs_are_held(rows: &[(bool, bool, i64)]) {
        for span in 0..3 {
            let of_span = |row: &(bool, bool, i64)| row.0 && row.2 == span;
            let first = rows.iter().position(of_span).unwrap();
            let last = rows.iter().rposition(of_span).unwrap();
            assert!(rows[first..=last].iter().all(|row| row.2 == span));
            let behind = rows[last + 1..].iter().take_while(|row| !row.0);
            assert!(behind.clone().all(|row| row.1 && (row.2 - span) / 2 == 0));
        }
    }

    /// A run that begins late shows what the whole run shows.
    #[test]
    fn late_runs_go_on_as_the_whole_run_does() {
        let packets = packets();
        for seed in 0..20 {
            let whole = stimulus(&packets, 3).with_bubbles(seed);
            let all = rows(&whole);
            for first in 0..whole.clocks().end {
                let late = whole.reaching_back(&(first..whole.clocks().end), 2);
                let begin = late.clocks().start as usize;
                assert!(begin <= first as usize && rows(&late) == all[begin..]);
                // The first pixel of the span with which it begins is there in time, or none was
                // there before.
                let loaded = all[begin..first.saturating_sub(1) as usize].iter();
                let seen = loaded.skip_while(|row| !(row.0 && row.1)).filter(|row| row.0).count();
                assert!(seen >= 3 || all[..begin].iter().all(|row| !row.0));
            }
        }
    }
}

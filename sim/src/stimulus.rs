//! What goes into a core, clock by clock: span after span with no idle clock between, then idle
//! clocks until the last pixel is out. A pixel takes as many clocks as the design's interval.
//!
//! `start` is high in idle clocks, so that accumulators stay where their units say that they are:
//! behind the last pixel of a span they would go on, and what overflows then is nobody's business
//! in hardware, but has to be the same in every engine.
use std::iter;
use std::ops::Range;
use std::sync::Arc;

use specula_datapath::{Design, SpanPacket};

/// Spans that are to be shaded, set up one at a time so that memory does not grow with the picture.
pub trait SpanSource: Sync {
    /// Number of spans.
    fn count(&self) -> usize;
    /// Pixels of span `index`.
    fn length(&self, index: usize) -> u32;
    /// Appends the raw inputs of span `index`, in port order.
    fn append_inputs(&self, index: usize, inputs: &mut Vec<i64>);
}

impl SpanSource for Vec<SpanPacket> {
    fn count(&self) -> usize {
        self.len()
    }

    fn length(&self, index: usize) -> u32 {
        self[index].length
    }

    fn append_inputs(&self, index: usize, inputs: &mut Vec<i64>) {
        inputs.extend_from_slice(&self[index].inputs);
    }
}

/// Where each span of a source begins in the order of all its pixels.
#[derive(Clone, Debug)]
pub struct FirstPixels(
    /// The number of each span's first pixel, and behind them how many pixels there are.
    Arc<[u64]>,
);

impl FirstPixels {
    /// Those of a source.
    pub fn of(spans: &dyn SpanSource) -> FirstPixels {
        let ends = (0..spans.count()).scan(0, |pixels, index| {
            *pixels += u64::from(spans.length(index));
            Some(*pixels)
        });
        FirstPixels(iter::once(0).chain(ends).collect())
    }

    /// The number of span `index`'s first pixel; how many pixels there are for an index behind the
    /// last.
    pub fn of_span(&self, index: usize) -> u64 {
        self.0[index.min(self.spans())]
    }

    /// The number of pixels of all spans.
    pub fn pixels(&self) -> u64 {
        self.0[self.spans()]
    }

    fn spans(&self) -> usize {
        self.0.len() - 1
    }
}

/// The stimulus of a run.
pub struct Stimulus<'a> {
    spans: &'a dyn SpanSource,
    first_pixels: FirstPixels,
    /// Clocks of a pixel.
    interval: u64,
    /// The clocks of this run.
    clocks: Range<u64>,
}

/// What goes in over some clocks in which nothing but `start` changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputHold {
    /// The clocks.
    pub clocks: Range<u64>,
    /// Whether pixels enter.
    pub valid: bool,
    /// Whether the first clock is the first of a span.
    pub starts: bool,
    /// Raw values of the core's data inputs.
    pub inputs: Vec<i64>,
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
        let clocks = first_pixels.pixels() * interval + u64::from(design.latency()) + 1;
        Stimulus { spans, first_pixels: first_pixels.clone(), interval, clocks: 0..clocks }
    }

    /// The part of the run that `window` needs: from the beginning of a span early enough that at
    /// the window's first clock every register holds what it would hold in the whole run.
    ///
    /// Data takes at most the latency through the core, and accumulators are loaded at the
    /// beginning of a span.
    pub fn leading_to(&self, window: &Range<u64>, design: &Design) -> Stimulus<'a> {
        self.reaching_back(window, design.latency().into())
    }

    /// The part of the run from `clocks` before the beginning of the span that enters `clocks`
    /// before `window` to the window's end.
    pub(crate) fn reaching_back(&self, window: &Range<u64>, clocks: u64) -> Stimulus<'a> {
        let early = window.start.saturating_sub(clocks);
        // Idle clocks load what the last span has loaded.
        let span = self.begun(early).min(self.first_pixels.spans()).saturating_sub(1);
        // What a span loads may be added to by something that is older by up to as many clocks.
        let first = self.begin_of(span).saturating_sub(clocks).min(early);
        let end = window.end.min(self.clocks.end);
        let first_pixels = self.first_pixels.clone();
        Stimulus { first_pixels, clocks: first.max(self.clocks.start)..end, ..*self }
    }

    /// The clocks of the run.
    pub fn clocks(&self) -> Range<u64> {
        self.clocks.clone()
    }

    /// Pixels that enter during the whole run.
    pub fn pixels(&self) -> u64 {
        self.first_pixels.pixels()
    }

    /// Clocks of all pixels of the whole run.
    pub fn fed_clocks(&self) -> u64 {
        self.first_pixels.pixels() * self.interval
    }

    /// The clock at which span `index` begins; that after the last pixel for an index behind the
    /// last.
    pub fn begin_of(&self, index: usize) -> u64 {
        self.first_pixels.of_span(index) * self.interval
    }

    /// How many spans have begun by `clock`, counting the idle clocks behind the last as one.
    fn begun(&self, clock: u64) -> usize {
        self.first_pixels.0.partition_point(|&first| first * self.interval <= clock)
    }

    /// Whether `clock` is one of a pixel's.
    pub fn feeds(&self, clock: u64) -> bool {
        clock < self.fed_clocks()
    }

    /// Whether a pixel enters at `clock`: it is the first of its clocks.
    pub fn enters(&self, clock: u64) -> bool {
        self.feeds(clock) && clock.is_multiple_of(self.interval)
    }

    /// The clock in which pixel number `pixel` of span number `span` enters.
    pub fn entry_of(&self, span: usize, pixel: u32) -> u64 {
        self.begin_of(span) + u64::from(pixel) * self.interval
    }

    /// The span that goes in at `clock`, and which of its pixels; `None` when idle.
    pub fn pixel_at(&self, clock: u64) -> Option<(usize, u32)> {
        let index = self.begun(clock).checked_sub(1)?;
        let offset = clock - self.begin_of(index);
        (index < self.first_pixels.spans()).then_some((index, (offset / self.interval) as u32))
    }

    /// The holds that make up the run, in order.
    pub fn holds(&self) -> impl Iterator<Item = InputHold> + '_ {
        self.hold_ranges().map(|range| {
            let mut inputs = vec![];
            self.append_inputs(&range, &mut inputs);
            InputHold { clocks: range.clocks, valid: range.valid, starts: range.starts, inputs }
        })
    }

    /// The holds without their inputs.
    pub(crate) fn hold_ranges(&self) -> HoldRanges<'_> {
        let span = self.begun(self.clocks.start).saturating_sub(1);
        HoldRanges { stimulus: self, span, clock: self.clocks.start }
    }

    /// Appends the inputs that are held during a range. Idle clocks leave inputs where the last
    /// span left them.
    pub(crate) fn append_inputs(&self, range: &HoldRange, inputs: &mut Vec<i64>) {
        if let Some(span) = range.span {
            self.spans.append_inputs(span, inputs);
        }
    }
}

/// A hold without its inputs.
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
    /// The span that `clock` lies in, or one behind the last.
    span: usize,
    clock: u64,
}

impl Iterator for HoldRanges<'_> {
    type Item = HoldRange;

    fn next(&mut self) -> Option<HoldRange> {
        let Stimulus { first_pixels, clocks, .. } = self.stimulus;
        let spans = first_pixels.spans();
        if self.clock >= clocks.end {
            return None;
        }
        // Spans have at least one pixel, so each begins after the one before.
        let range = if self.span < spans {
            HoldRange {
                clocks: self.clock..self.stimulus.begin_of(self.span + 1).min(clocks.end),
                valid: true,
                starts: self.clock == self.stimulus.begin_of(self.span),
                span: Some(self.span),
            }
        } else {
            HoldRange {
                clocks: self.clock..self.clock + 1,
                valid: false,
                starts: true,
                span: spans.checked_sub(1),
            }
        };
        self.clock = range.clocks.end;
        self.span = (self.span + 1).min(spans);
        Some(range)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn packets() -> Vec<SpanPacket> {
        [3, 1, 4]
            .iter()
            .enumerate()
            .map(|(i, &length)| SpanPacket { length, inputs: vec![i as i64] })
            .collect()
    }

    fn stimulus(packets: &Vec<SpanPacket>, clocks: Range<u64>) -> Stimulus<'_> {
        Stimulus { spans: packets, first_pixels: FirstPixels::of(packets), interval: 1, clocks }
    }

    #[test]
    fn spans_follow_each_other_without_an_idle_clock() {
        let packets = packets();
        let clocks: Vec<_> = stimulus(&packets, 0..10)
            .holds()
            .map(|s| (s.clocks, s.valid, s.starts, s.inputs))
            .collect();
        let span = |clocks, i| (clocks, true, true, vec![i]);
        let idle = |clocks| (clocks, false, true, vec![2]);
        assert_eq!(clocks, [span(0..3, 0), span(3..4, 1), span(4..8, 2), idle(8..9), idle(9..10)]);
    }

    #[test]
    fn pixels_are_found_by_their_clock() {
        let packets = packets();
        let stimulus = stimulus(&packets, 0..10);
        assert_eq!(
            [0, 2, 3, 4, 7, 8].map(|c| stimulus.pixel_at(c)),
            [Some((0, 0)), Some((0, 2)), Some((1, 0)), Some((2, 0)), Some((2, 3)), None]
        );
    }
}

//! Clocks that a core takes for a frame.
use serde::{Deserialize, Serialize};
use specula_hdl::Design;
use specula_scene::Frame;

/// Bits of a span's set-up that the host hands over in a clock.
pub const WORD_BITS: u64 = 32;

/// Clocks of a frame.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FrameCycles {
    /// Pixels shaded.
    pub pixels: u64,
    /// Spans that they are in.
    pub spans: u64,
    /// Clocks from a pixel's entry to its exit.
    pub latency: u64,
    /// Clocks in which a span's inputs are handed over, [`WORD_BITS`] in each; constants are not.
    pub set_up: u64,
    /// From the first pixel's entry to the last one's exit, with every span's inputs at hand.
    pub shading: u64,
    /// From the first word's arrival to the last pixel's exit, where a span's inputs are handed
    /// over while the span before is shaded: a span shorter than its successor's set-up waits for
    /// it.
    pub with_set_up: u64,
}

impl FrameCycles {
    /// Of a frame through a core.
    pub fn new(design: &Design, frame: &Frame) -> FrameCycles {
        let bits: u64 = design
            .inputs
            .iter()
            .flatten()
            .map(|&input| u64::from(design.node(input).width()))
            .sum();
        let lengths = frame.spans.iter().map(|span| u64::from(span.length));
        FrameCycles::of(
            lengths,
            u64::from(design.interval),
            bits.div_ceil(WORD_BITS),
            u64::from(design.latency()),
        )
    }

    /// `interval` clocks after a pixel the next one enters.
    fn of(
        lengths: impl DoubleEndedIterator<Item = u64> + Clone,
        interval: u64,
        set_up: u64,
        latency: u64,
    ) -> FrameCycles {
        let pixels: u64 = lengths.clone().sum();
        // All but the last span have a successor to wait for.
        let waits: u64 = lengths
            .clone()
            .rev()
            .skip(1)
            .map(|length| set_up.saturating_sub(length * interval))
            .sum();
        let spans = lengths.count() as u64;
        let shading = (pixels * interval + latency + 1).saturating_sub(interval);
        FrameCycles {
            pixels,
            spans,
            latency,
            set_up,
            shading,
            with_set_up: set_up + waits + shading,
        }
    }

    /// Clocks for each pixel with every span's inputs at hand.
    pub fn per_pixel(&self) -> f64 {
        self.shading as f64 / self.pixels.max(1) as f64
    }

    /// Clocks for each pixel with set-up counted.
    pub fn per_pixel_with_set_up(&self) -> f64 {
        self.with_set_up as f64 / self.pixels.max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_spans_wait_for_the_next_ones_inputs() {
        let cycles = FrameCycles::of([10, 2, 3, 1].into_iter(), 1, 4, 100);
        assert_eq!((cycles.pixels, cycles.spans, cycles.shading), (16, 4, 116));
        // 4 clocks before the first, 2 between the second and the third, 1 between the third and
        // the last.
        assert_eq!(cycles.with_set_up, 116 + 4 + 2 + 1);
        assert_eq!(FrameCycles::of([10, 9].into_iter(), 1, 0, 5).with_set_up, 24);
    }

    #[test]
    fn pixels_of_lights_that_take_turns_enter_after_several_clocks() {
        let cycles = FrameCycles::of([2, 1].into_iter(), 3, 7, 10);
        // The last pixel enters 6 clocks after the first; the first span leaves a clock to wait for
        // the second.
        assert_eq!((cycles.shading, cycles.with_set_up), (6 + 10 + 1, 17 + 7 + 1));
    }
}

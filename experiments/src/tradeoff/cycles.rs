//! The clocks that a core takes for a frame.
use serde::{Deserialize, Serialize};
use specula_datapath::Design;
use specula_scene::Frame;

/// Bits of a span's set-up that the host transfers in a clock.
pub const WORD_BITS: u64 = 32;

/// The clocks for a frame.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FrameCycles {
    /// Number of pixels shaded.
    pub pixels: u64,
    /// Number of spans.
    pub spans: u64,
    /// Clocks from a pixel's entry to its exit.
    pub latency: u64,
    /// Clocks in which spans' inputs are transferred, [`WORD_BITS`] in each; constants are not
    /// transferred.
    pub set_up: u64,
    /// Clocks from the first pixel's entry to the last one's exit, if every span's inputs are
    /// present.
    pub shading: u64,
    /// Clocks from the first word's arrival to the last pixel's exit, if a span's inputs are
    /// transferred while the previous span is shaded: a span shorter than its successor's set-up
    /// has to wait for it.
    pub with_set_up: u64,
}

impl FrameCycles {
    /// The clocks of a frame with a core.
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

    /// The clocks for spans of these lengths; the next pixel enters `interval` clocks after a
    /// pixel.
    fn of(
        lengths: impl DoubleEndedIterator<Item = u64> + Clone,
        interval: u64,
        set_up: u64,
        latency: u64,
    ) -> FrameCycles {
        let pixels: u64 = lengths.clone().sum();
        // All spans but the last have a successor to wait for.
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

    /// Clocks for each pixel, if every span's inputs are present.
    pub fn per_pixel(&self) -> f64 {
        self.shading as f64 / self.pixels.max(1) as f64
    }

    /// Clocks for each pixel, including set-up.
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
        // 4 clocks before the first span, 2 between the second and the third, 1 between the third
        // and the last.
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

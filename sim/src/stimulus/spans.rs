//! Spans that are to be shaded, and where each of them begins.
use std::iter;
use std::sync::Arc;

use specula_datapath::SpanPacket;

/// Spans that are to be shaded, set up one at a time so that memory does not grow with the picture.
pub trait SpanSource: Sync {
    /// Number of spans.
    fn count(&self) -> usize;
    /// Pixels of span `index`.
    fn length(&self, index: usize) -> u32;
    /// Appends the raw inputs of span `index`, in port order.
    fn append_inputs(&self, index: usize, inputs: &mut Vec<i64>);
    /// Whether span `index`, which is not the first, is the first of a frame, so that what holds for
    /// a frame may be another than before: the inputs of these numbers. A source is one frame,
    /// unless it says otherwise.
    fn begins_frame(&self, _index: usize, _frame_inputs: &[usize]) -> bool {
        false
    }
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

    /// As often as it has to be.
    fn begins_frame(&self, index: usize, frame_inputs: &[usize]) -> bool {
        let [before, own] = [&self[index - 1].inputs, &self[index].inputs];
        frame_inputs.iter().any(|&input| before[input] != own[input])
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

    /// The number of spans.
    pub fn spans(&self) -> usize {
        self.0.len() - 1
    }

    /// The span that pixel number `pixel` is of; the number of spans for a pixel behind the last.
    pub fn span_of(&self, pixel: u64) -> usize {
        self.0.partition_point(|&first| first <= pixel) - 1
    }
}

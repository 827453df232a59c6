//! Spans in memory, repeated as often as a measurement needs them.
use specula_golden::fixed::Model;
use specula_sim::SpanSource;

use super::MeasureError;
use super::checksum::Checksum;
use specula_testbench::{Bench, FrameSpans};

/// The spans of a frame, set up, and the model's checksums of them.
pub(crate) struct Workload {
    lengths: Vec<u32>,
    /// The inputs of all spans, one span after the other.
    inputs: Vec<i64>,
    inputs_per_span: usize,
    /// The model's checksums of the spans before each one, and of all of them.
    sums: Vec<Checksum>,
}

impl Workload {
    /// Sets up every span of the bench's frame.
    ///
    /// # Errors
    /// [`MeasureError::NoPixels`] for a frame without spans.
    pub fn new(bench: &Bench) -> Result<Workload, MeasureError> {
        let (spans, model) = (FrameSpans::new(bench.frame, bench.spec), Model::new(bench.spec));
        let inputs_per_span = bench.design.inputs.len();
        let mut workload = Workload {
            lengths: vec![],
            inputs: vec![],
            inputs_per_span,
            sums: vec![Checksum::default()],
        };
        let mut total = Checksum::default();
        for index in 0..spans.count() {
            let packet = spans.packet(index);
            let mut codes = vec![];
            model.shade(&packet, &mut codes)?;
            total.add_pixels(&codes);
            workload.sums.push(total);
            workload.lengths.push(packet.length);
            workload.inputs.extend(packet.inputs);
        }
        if workload.lengths.is_empty() { Err(MeasureError::NoPixels) } else { Ok(workload) }
    }

    /// Number of spans of the frame.
    pub fn frame(&self) -> usize {
        self.lengths.len()
    }

    /// The first `count` spans of an endless sequence of frames.
    pub fn spans(&self, count: usize) -> Repeated<'_> {
        Repeated { workload: self, count }
    }

    /// The model's checksum of the first `count` of these spans.
    pub fn checksum(&self, count: usize) -> Checksum {
        let (frames, rest) = (count / self.frame(), count % self.frame());
        self.sums[self.frame()].times(frames).plus(self.sums[rest])
    }
}

/// Spans of an endless sequence of frames.
pub(crate) struct Repeated<'a> {
    workload: &'a Workload,
    count: usize,
}

impl SpanSource for Repeated<'_> {
    fn count(&self) -> usize {
        self.count
    }

    fn length(&self, index: usize) -> u32 {
        self.workload.lengths[index % self.workload.frame()]
    }

    fn append_inputs(&self, index: usize, inputs: &mut Vec<i64>) {
        let width = self.workload.inputs_per_span;
        let first = index % self.workload.frame() * width;
        inputs.extend_from_slice(&self.workload.inputs[first..first + width]);
    }
}

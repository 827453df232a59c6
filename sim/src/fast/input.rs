//! The stimulus as columns.
use std::collections::HashMap;
use std::iter::Peekable;
use std::ops::Range;

use specula_hdl::Design;
use specula_hdl::design::NodeId;
use specula_kernels::Lane;

use super::memory::{Memory, PADDING, Place};
use crate::Stimulus;
use crate::stimulus::{Stride, Strides};

/// A column of an input, and the value that all its lanes hold, if it is one.
struct InputColumn {
    place: Place,
    /// Number of the input in a packet.
    index: usize,
    uniform: Option<i64>,
}

/// A stride that reaches into this batch.
struct Segment {
    stride: Stride,
    /// Its lanes.
    lanes: Range<usize>,
    /// Whether its first clock is one of them.
    begins: bool,
}

/// Fills the inputs' columns batch after batch.
pub struct InputFeed<'a> {
    stimulus: &'a Stimulus<'a>,
    valid: Option<Place>,
    start: Option<Place>,
    columns: Vec<InputColumn>,
    strides: Peekable<Strides<'a>>,
    /// Strides of this batch, and their inputs, `stride` after `stride`.
    segments: Vec<Segment>,
    inputs: Vec<i64>,
    inputs_per_stride: usize,
}

impl<'a> InputFeed<'a> {
    /// The feed of a run.
    pub fn new(design: &Design, stimulus: &'a Stimulus<'a>, places: &HashMap<NodeId, Place>) -> InputFeed<'a> {
        let place = |id: NodeId| places.get(&id).copied();
        let inputs = design.inputs.iter().enumerate();
        InputFeed {
            stimulus,
            valid: place(design.valid),
            start: place(design.start),
            columns: inputs.filter_map(|(index, id)| Some(InputColumn { place: place((*id)?)?, index, uniform: None })).collect(),
            strides: stimulus.strides().peekable(),
            segments: vec![],
            inputs: vec![],
            inputs_per_stride: design.inputs.len(),
        }
    }

    /// Fills `lanes` lanes, the first of which stands for clock `position` of the run. Before the run's first clock inputs are 0.
    pub fn fill(&mut self, memory: &mut Memory, position: i64, lanes: usize) {
        self.collect(position, lanes);
        self.fill_control(memory, lanes);
        let before = (-position).clamp(0, lanes as i64) as usize;
        for column in &mut self.columns {
            column.fill(memory, &self.segments, self.inputs.get(column.index..).unwrap_or(&[]), self.inputs_per_stride, before);
        }
    }

    fn fill_control(&self, memory: &mut Memory, lanes: usize) {
        for place in self.valid.into_iter().chain(self.start) {
            memory.fill(place, 0, lanes, 0);
        }
        for Segment { stride, lanes, begins } in &self.segments {
            if let (Some(valid), true) = (self.valid, stride.valid) {
                memory.fill(valid, lanes.start, lanes.end, 1);
            }
            if let (Some(start), true) = (self.start, *begins && stride.starts) {
                memory.set_lane(start, lanes.start, 1);
            }
        }
    }

    /// Takes the strides that reach into this batch.
    fn collect(&mut self, position: i64, lanes: usize) {
        let (origin, end) = (self.stimulus.clocks().start, position + lanes as i64);
        let relative = |clock: u64| (clock - origin) as i64;
        let done = self.segments.iter().take_while(|s| relative(s.stride.clocks.end) <= position).count();
        self.segments.drain(..done);
        self.inputs.drain(..done * self.inputs_per_stride);
        while let Some(stride) = self.strides.next_if(|stride| relative(stride.clocks.start) < end) {
            self.stimulus.append_inputs(&stride, &mut self.inputs);
            // A run without spans has no inputs to hold.
            self.inputs.resize((self.segments.len() + 1) * self.inputs_per_stride, 0);
            self.segments.push(Segment { stride, lanes: 0..0, begins: false });
        }
        for Segment { stride, lanes: range, begins } in &mut self.segments {
            let lane = |clock: u64| (relative(clock) - position).clamp(0, lanes as i64) as usize;
            *range = lane(stride.clocks.start)..lane(stride.clocks.end);
            *begins = relative(stride.clocks.start) >= position;
        }
    }
}

impl InputColumn {
    /// `inputs` begins with the first stride's value of this input; the next one's follows `step` further on.
    fn fill(&mut self, memory: &mut Memory, segments: &[Segment], inputs: &[i64], step: usize, before: usize) {
        let values = inputs.iter().step_by(step);
        // What is constant over many spans costs next to nothing: its lanes hold it already.
        let only = inputs.first().copied().filter(|&first| before == 0 && values.clone().all(|&value| value == first));
        if only.is_some() && only == self.uniform {
            return;
        }
        memory.fill(self.place, 0, before, 0);
        if self.place.wide {
            let column = &mut memory.wide[self.place.index];
            spread(&mut column.lanes[column.history..], segments, values);
        } else {
            let column = &mut memory.narrow[self.place.index];
            spread(&mut column.lanes[column.history..], segments, values);
        }
        self.uniform = only;
    }
}

/// Writes each segment's value to its lanes, some lanes at a time and beyond its end: the next segment overwrites what is too much, and
/// behind the batch there is padding.
fn spread<'v, L: Lane>(lanes: &mut [L], segments: &[Segment], values: impl Iterator<Item = &'v i64>) {
    for (segment, &value) in segments.iter().zip(values) {
        let block = [L::from_i64(value); PADDING];
        let mut lane = segment.lanes.start;
        while lane < segment.lanes.end {
            lanes[lane..lane + PADDING].copy_from_slice(&block);
            lane += PADDING;
        }
    }
}

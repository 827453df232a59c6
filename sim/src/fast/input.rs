//! The stimulus as columns.
use std::collections::HashMap;
use std::iter::Peekable;
use std::ops::Range;

use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_kernels::Lane;

use super::memory::{Column, Memory, PADDING, Place};
use super::plan::InputPlace;
use crate::Stimulus;
use crate::stimulus::{HoldRange, HoldRanges};

/// A column of an input, and the value that all its lanes hold, if it is one.
struct InputColumn {
    place: Place,
    /// Number of the input in a packet.
    index: usize,
    uniform: Option<i64>,
}

/// A column of an input that has one value over the whole run, and runs ahead.
struct SteadyColumn {
    place: InputPlace,
    value: i64,
    /// Whether all its lanes hold that.
    filled: bool,
}

/// A column of an input that is to be filled.
struct Stale {
    place: Place,
    /// Number of the input in a packet.
    index: usize,
}

/// A range that reaches into this batch.
struct Segment {
    range: HoldRange,
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
    steady: Vec<SteadyColumn>,
    ranges: Peekable<HoldRanges<'a>>,
    /// Ranges of this batch, and their inputs, `range` after `range`.
    segments: Vec<Segment>,
    inputs: Vec<i64>,
    inputs_per_range: usize,
    /// For each input, bits in which its values of this batch differ.
    varying: Vec<i64>,
}

impl<'a> InputFeed<'a> {
    /// The feed of a run.
    pub fn new(
        design: &Design,
        stimulus: &'a Stimulus<'a>,
        places: &HashMap<NodeId, InputPlace>,
    ) -> InputFeed<'a> {
        let place = |id: NodeId| places.get(&id).map(|input| input.place);
        let first = stimulus.holds().next().map_or(vec![], |hold| hold.inputs);
        let (mut columns, mut steady) = (vec![], vec![]);
        for (index, id) in design.inputs.iter().enumerate() {
            let Some(&input) = id.and_then(|id| places.get(&id)) else { continue };
            if input.ahead == 0 {
                columns.push(InputColumn { place: input.place, index, uniform: None });
            } else {
                let value = first.get(index).copied().unwrap_or(0);
                steady.push(SteadyColumn { place: input, value, filled: false });
            }
        }
        InputFeed {
            stimulus,
            valid: place(design.valid),
            start: place(design.start),
            columns,
            steady,
            ranges: stimulus.hold_ranges().peekable(),
            segments: vec![],
            inputs: vec![],
            inputs_per_range: design.inputs.len(),
            varying: vec![0; design.inputs.len()],
        }
    }

    /// Fills `lanes` lanes, the first of which stands for clock `position` of the run. Before the
    /// run's first clock inputs are 0.
    pub fn fill(&mut self, memory: &mut Memory, position: i64, lanes: usize) {
        self.collect(position, lanes);
        self.fill_control(memory, lanes);
        self.find_varying();
        let before = (-position).clamp(0, lanes as i64) as usize;
        let stale = self.stale(before);
        for column in &stale {
            memory.fill(column.place, 0, before, 0);
        }
        let (wide, narrow): (Vec<Stale>, Vec<Stale>) =
            stale.into_iter().partition(|column| column.place.wide);
        self.spread(&mut memory.narrow, &narrow);
        self.spread(&mut memory.wide, &wide);
        self.fill_steady(memory, position, lanes);
    }

    fn fill_steady(&mut self, memory: &mut Memory, position: i64, lanes: usize) {
        for SteadyColumn { place: InputPlace { place, ahead }, value, filled } in &mut self.steady {
            if !*filled {
                let before = (-position - *ahead as i64).clamp(0, lanes as i64) as usize;
                memory.fill(*place, 0, before, 0);
                memory.fill(*place, before, lanes, *value);
                *filled = before == 0;
            }
        }
    }

    fn fill_control(&self, memory: &mut Memory, lanes: usize) {
        for place in self.valid.into_iter().chain(self.start) {
            memory.fill(place, 0, lanes, 0);
        }
        for Segment { range, lanes, begins } in &self.segments {
            if let (Some(valid), true) = (self.valid, range.valid) {
                memory.fill(valid, lanes.start, lanes.end, 1);
            }
            if let (Some(start), true) = (self.start, *begins && range.starts) {
                memory.set_lane(start, lanes.start, 1);
            }
        }
    }

    /// Takes the ranges that reach into this batch.
    fn collect(&mut self, position: i64, lanes: usize) {
        let (origin, end) = (self.stimulus.clocks().start, position + lanes as i64);
        let relative = |clock: u64| (clock - origin) as i64;
        let done =
            self.segments.iter().take_while(|s| relative(s.range.clocks.end) <= position).count();
        self.segments.drain(..done);
        self.inputs.drain(..done * self.inputs_per_range);
        while let Some(range) = self.ranges.next_if(|range| relative(range.clocks.start) < end) {
            self.stimulus.append_inputs(&range, &mut self.inputs);
            // A run without spans has no inputs to hold.
            self.inputs.resize((self.segments.len() + 1) * self.inputs_per_range, 0);
            self.segments.push(Segment { range, lanes: 0..0, begins: false });
        }
        for Segment { range, lanes: own, begins } in &mut self.segments {
            let lane = |clock: u64| (relative(clock) - position).clamp(0, lanes as i64) as usize;
            *own = lane(range.clocks.start)..lane(range.clocks.end);
            *begins = relative(range.clocks.start) >= position;
        }
    }

    /// The inputs of each range; none if there are no inputs.
    fn rows(&self) -> impl Iterator<Item = &[i64]> {
        self.inputs.chunks_exact(self.inputs_per_range.max(1))
    }

    fn find_varying(&mut self) {
        let mut varying = std::mem::take(&mut self.varying);
        varying.fill(0);
        for (row, next) in self.rows().zip(self.rows().skip(1)) {
            for ((varying, value), next) in varying.iter_mut().zip(row).zip(next) {
                *varying |= value ^ next;
            }
        }
        self.varying = varying;
    }

    /// The columns whose lanes do not hold their values yet. What is constant over many spans costs
    /// next to nothing: it is there already. The first `before` lanes are to be 0.
    fn stale(&mut self, before: usize) -> Vec<Stale> {
        let InputFeed { columns, inputs, varying, .. } = self;
        let mut stale = vec![];
        for InputColumn { place, index, uniform } in columns {
            let only = inputs.get(*index).copied().filter(|_| before == 0 && varying[*index] == 0);
            if only.is_none() || only != *uniform {
                stale.push(Stale { place: *place, index: *index });
            }
            *uniform = only;
        }
        stale
    }

    /// Writes each segment's values to its lanes of the columns, some lanes at a time and beyond
    /// its end: the next segment overwrites what is too much, and behind the batch there is
    /// padding.
    fn spread<L: Lane>(&self, columns: &mut [Column<L>], stale: &[Stale]) {
        let mut taken: Vec<Column<L>> =
            stale.iter().map(|stale| std::mem::take(&mut columns[stale.place.index])).collect();
        for (segment, row) in self.segments.iter().zip(self.rows()) {
            // A short segment's branches are the same for every column, and so are foreseen for all
            // but the first.
            for lane in segment.lanes.clone().step_by(PADDING) {
                for (column, stale) in taken.iter_mut().zip(stale) {
                    let first = column.history + lane;
                    column.lanes[first..first + PADDING]
                        .copy_from_slice(&[L::from_i64(row[stale.index]); PADDING]);
                }
            }
        }
        for (column, stale) in taken.into_iter().zip(stale) {
            columns[stale.place.index] = column;
        }
    }
}

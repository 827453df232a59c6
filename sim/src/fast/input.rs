//! The stimulus as columns.
use std::collections::HashMap;
use std::iter::Peekable;

use specula_hdl::Design;
use specula_hdl::design::NodeId;

use super::memory::{Memory, Place};
use crate::Stimulus;
use crate::stimulus::Stretch;

/// A column of an input, and the value that all its lanes hold, if it is one.
struct InputColumn {
    place: Place,
    /// Number of the input in a packet.
    index: usize,
    uniform: Option<i64>,
}

/// Fills the inputs' columns batch after batch.
pub struct InputFeed<'a> {
    valid: Option<Place>,
    start: Option<Place>,
    data: Vec<InputColumn>,
    stretches: Peekable<Box<dyn Iterator<Item = Stretch> + 'a>>,
    first_clock: u64,
    /// Stretches of this batch, with the lanes they take.
    current: Vec<(std::ops::Range<usize>, bool, Stretch)>,
}

impl<'a> InputFeed<'a> {
    /// The feed of a run.
    pub fn new(design: &Design, stimulus: &'a Stimulus<'a>, places: &HashMap<NodeId, Place>) -> InputFeed<'a> {
        let place = |id: NodeId| places.get(&id).copied();
        let data = design.inputs.iter().enumerate();
        let stretches: Box<dyn Iterator<Item = Stretch> + 'a> = Box::new(stimulus.stretches());
        InputFeed {
            valid: place(design.valid),
            start: place(design.start),
            data: data.filter_map(|(index, id)| Some(InputColumn { place: place((*id)?)?, index, uniform: None })).collect(),
            stretches: stretches.peekable(),
            first_clock: stimulus.clocks().start,
            current: vec![],
        }
    }

    /// Fills `lanes` lanes, the first of which stands for clock `position` of the run. Before the run's first clock inputs are 0.
    pub fn fill(&mut self, memory: &mut Memory, position: i64, lanes: usize) {
        self.collect(position, lanes);
        let before = (-position).clamp(0, lanes as i64) as usize;
        for place in self.valid.into_iter().chain(self.start) {
            memory.fill(place, 0, lanes, 0);
        }
        for (range, begins, stretch) in &self.current {
            if let Some(valid) = self.valid {
                memory.fill(valid, range.start, range.end, i64::from(stretch.valid));
            }
            if let (Some(start), true) = (self.start, *begins && stretch.starts) {
                memory.set_lane(start, range.start, 1);
            }
        }
        for column in &mut self.data {
            column.fill(memory, &self.current, before);
        }
    }

    /// Takes the stretches that reach into this batch.
    fn collect(&mut self, position: i64, lanes: usize) {
        let end = position + lanes as i64;
        let relative = |clock: u64| (clock - self.first_clock) as i64;
        self.current.retain(|(_, _, stretch)| relative(stretch.clocks.end) > position);
        while self.stretches.peek().is_some_and(|stretch| relative(stretch.clocks.start) < end) {
            self.current.extend(self.stretches.next().map(|stretch| (0..0, false, stretch)));
        }
        for (range, begins, stretch) in &mut self.current {
            let lane = |clock: u64| (relative(clock) - position).clamp(0, lanes as i64) as usize;
            *range = lane(stretch.clocks.start)..lane(stretch.clocks.end);
            *begins = relative(stretch.clocks.start) >= position;
        }
    }
}

impl InputColumn {
    fn fill(&mut self, memory: &mut Memory, stretches: &[(std::ops::Range<usize>, bool, Stretch)], before: usize) {
        let value = |stretch: &Stretch| stretch.inputs.get(self.index).copied().unwrap_or(0);
        // What is constant over many spans costs next to nothing: its lanes hold it already.
        let only =
            stretches.first().map(|(_, _, s)| value(s)).filter(|&v| before == 0 && stretches.iter().all(|(_, _, s)| value(s) == v));
        if only.is_some() && only == self.uniform {
            return;
        }
        memory.fill(self.place, 0, before, 0);
        for (range, _, stretch) in stretches {
            memory.fill(self.place, range.start, range.end, value(stretch));
        }
        self.uniform = only;
    }
}

//! Rows gathered into batches.
use specula_hdl::design::NodeId;

use crate::{Columns, Flow, SimError};

/// Clocks handed over at a time.
const BATCH: usize = 1024;

/// Gathers rows and hands them over a batch at a time.
pub struct Batches<'a> {
    columns: Columns,
    /// The clock of the next row.
    clock: u64,
    flow: Flow,
    sink: &'a mut dyn FnMut(&Columns) -> Flow,
}

impl<'a> Batches<'a> {
    /// Rows of the `watched` signals from `first_clock` on, for `sink`.
    pub fn new(watched: &[NodeId], first_clock: u64, sink: &'a mut dyn FnMut(&Columns) -> Flow) -> Batches<'a> {
        let mut columns = Columns::new(watched);
        columns.restart(first_clock);
        Batches { columns, clock: first_clock, flow: Flow::Continue, sink }
    }

    /// The clock of the next row.
    pub fn clock(&self) -> u64 {
        self.clock
    }

    /// Adds the row of the next clock and says whether more are wanted.
    pub fn push(&mut self, row: impl IntoIterator<Item = i64>) -> Flow {
        for (column, value) in self.columns.values.iter_mut().zip(row) {
            column.push(value);
        }
        self.clock += 1;
        if self.columns.clocks() == BATCH { self.hand_over() } else { self.flow }
    }

    fn hand_over(&mut self) -> Flow {
        if self.flow == Flow::Continue && self.columns.clocks() > 0 {
            self.flow = (self.sink)(&self.columns);
        }
        self.columns.restart(self.clock);
        self.flow
    }

    /// Hands over what is left; there must have been rows up to the clock `end`, unless the sink stopped them.
    ///
    /// # Errors
    /// [`SimError::TooFewClocks`] if there were not.
    pub fn finish(mut self, end: u64, tool: &'static str) -> Result<(), SimError> {
        match self.hand_over() {
            Flow::Continue if self.clock < end => Err(SimError::TooFewClocks { tool, missing: self.clock, end }),
            _ => Ok(()),
        }
    }
}

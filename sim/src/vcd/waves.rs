//! Waveforms that are written a batch of clocks at a time.
use std::io::{self, Write};

use specula_hdl::Design;
use specula_hdl::design::NodeId;

use super::PERIOD;
use super::header::Header;
use super::record::Record;
use super::text::Text;
use crate::changes::{BLOCK, Changes};
use crate::{Batch, Lanes};

/// Waveforms that are written a batch of clocks at a time.
pub struct Waves<W: Write> {
    text: Text<W>,
    clock: Record,
    reset: Record,
    /// The columns that are written.
    columns: Vec<usize>,
    /// How, in the same order.
    records: Vec<Record>,
    changes: Changes,
    /// The clock behind the last one written; `None` before the first.
    next: Option<u64>,
}

impl<W: Write> Waves<W> {
    /// Writes the header for `nodes`, each under the units it belongs to; constants are left out.
    ///
    /// # Errors
    /// What the system says if `out` cannot be written.
    pub fn begin(out: W, design: &Design, nodes: &[NodeId], about: &str) -> io::Result<Waves<W>> {
        let header = Header::new(design, nodes, about);
        let mut text = Text::new(out);
        text.write_through(&header.text)?;
        let (columns, records): (Vec<_>, Vec<_>) = header.variables.into_iter().unzip();
        let changes = Changes::new(columns.len());
        Ok(Waves { text, clock: header.clock, reset: header.reset, columns, records, changes, next: None })
    }

    /// Appends clocks that follow those written before; the columns must be those of the header.
    ///
    /// # Errors
    /// What the system says if the file cannot be written.
    pub fn append(&mut self, batch: &Batch) -> io::Result<()> {
        let lanes: Vec<Lanes> = self.columns.iter().map(|&column| batch.lanes()[column]).collect();
        for first in (0..batch.clocks()).step_by(BLOCK) {
            let rows = first..batch.clocks().min(first + BLOCK);
            self.changes.find(&lanes, rows.clone());
            for row in rows {
                let clock = batch.first_clock() + row as u64;
                self.rising_edge(clock);
                for signal in self.changes.at(row - first) {
                    self.text.value(&self.records[signal], lanes[signal].get(row));
                }
                self.falling_edge(clock)?;
            }
        }
        Ok(())
    }

    /// Begins a clock. All signals follow the first edge, since none has had a value before.
    fn rising_edge(&mut self, clock: u64) {
        self.text.time(PERIOD * clock);
        if self.next.is_none() {
            self.text.line(b"$dumpvars\n");
            self.text.value(&self.reset, 0);
        }
        self.text.value(&self.clock, 1);
    }

    fn falling_edge(&mut self, clock: u64) -> io::Result<()> {
        if self.next.is_none() {
            self.text.line(b"$end\n");
        }
        self.text.time(PERIOD * clock + PERIOD / 2);
        self.text.value(&self.clock, 0);
        self.next = Some(clock + 1);
        self.text.write_pieces()
    }

    /// Ends the file with the time at which the last clock ends.
    ///
    /// # Errors
    /// What the system says if the file cannot be written.
    pub fn end(mut self) -> io::Result<()> {
        if let Some(next) = self.next {
            self.text.time(PERIOD * next);
        }
        self.text.flush()
    }
}

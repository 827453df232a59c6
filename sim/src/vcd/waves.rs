//! Waveforms that are written a batch of clocks at a time.
use std::io::{self, BufWriter, Write};
use std::ops::Range;

use specula_datapath::Design;
use specula_datapath::design::NodeId;

use super::PERIOD;
use super::header::{Header, Variable};
use super::record::Record;
use super::rows::Rows;
use crate::Batch;
use crate::changes::changes;

/// Bytes that are gathered before they are written. More of them at a time are not copied first.
const PIECE: usize = 64 << 10;
/// Bytes of a clock beside its signals: two times of up to 20 digits, the clock twice, reset, and
/// the words round the first values.
const EDGES: usize = 128;

/// Waveforms that are written a batch of clocks at a time.
pub struct Waves<W: Write> {
    out: BufWriter<W>,
    clock: Record,
    reset: Record,
    variables: Vec<Variable>,
    rows: Rows,
    /// The clock behind the last one written; `None` before the first.
    next: Option<u64>,
}

impl<W: Write> Waves<W> {
    /// Writes the header for `nodes`, each under the units it belongs to; constants are left out.
    ///
    /// # Errors
    /// What the system says if `out` cannot be written.
    pub fn begin(out: W, design: &Design, nodes: &[NodeId], about: &str) -> io::Result<Waves<W>> {
        let Header { text, clock, reset, variables } = Header::new(design, nodes, about);
        let mut out = BufWriter::with_capacity(PIECE, out);
        out.write_all(text.as_bytes())?;
        let rows = Rows::new(
            EDGES + variables.iter().map(|variable| variable.record.longest()).sum::<usize>(),
        );
        Ok(Waves { out, clock, reset, variables, rows, next: None })
    }

    /// Appends clocks that follow those written before; the columns must be those of the header.
    ///
    /// # Errors
    /// What the system says if the file cannot be written.
    pub fn append(&mut self, batch: &Batch) -> io::Result<()> {
        for first in (0..batch.clocks()).step_by(self.rows.count()) {
            let rows = first..batch.clocks().min(first + self.rows.count());
            let clock = batch.first_clock() + first as u64;
            self.rising_edges(clock, rows.len());
            self.changes(batch, rows.clone());
            self.falling_edges(clock, rows.len());
            self.rows.write(rows.len(), &mut self.out)?;
        }
        Ok(())
    }

    /// The lines that begin so many clocks. All signals follow the first edge, since none has had a
    /// value before.
    fn rising_edges(&mut self, first: u64, count: usize) {
        for row in 0..count {
            self.time(row, PERIOD * (first + row as u64));
            if self.next.is_none() && row == 0 {
                self.rows.line(row, b"$dumpvars\n");
                self.rows.bit(row, &self.reset, false);
            }
            self.rows.bit(row, &self.clock, true);
        }
    }

    fn changes(&mut self, batch: &Batch, rows: Range<usize>) {
        let first = u64::from(self.next.is_none());
        for variable in &mut self.variables {
            let lanes = batch.lanes(variable.column);
            let changed = changes(lanes, rows.clone(), &mut variable.last) | first;
            self.rows.values(changed, &variable.record, lanes.rows(rows.clone()));
        }
    }

    fn falling_edges(&mut self, first: u64, count: usize) {
        for row in 0..count {
            if self.next.is_none() {
                self.rows.line(row, b"$end\n");
            }
            let clock = first + row as u64;
            self.time(row, PERIOD * clock + PERIOD / 2);
            self.rows.bit(row, &self.clock, false);
            self.next = Some(clock + 1);
        }
    }

    fn time(&mut self, row: usize, time: u64) {
        let mut line = [b'\n'; 22];
        let (mut at, mut rest) = (line.len() - 1, time);
        loop {
            at -= 1;
            line[at] = b'0' + (rest % 10) as u8;
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        line[at - 1] = b'#';
        self.rows.line(row, &line[at - 1..]);
    }

    /// Ends the file with the time at which the last clock ends.
    ///
    /// # Errors
    /// What the system says if the file cannot be written.
    pub fn end(mut self) -> io::Result<()> {
        if let Some(next) = self.next {
            writeln!(self.out, "#{}", PERIOD * next)?;
        }
        self.out.flush()
    }
}

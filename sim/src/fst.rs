//! Waveforms as FST, the compressed format of GTKWave: the same signals at the same times as in the
//! [VCD](crate::vcd).
use std::io::{self, BufWriter, Seek, Write};

use fst_writer::{
    FstBodyWriter, FstFileType, FstHeaderWriter, FstInfo, FstScopeType, FstSignalId, FstSignalType,
    FstVarDirection, FstVarType, FstWriteError,
};
use specula_datapath::Design;
use specula_datapath::design::{NodeId, Scope, ScopeId};

use crate::changes::{BLOCK, Changes};
use crate::outline::{self, Entry, Outline};
use crate::vcd::PERIOD;
use crate::{Batch, Lanes, digits};

/// Bytes of changes that are gathered before they are written as a section of the file:
/// `fst-writer` collects each signal's from all over them, which takes half as long again where
/// they leave the cache, and larger sections make the file only 1 % smaller.
const SECTION: usize = 8 << 20;
/// The field for the program's name has 128 bytes, the last of them 0.
const LONGEST_VERSION: usize = 127;
/// Times are in units of 10^-9 seconds.
const NANOSECONDS: i8 = -9;

/// Waveforms that are written a batch of clocks at a time.
pub struct Waves<W: Write + Seek> {
    body: FstBodyWriter<BufWriter<W>>,
    clock: FstSignalId,
    reset: FstSignalId,
    variables: Vec<Variable>,
    changes: Changes,
    /// The clock behind the last one written; `None` before the first.
    next: Option<u64>,
}

/// A variable of the file.
#[derive(Clone, Copy, Debug)]
struct Variable {
    id: FstSignalId,
    /// Its column.
    column: usize,
    width: u32,
}

impl<W: Write + Seek> Waves<W> {
    /// Writes the header for `nodes`, each under the units it belongs to; constants are left out.
    /// `about` says what they are of.
    ///
    /// # Errors
    /// What the system says if `out` cannot be written.
    pub fn begin(out: W, design: &Design, nodes: &[NodeId], about: &str) -> io::Result<Waves<W>> {
        let mut header =
            Header(FstHeaderWriter::new(BufWriter::new(out), &info(about)).map_err(failed)?);
        header.unit(design.scope(ScopeId::TOP))?;
        let clock = header.variable("clock", 1, None)?;
        let reset = header.variable("reset", 1, None)?;
        let outline = Outline::new(design, nodes);
        let mut variables: Vec<Variable> = vec![];
        for entry in outline.entries {
            match entry {
                Entry::Unit(scope) => header.unit(scope)?,
                Entry::Signal(node, number) => {
                    let known = variables.get(number).map(|variable| variable.id);
                    let id = header.variable(&node.name, node.width(), known)?;
                    if known.is_none() {
                        let outline::Variable { column, width } = outline.variables[number];
                        variables.push(Variable { id, column, width });
                    }
                }
                Entry::End => header.0.up_scope().map_err(failed)?,
            }
        }
        let mut body = header.0.finish().map_err(failed)?;
        // What does not change is not written in the first place.
        body.set_deduplicate(false);
        let changes = Changes::new(variables.len());
        Ok(Waves { body, clock, reset, variables, changes, next: None })
    }

    /// Appends clocks that follow those written before; the columns must be those of the header.
    ///
    /// # Errors
    /// What the system says if the file cannot be written.
    pub fn append(&mut self, batch: &Batch) -> io::Result<()> {
        let lanes: Vec<Lanes> =
            self.variables.iter().map(|variable| batch.lanes(variable.column)).collect();
        for first in (0..batch.clocks()).step_by(BLOCK) {
            let rows = first..batch.clocks().min(first + BLOCK);
            self.changes.find(&lanes, rows.clone());
            for row in rows {
                let clock = batch.first_clock() + row as u64;
                self.rising_edge(clock)?;
                for signal in self.changes.at(row - first) {
                    let Variable { id, width, .. } = self.variables[signal];
                    let digits = digits::of(lanes[signal].get(row));
                    self.body.signal_change(id, &digits[64 - width as usize..]).map_err(failed)?;
                }
                self.falling_edge(clock)?;
            }
        }
        Ok(())
    }

    /// Begins a clock; what has been gathered is written first if it is a large section.
    fn rising_edge(&mut self, clock: u64) -> io::Result<()> {
        if self.body.size() >= SECTION {
            self.body.flush().map_err(failed)?;
        }
        self.body.time_change(PERIOD * clock).map_err(failed)?;
        if self.next.is_none() {
            self.body.signal_change(self.reset, b"0").map_err(failed)?;
        }
        self.next = Some(clock + 1);
        self.body.signal_change(self.clock, b"1").map_err(failed)
    }

    fn falling_edge(&mut self, clock: u64) -> io::Result<()> {
        self.body.time_change(PERIOD * clock + PERIOD / 2).map_err(failed)?;
        self.body.signal_change(self.clock, b"0").map_err(failed)
    }

    /// Ends the file with the time at which the last clock ends.
    ///
    /// # Errors
    /// What the system says if the file cannot be written.
    pub fn end(mut self) -> io::Result<()> {
        if let Some(next) = self.next {
            self.body.time_change(PERIOD * next).map_err(failed)?;
        }
        self.body.finish().map_err(failed)?.flush()
    }
}

/// The definitions of a file while they are written.
struct Header<W: Write + Seek>(FstHeaderWriter<W>);

impl<W: Write + Seek> Header<W> {
    fn unit(&mut self, scope: &Scope) -> io::Result<()> {
        self.0.scope(&scope.instance, &scope.unit, FstScopeType::Module).map_err(failed)
    }

    /// A name for a variable: for the one that is `known`, or for a new one.
    fn variable(
        &mut self,
        name: &str,
        width: u32,
        known: Option<FstSignalId>,
    ) -> io::Result<FstSignalId> {
        let name = if width > 1 { format!("{name} [{}:0]", width - 1) } else { name.to_owned() };
        let bits = FstSignalType::bit_vec(width);
        self.0.var(name, bits, FstVarType::Wire, FstVarDirection::Implicit, known).map_err(failed)
    }
}

/// What the file says of itself.
fn info(about: &str) -> FstInfo {
    FstInfo {
        start_time: 0,
        timescale_exponent: NANOSECONDS,
        version: about[..about.floor_char_boundary(LONGEST_VERSION)].replace('\0', "_"),
        // The same run gives the same bytes on every day.
        date: String::new(),
        file_type: FstFileType::Verilog,
    }
}

fn failed(error: FstWriteError) -> io::Error {
    match error {
        FstWriteError::Io(error) => error,
        other => io::Error::other(other),
    }
}

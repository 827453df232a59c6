//! Waveforms: a window of a simulation as a VCD [IEEE 1364-2005, section 18].
//!
//! Time is in nanoseconds and a clock takes 10: clock c begins with the rising edge at 10 c, so that a time means the same clock in
//! every window. `reset` is 0 throughout, since the clock of reset comes before clock 0.
use std::collections::HashSet;
use std::io::{self, BufWriter, Write};

use specula_hdl::Design;
use specula_hdl::design::{NodeId, Op, ScopeId};
use vcd::{IdCode, ReferenceIndex, SimulationCommand, TimescaleUnit, Value, VarType, Writer};

use crate::{Batch, Columns};

/// Nanoseconds from a rising edge to the next.
pub const PERIOD: u64 = 10;

/// Writes the waveforms of `columns` in one go; `about` says what they are of, such as the scene's name and the design's.
///
/// # Errors
/// What the system says if `out` cannot be written.
pub fn write(out: impl Write, design: &Design, columns: &Columns, about: &str) -> io::Result<()> {
    let mut waves = Waves::begin(out, design, &columns.nodes, about)?;
    waves.append(&columns.batch())?;
    waves.end()
}

/// Waveforms that are written a batch of clocks at a time.
pub struct Waves<W: Write> {
    out: BufWriter<W>,
    clock: IdCode,
    reset: IdCode,
    variables: Vec<Variable>,
    /// The clock behind the last one written; `None` before the first.
    next: Option<u64>,
}

/// A variable of the file.
struct Variable {
    code: IdCode,
    /// Its column.
    column: usize,
    width: u32,
    /// What was written last.
    last: i64,
}

impl<W: Write> Waves<W> {
    /// Writes the header for `nodes`, each under the units it belongs to; constants are left out.
    ///
    /// # Errors
    /// What the system says if `out` cannot be written.
    pub fn begin(out: W, design: &Design, nodes: &[NodeId], about: &str) -> io::Result<Waves<W>> {
        let mut out = BufWriter::new(out);
        let mut writer = Writer::new(&mut out);
        // A comment ends where the file says `$end`.
        writer.comment(&about.replace('$', "_"))?;
        writer.timescale(1, TimescaleUnit::NS)?;
        let mut header = Header::new(writer, design, nodes);
        let (clock, reset) = header.core()?;
        header.writer.enddefinitions()?;
        let variables = header.variables;
        Ok(Waves { out, clock, reset, variables, next: None })
    }

    /// Appends clocks that follow those written before; the columns must be those of the header.
    ///
    /// # Errors
    /// What the system says if the file cannot be written.
    pub fn append(&mut self, columns: &Batch) -> io::Result<()> {
        for (row, clock) in columns.span().enumerate() {
            Writer::new(&mut self.out).timestamp(PERIOD * clock)?;
            match self.next {
                None => self.first_row(columns)?,
                Some(_) => self.changes(columns, row)?,
            }
            let mut writer = Writer::new(&mut self.out);
            writer.timestamp(PERIOD * clock + PERIOD / 2)?;
            writer.change_scalar(self.clock, Value::V0)?;
            self.next = Some(clock + 1);
        }
        Ok(())
    }

    fn first_row(&mut self, columns: &Batch) -> io::Result<()> {
        let mut writer = Writer::new(&mut self.out);
        writer.begin(SimulationCommand::Dumpvars)?;
        writer.change_scalar(self.clock, Value::V1)?;
        writer.change_scalar(self.reset, Value::V0)?;
        for variable in &mut self.variables {
            variable.last = columns.lanes()[variable.column].get(0);
            variable.write(&mut writer)?;
        }
        writer.end()
    }

    fn changes(&mut self, columns: &Batch, row: usize) -> io::Result<()> {
        let mut writer = Writer::new(&mut self.out);
        writer.change_scalar(self.clock, Value::V1)?;
        for variable in &mut self.variables {
            let raw = columns.lanes()[variable.column].get(row);
            if raw != variable.last {
                variable.last = raw;
                variable.write(&mut writer)?;
            }
        }
        Ok(())
    }

    /// Ends the file with the time at which the last clock ends.
    ///
    /// # Errors
    /// What the system says if the file cannot be written.
    pub fn end(mut self) -> io::Result<()> {
        if let Some(next) = self.next {
            Writer::new(&mut self.out).timestamp(PERIOD * next)?;
        }
        self.out.flush()
    }
}

impl Variable {
    fn write(&self, writer: &mut Writer<impl Write>) -> io::Result<()> {
        let bit = |number: u32| if self.last >> number & 1 == 1 { Value::V1 } else { Value::V0 };
        if self.width == 1 {
            return writer.change_scalar(self.code, bit(0));
        }
        let mut bits = [Value::V0; 64];
        let bits = &mut bits[..self.width as usize];
        (0..self.width).rev().zip(bits.iter_mut()).for_each(|(number, place)| *place = bit(number));
        writer.change_vector(self.code, bits)
    }
}

/// The definitions of a file while they are written.
struct Header<'a, W: Write> {
    writer: Writer<W>,
    design: &'a Design,
    nodes: &'a [NodeId],
    /// Units in which something is shown, and those around them.
    shown: HashSet<ScopeId>,
    variables: Vec<Variable>,
}

impl<'a, W: Write> Header<'a, W> {
    fn new(writer: Writer<W>, design: &'a Design, nodes: &'a [NodeId]) -> Header<'a, W> {
        let mut shown = HashSet::new();
        for &node in nodes {
            let mut at = Some(design.node(node).scope);
            while let Some(scope) = at.filter(|&scope| shown.insert(scope)) {
                at = design.scope(scope).parent;
            }
        }
        Header { writer, design, nodes, shown, variables: vec![] }
    }

    /// The core, which has a clock and a reset beside its signals.
    fn core(&mut self) -> io::Result<(IdCode, IdCode)> {
        self.writer.add_module(&self.design.scope(ScopeId::TOP).instance)?;
        let clock = self.writer.add_wire(1, "clock")?;
        let reset = self.writer.add_wire(1, "reset")?;
        self.inside(ScopeId::TOP)?;
        Ok((clock, reset))
    }

    /// Signals and inner units of a unit, and its end.
    fn inside(&mut self, scope: ScopeId) -> io::Result<()> {
        for (column, &id) in self.nodes.iter().enumerate() {
            let node = self.design.node(id);
            if node.scope == scope && !matches!(node.op, Op::Constant(_)) {
                let width = node.width();
                let range = (width > 1).then_some(ReferenceIndex::Range(width - 1, 0));
                let code = self.writer.add_var(VarType::Wire, width, &node.name, range)?;
                self.variables.push(Variable { code, column, width, last: 0 });
            }
        }
        for index in 0..self.design.scopes.len() as u32 {
            let inner = ScopeId(index);
            if self.design.scope(inner).parent == Some(scope) && self.shown.contains(&inner) {
                self.writer.add_module(&self.design.scope(inner).instance)?;
                self.inside(inner)?;
            }
        }
        self.writer.upscope()
    }
}

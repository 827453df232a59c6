//! Sinks for the batches that an engine of this workspace delivers.
use std::fs::File;
use std::hint::black_box;
use std::io::{self, Sink, Write};
use std::path::Path;

use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_sim::{Batch, fst, vcd};

use super::Mode;

/// A sink of batches.
pub(crate) trait BatchSink {
    /// Takes a batch.
    fn take(&mut self, batch: &Batch) -> io::Result<()>;

    /// Ends the sink after the last batch.
    fn end(self: Box<Self>) -> io::Result<()>;
}

/// The sink that `mode` asks for, for these signals; waveforms are written to `file`.
pub(crate) fn batch_sink(
    mode: Mode,
    design: &Design,
    nodes: &[NodeId],
    file: &Path,
) -> io::Result<Box<dyn BatchSink>> {
    const ABOUT: &str = "Specula, a measurement";
    Ok(match mode {
        Mode::Outputs => Box::new(Nothing),
        Mode::EverySignal => Box::new(Glance { column: 0 }),
        Mode::Vcd => Box::new(vcd::Waves::begin(File::create(file)?, design, nodes, ABOUT)?),
        Mode::VcdNull => Box::new(vcd::Waves::<Sink>::begin(io::sink(), design, nodes, ABOUT)?),
        Mode::Fst => Box::new(fst::Waves::begin(File::create(file)?, design, nodes, ABOUT)?),
    })
}

/// Discards every batch: the outputs are summed elsewhere.
struct Nothing;

impl BatchSink for Nothing {
    fn take(&mut self, _: &Batch) -> io::Result<()> {
        Ok(())
    }

    fn end(self: Box<Self>) -> io::Result<()> {
        Ok(())
    }
}

/// Reads one value of one signal after the other, batch by batch, so that the compiler cannot know
/// which of them are read. Verilator's signals are not read either, although they could be.
struct Glance {
    /// Number of the next signal.
    column: usize,
}

impl BatchSink for Glance {
    fn take(&mut self, batch: &Batch) -> io::Result<()> {
        if let Some(last) = batch.clocks().checked_sub(1) {
            black_box(batch.lanes(self.column).get(last));
            self.column = (self.column + 1) % batch.nodes().len();
        }
        black_box(batch);
        Ok(())
    }

    fn end(self: Box<Self>) -> io::Result<()> {
        Ok(())
    }
}

impl<W: Write> BatchSink for vcd::Waves<W> {
    fn take(&mut self, batch: &Batch) -> io::Result<()> {
        self.append(batch)
    }

    fn end(self: Box<Self>) -> io::Result<()> {
        (*self).end()
    }
}

impl BatchSink for fst::Waves<File> {
    fn take(&mut self, batch: &Batch) -> io::Result<()> {
        self.append(batch)
    }

    fn end(self: Box<Self>) -> io::Result<()> {
        (*self).end()
    }
}

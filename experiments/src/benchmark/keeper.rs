//! What is done with the batches that an engine of ours hands over.
use std::fs::File;
use std::hint::black_box;
use std::io::{self, Sink, Write};
use std::path::Path;

use specula_hdl::Design;
use specula_hdl::design::NodeId;
use specula_sim::{Batch, fst, vcd};

use super::Mode;

/// Takes batches.
pub(crate) trait Keeper {
    /// Takes one.
    fn take(&mut self, batch: &Batch) -> io::Result<()>;

    /// There are no more.
    fn end(self: Box<Self>) -> io::Result<()>;
}

/// What `mode` asks for, of these signals; files go to `file`.
pub(crate) fn keeper(
    mode: Mode,
    design: &Design,
    nodes: &[NodeId],
    file: &Path,
) -> io::Result<Box<dyn Keeper>> {
    const ABOUT: &str = "Specula, a measurement";
    Ok(match mode {
        Mode::Outputs => Box::new(Nothing),
        Mode::EverySignal => Box::new(Glance { column: 0 }),
        Mode::Vcd => Box::new(vcd::Waves::begin(File::create(file)?, design, nodes, ABOUT)?),
        Mode::VcdNull => Box::new(vcd::Waves::<Sink>::begin(io::sink(), design, nodes, ABOUT)?),
        Mode::Fst => Box::new(fst::Waves::begin(File::create(file)?, design, nodes, ABOUT)?),
    })
}

/// Keeps nothing: the outputs are added up anyway.
struct Nothing;

impl Keeper for Nothing {
    fn take(&mut self, _: &Batch) -> io::Result<()> {
        Ok(())
    }

    fn end(self: Box<Self>) -> io::Result<()> {
        Ok(())
    }
}

/// Looks at one value of one signal after the other, batch by batch, so that nobody can know which
/// of them are read. Verilator's signals, which anybody may read, are not read either.
struct Glance {
    /// Number of the signal that is next.
    column: usize,
}

impl Keeper for Glance {
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

impl<W: Write> Keeper for vcd::Waves<W> {
    fn take(&mut self, batch: &Batch) -> io::Result<()> {
        self.append(batch)
    }

    fn end(self: Box<Self>) -> io::Result<()> {
        (*self).end()
    }
}

impl Keeper for fst::Waves<File> {
    fn take(&mut self, batch: &Batch) -> io::Result<()> {
        self.append(batch)
    }

    fn end(self: Box<Self>) -> io::Result<()> {
        (*self).end()
    }
}

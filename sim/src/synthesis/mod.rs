//! What an FPGA tool makes of designs: Yosys, for the ECP5, whose cells it maps without any
//! vendor's program.
//!
//! Modules are synthesised one by one, without flattening, and each distinct one once, whichever
//! designs it is in; the cells of a design are those of its modules, as often as they stand in it.
//! So nothing is optimised across the borders of modules: where the builder has left out what is
//! constant and unread there is little to be found.
mod cells;
mod counts;
mod job;

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use rayon::prelude::*;
use specula_datapath::Design;
use specula_datapath::verilog::{Library, LongDelays};

use crate::SimError;

pub use counts::cells;

pub use cells::Synthesised;

/// How far synthesis has come.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Distinct modules that are done.
    pub done: usize,
    /// Distinct modules there are.
    pub modules: usize,
}

/// Synthesises designs by themselves, without pads, in as many runs of Yosys at a time as there are
/// processors. A big design takes some ten seconds.
///
/// # Errors
/// [`SimError::ToolAbsent`] if Yosys is not installed, [`SimError::ToolFailed`] if it fails.
pub fn synthesise(
    designs: &[&Design],
    watch: &(dyn Fn(Progress) + Sync),
) -> Result<Vec<Synthesised>, SimError> {
    // Flip-flops, of which cores differ in number, are what is counted.
    let mut library = Library::new("core", LongDelays::ShiftRegisters);
    let tops: Vec<usize> = designs.iter().map(|design| library.add(&design.to_block())).collect();
    let modules = library.modules().len();
    let mut cells = vec![Synthesised::default(); modules];
    let done = AtomicUsize::new(0);
    let run = |places: Vec<usize>| {
        let counted = job::run(&library, &places)?;
        let before = done.fetch_add(places.len(), Ordering::Relaxed);
        watch(Progress { done: before + places.len(), modules });
        Ok(places.into_iter().zip(counted).collect::<Vec<_>>())
    };
    let processors = thread::available_parallelism().map_or(1, NonZero::get);
    let jobs = job::shared_out(&library, processors);
    // One after the other as a processor becomes free, the longest first.
    let counted = jobs.into_iter().par_bridge().map(run).collect::<Result<Vec<_>, SimError>>()?;
    for (place, own) in counted.into_iter().flatten() {
        cells[place] = own;
    }
    Ok(with_children(&library, cells, &tops))
}

/// Cells of the modules in the places `tops`, with all that is in them, from each module's own.
fn with_children(
    library: &Library,
    mut cells: Vec<Synthesised>,
    tops: &[usize],
) -> Vec<Synthesised> {
    // Children come first, so that theirs are whole by then.
    for (place, module) in library.modules().iter().enumerate() {
        for &child in &module.children {
            let of_child = cells[child];
            cells[place] += of_child;
        }
    }
    tops.iter().map(|&top| cells[top]).collect()
}

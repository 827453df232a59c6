//! The waveform of a run.
use std::fs::File;
use std::io;
use std::path::Path;

use specula_sim::Flow;
use specula_sim::gtkw::{self, View};
use specula_testbench::Bench;
use specula_testbench::trace::{Choice, WORST_WINDOW};

use crate::disagreement::Disagreement;
use crate::error::ToolError;
use crate::output::Staging;
use crate::progress;
use crate::run::Run;
use crate::trace_file::TraceFile;

/// GTKWave's save file.
pub const SAVE_FILE: &str = "trace.gtkw";

/// The clocks to trace: what the user chose, or the surroundings of the first disagreement if the
/// user named no clocks.
pub fn choice(asked: &Choice, disagreement: Option<&Disagreement>) -> Choice {
    match (asked, disagreement) {
        (Choice::Worst | Choice::None, Some(disagreement)) => {
            let first = disagreement.first_clock().saturating_sub(WORST_WINDOW / 2);
            Choice::Cycles(first..first + WORST_WINDOW)
        }
        _ => asked.clone(),
    }
}

/// Checks before a run that it will have the clocks that `choice` asks for.
pub fn check(choice: &Choice, bench: &Bench) -> Result<(), ToolError> {
    let clocks = bench.clocks() + 1;
    let missing = |asked: String, there: String| Err(ToolError::Trace { asked, there });
    match choice {
        Choice::Span(index) if *index >= bench.frame.spans.len() => missing(
            format!("span {index}"),
            format!("spans 0 to {}", bench.frame.spans.len().saturating_sub(1)),
        ),
        Choice::Cycles(range) if range.start >= clocks => {
            missing(format!("cycle {}", range.start), format!("cycles 0 to {}", clocks - 1))
        }
        _ => Ok(()),
    }
}

/// Writes the waveform of a run into the file `name`.
pub fn write(run: &Run, staging: &Staging, name: &str) -> Result<(), ToolError> {
    Ok(dump(&staging.file(name), run, &run.trace)?.map_err(staging.failed(name))?)
}

/// Writes GTKWave's save file of a run that has a waveform into the file `name`.
pub fn write_save_file(run: &Run, staging: &Staging, name: &str) -> Result<(), ToolError> {
    let Some(window) = run.window.clone() else { return Ok(()) };
    let marker = run.clock_to_look_at().filter(|clock| window.contains(clock));
    let view = View { dump_file: run.trace_format.file_name(), window, marker };
    let design = &run.bench.design;
    let write = |file: File| gtkw::write(file, design, &gtkw::interesting(design), &view);
    Ok(File::create(staging.file(name)).and_then(write).map_err(staging.failed(name))?)
}

/// Writes a dump of the clocks of `choice`. The outer error is that they cannot be simulated, the
/// inner one that the file cannot be written.
///
/// The clocks go from the engine to the file a batch at a time, so that a long run does not have to
/// fit into memory.
pub fn dump(path: &Path, run: &Run, choice: &Choice) -> Result<io::Result<()>, ToolError> {
    let file = match File::create(path) {
        Ok(file) => file,
        Err(error) => return Ok(Err(error)),
    };
    let about = format!(
        "Specula {}, scene {}, method {}",
        env!("CARGO_PKG_VERSION"),
        run.job.origin.scene,
        run.bench.spec.method().name()
    );
    let mut dump = TraceFile::new(file, run.trace_format, &run.bench.design, &about);
    let mut written = Ok(());
    let bar = progress::bar("tracing", run.outcome.cycles + 1);
    let traced = run.bench.trace(run.engine, choice, run.outcome, &mut |columns| {
        bar.set_position(columns.span().end);
        written = dump.append(columns);
        if written.is_ok() { Flow::Continue } else { Flow::Stop }
    });
    bar.finish_and_clear();
    traced?;
    Ok(written.and_then(|()| dump.end()))
}

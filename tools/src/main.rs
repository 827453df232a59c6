//! Specula's command line: a scene goes in, checked shading hardware comes out.
mod arguments;
mod cli;
mod clock;
mod cmd_bench;
mod cmd_compare;
mod cmd_completions;
mod cmd_explore;
mod cmd_generate;
mod cmd_manual;
mod cmd_methods;
mod cmd_needs;
mod cmd_new;
mod cmd_prove;
mod cmd_reproduce;
mod cmd_run;
mod cmd_scenes;
mod cmd_schedule;
mod cmd_stress;
mod cmd_synth;
mod cmd_wave;
mod device;
mod disagreement;
mod error;
mod frame_vectors;
mod html;
mod job;
mod made_for;
mod messages;
mod output;
mod picture;
mod plot;
mod ports;
mod progress;
mod report;
mod run;
mod scene;
mod sequence;
mod stream_top;
mod table;
mod target_arguments;
mod trace_file;
mod verdict;
mod verilog;
mod waveform;
mod worst_pixel;

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

use cli::Cli;
use error::ToolError;
use output::Interrupts;
use verdict::Verdict;

/// Exit status of a run in which a pixel, a clock or a fact was wrong.
const DISAGREES: u8 = 1;
/// Exit status of every failure; clap returns the same for a wrong command line.
const REFUSED: u8 = 2;

fn main() -> ExitCode {
    messages::install();
    let cli = Cli::parse();
    // Without handlers, the next run removes what a signal leaves.
    let interrupts = Interrupts::watch().unwrap_or_default();
    let ended = cli.command.execute(&mut io::stdout().lock(), &interrupts);
    // Files that a signal's handler removes cause no error message: the program ends with the
    // signal's status.
    let _held = interrupts.hold();
    match ended {
        Ok(Verdict::Done) => ExitCode::SUCCESS,
        Ok(Verdict::Disagrees) => ExitCode::from(DISAGREES),
        // The reader closed the pipe, for example `head`.
        Err(ToolError::Print(error)) if error.kind() == io::ErrorKind::BrokenPipe => {
            ExitCode::SUCCESS
        }
        Err(error) => {
            // The exit status says the same even if standard error is closed.
            let _ = writeln!(io::stderr(), "{:?}", miette::Report::new(error));
            ExitCode::from(REFUSED)
        }
    }
}

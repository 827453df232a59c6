//! Why a waveform cannot be drawn.
use std::io;
use std::path::PathBuf;

use miette::Diagnostic;
use thiserror::Error;

/// Why a waveform cannot be drawn.
#[derive(Debug, Error, Diagnostic)]
pub enum WaveError {
    /// The operating system cannot read the file.
    #[error("`{}` cannot be read: {reason}", path.display())]
    #[diagnostic(
        code(specula::wave::unreadable),
        help("check the path; `specula run` writes its waveform as `trace.vcd`")
    )]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The operating system's error.
        reason: io::Error,
    },
    /// The file is of another kind.
    #[error("`{}` is neither a VCD nor an FST file", path.display())]
    #[diagnostic(
        code(specula::wave::kind),
        help(
            "give what a simulator dumped: `trace.vcd` of `specula run`, or what `$dumpfile` names in a Verilog simulator"
        )
    )]
    Kind {
        /// The file.
        path: PathBuf,
    },
    /// The file begins well, but later something is wrong.
    #[error("`{}` is damaged or incomplete: {reason}", path.display())]
    #[diagnostic(
        code(specula::wave::damaged),
        help(
            "let the simulation end before its dump is read, copy the file again, or convert it with another tool"
        )
    )]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// The file contains nothing that could be drawn.
    #[error("`{}` holds no {missing}{passed_over}", path.display())]
    #[diagnostic(
        code(specula::wave::empty),
        help("dump at least one signal over some time, in Verilog with `$dumpvars`")
    )]
    Empty {
        /// The file.
        path: PathBuf,
        /// What it should hold.
        missing: &'static str,
        /// What it holds instead, a line for each kind of thing.
        passed_over: String,
    },
    /// No signal has the name.
    #[error("no signal is named `{pattern}`")]
    #[diagnostic(
        code(specula::wave::signals),
        help(
            "{near}`*` and `?` match in full names, `top.unit.signal`, dots too; there are, for example, {there}"
        )
    )]
    Signals {
        /// What was asked for.
        pattern: String,
        /// The name that was probably meant, as a sentence.
        near: String,
        /// Some names that exist.
        there: String,
    },
    /// No unit has the name.
    #[error("no unit is named `{unit}`")]
    #[diagnostic(
        code(specula::wave::unit),
        help("{near}there are {there}; a signal's full name is that of `--signals`")
    )]
    Unit {
        /// What was asked for.
        unit: String,
        /// The name that was probably meant, as a sentence.
        near: String,
        /// Units that exist.
        there: String,
    },
    /// The window is empty or outside of the file.
    #[error("`{asked}` leaves nothing to draw: the file has {there}")]
    #[diagnostic(
        code(specula::wave::window),
        help("choose among those, with `--to` not before `--from`")
    )]
    Window {
        /// What was asked for.
        asked: String,
        /// What the file has.
        there: String,
    },
    /// The drawing would be too large to be of use.
    #[error("a drawing of {amount} in {signals} rows is too large")]
    #[diagnostic(
        code(specula::wave::large),
        help("choose fewer signals with `--signals` or a shorter time with `--from` and `--to`")
    )]
    Large {
        /// Number of rows.
        signals: usize,
        /// The quantity that is too large, with its unit.
        amount: String,
    },
    /// The picture's file name does not say what to write.
    #[error("`{}` is the name of no picture that can be written", path.display())]
    #[diagnostic(
        code(specula::wave::picture),
        help("end it in `.svg` or `.png`, or leave `-o` out to have the waveform as text")
    )]
    Picture {
        /// The name.
        path: PathBuf,
    },
}

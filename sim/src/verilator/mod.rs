//! Verilator: the emitted Verilog, compiled to a program.
mod common;
mod glue;
mod library;
mod program;
mod timed;

use std::time::{Duration, Instant};

use specula_datapath::Design;
use specula_datapath::design::NodeId;

use crate::external::{
    OTHER_ENGINE, RESULTS, STIMULUS, Sampling, TRACE, Tool, Trace, Workshop, read_results, tool,
};
use crate::{Batch, Engine, Flow, SimError, Stimulus};

use common::Common;
pub use library::Library;
use program::{PROGRAM, Program};
pub use timed::{Keeping, TimedVerilator, Timing};

/// Verilator, version 5.
pub const VERILATOR: Tool = Tool {
    name: "Verilator",
    command: "verilator",
    version_argument: "--version",
    install: "install it with `apt install verilator g++ make` (Debian, Ubuntu) or `brew install verilator` (macOS)",
    otherwise: OTHER_ENGINE,
};

/// The program that drives a core; what depends on the core is in the header that [`glue`] writes.
const MAIN: &str = include_str!("main.cpp");
/// The headers that it needs for any core.
const HEADERS: &str = include_str!("headers.h");
/// The file that holds them.
const HEADERS_FILE: &str = "headers.h";

/// Runs a design's Verilog in Verilator.
///
/// All registers begin as 0 and one clock of reset comes first, so every value at every clock
/// equals rust-hdl's.
pub struct Verilator<'a> {
    design: &'a Design,
    workshop: Workshop,
    effort: Effort,
    library: Option<Library>,
    /// Whether the program that writes ports is built, and the one that traces.
    built: [bool; 2],
    build_time: Duration,
}

/// What the C++ compiler is to spend its time on. The program and its values are the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// A fast program: for long runs, and for measuring.
    FastRun,
    /// A program soon: for runs of up to some ten thousand clocks.
    FastBuild,
}

impl Effort {
    /// The compiler's option.
    const fn option(self) -> &'static str {
        match self {
            Effort::FastRun => "-O3",
            Effort::FastBuild => "-O0",
        }
    }

    /// Variables of Verilator's makefile, which puts its own options behind those that it is given
    /// for all compilations.
    fn make_variables(self) -> [String; 3] {
        ["OPT_FAST", "OPT_SLOW", "OPT_GLOBAL"]
            .map(|variable| format!("{variable}={}", self.option()))
    }
}

/// What a program gives back.
#[derive(Clone, Copy)]
enum Kind {
    Ports,
    Trace,
}

impl Kind {
    /// Directory of its object files.
    const fn directory(self) -> &'static str {
        match self {
            Kind::Ports => "ports",
            Kind::Trace => "trace",
        }
    }

    /// Verilator's options for it.
    const fn options(self) -> &'static [&'static str] {
        match self {
            Kind::Ports => &[],
            // Delay lines are wider than what is traced unless asked for.
            Kind::Trace => &["--trace", "--trace-max-width", "0"],
        }
    }

    /// The core's Verilog for it.
    fn source(self, workshop: &Workshop) -> &str {
        match self {
            Kind::Ports => &workshop.source,
            Kind::Trace => &workshop.traced_source,
        }
    }
}

impl<'a> Verilator<'a> {
    /// An engine for `design`. Programs are built when they are first needed.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] if Verilator is not installed, [`SimError::File`] if there is no
    /// room for the Verilog.
    pub fn new(design: &'a Design, effort: Effort) -> Result<Verilator<'a>, SimError> {
        Verilator::present()?;
        let workshop = Workshop::new(design)?;
        workshop.write("main.cpp", MAIN)?;
        workshop.write(HEADERS_FILE, HEADERS)?;
        workshop.write("ports.h", &glue::header(&workshop.ports))?;
        Ok(Verilator {
            design,
            workshop,
            effort,
            library: None,
            built: [false; 2],
            build_time: Duration::ZERO,
        })
    }

    /// The engine with programs whose common parts are compiled once, for all that are given this
    /// library.
    pub fn with_library(self, library: Library) -> Verilator<'a> {
        Verilator { library: Some(library), ..self }
    }

    /// Whether Verilator is installed.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] says how to install it.
    pub fn present() -> Result<(), SimError> {
        VERILATOR.present()
    }

    /// Builds the program that watching these signals needs, unless it is built already: ports are
    /// read directly, signals inside the core from a trace.
    ///
    /// # Errors
    /// [`SimError::ToolFailed`] with what Verilator or the C++ compiler printed, warnings included.
    pub fn prepare(&mut self, watched: &[NodeId]) -> Result<(), SimError> {
        let kind =
            if self.workshop.ports.numbers(watched).is_some() { Kind::Ports } else { Kind::Trace };
        self.build(kind)
    }

    /// Seconds spent on building so far.
    pub fn build_seconds(&self) -> f64 {
        self.build_time.as_secs_f64()
    }

    fn build(&mut self, kind: Kind) -> Result<(), SimError> {
        if self.built[kind as usize] {
            return Ok(());
        }
        let begin = Instant::now();
        let common =
            self.library.as_ref().map(|library| library.common(kind, self.effort)).transpose()?;
        let (directory, options) = (kind.directory(), kind.options());
        let program = Program {
            directory,
            source: kind.source(&self.workshop),
            main: "main.cpp",
            effort: self.effort,
            options,
            common: common.as_ref(),
        };
        program.build(&self.workshop)?;
        self.build_time += begin.elapsed();
        self.built[kind as usize] = true;
        Ok(())
    }

    /// Builds the program if need be and runs it.
    fn execute(
        &mut self,
        kind: Kind,
        stimulus: &Stimulus,
        output: &str,
        ports: &[usize],
    ) -> Result<(), SimError> {
        self.build(kind)?;
        self.workshop.write_stimulus(stimulus, self.design)?;
        let program = self.workshop.path().join(kind.directory()).join(PROGRAM);
        let files = [STIMULUS, output].map(str::to_owned);
        let arguments: Vec<String> =
            files.into_iter().chain(ports.iter().map(usize::to_string)).collect();
        tool::run(program.as_os_str(), self.workshop.path(), &arguments)
    }
}

impl Engine for Verilator<'_> {
    fn name(&self) -> &'static str {
        "verilator"
    }

    fn run(
        &mut self,
        stimulus: &Stimulus,
        watched: &[NodeId],
        sink: &mut dyn FnMut(&Batch) -> Flow,
    ) -> Result<(), SimError> {
        if watched.is_empty() {
            return Ok(());
        }
        let clocks = stimulus.clocks();
        match self.workshop.ports.numbers(watched) {
            Some(ports) => {
                self.execute(Kind::Ports, stimulus, RESULTS, &ports)?;
                read_results(
                    self.workshop.open(RESULTS)?,
                    VERILATOR.name,
                    self.design,
                    watched,
                    clocks,
                    sink,
                )
            }
            None => {
                self.execute(Kind::Trace, stimulus, TRACE, &[])?;
                let core = self.workshop.ports.core.clone();
                let trace = Trace {
                    tool: VERILATOR.name,
                    root: &["TOP", &core],
                    sampling: Sampling { first: 0, period: 1 },
                };
                trace.read(self.workshop.open(TRACE)?, self.design, watched, clocks, sink)
            }
        }
    }
}

//! Icarus Verilog: the emitted Verilog under a testbench, in four values.
mod bench;

use std::time::{Duration, Instant};

use specula_datapath::Design;
use specula_datapath::design::NodeId;

use crate::external::{OTHER_ENGINE, RESULTS, TRACE, Tool, Trace, Workshop, read_results};
use crate::{Batch, Engine, Flow, SimError, Stimulus};

use bench::Watch;

const INSTALL: &str = "install it with `apt install iverilog` (Debian, Ubuntu) or `brew install icarus-verilog` (macOS)";
/// Icarus Verilog's compiler.
pub const ICARUS: Tool = Tool {
    name: "Icarus Verilog",
    command: "iverilog",
    version_argument: "-V",
    install: INSTALL,
    otherwise: OTHER_ENGINE,
};
/// Icarus Verilog's program that runs what the compiler makes.
pub const ICARUS_RUNTIME: Tool = Tool { command: "vvp", ..ICARUS };

/// Runs a design's Verilog in Icarus.
///
/// Registers begin as X. What is still X when the pipeline is not filled yet is given as 0, bit by
/// bit; from the first valid pixel on, values that belong to valid pixels equal rust-hdl's.
pub struct Icarus<'a> {
    design: &'a Design,
    workshop: Workshop,
    /// Clocks of a run that a reset cuts off before each run.
    interrupted: Option<u64>,
    /// What it warns of.
    warnings: &'static [&'static str],
    /// What the program that is built watches.
    built: Option<Watch>,
    build_time: Duration,
}

impl<'a> Icarus<'a> {
    /// An engine for `design`. Programs are built when they are needed.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] if Icarus is not installed, [`SimError::File`] if there is no room
    /// for the Verilog.
    pub fn new(design: &'a Design) -> Result<Icarus<'a>, SimError> {
        Icarus::of(design, Workshop::new, &["-Wall"])
    }

    /// An engine for what a synthesiser has made of `design`: Verilog of a module of its name with its
    /// ports, and of all cells in it. Of its signals the ports alone can be watched.
    ///
    /// # Errors
    /// As [`Icarus::new`].
    pub fn of_netlist(design: &'a Design, netlist: &str) -> Result<Icarus<'a>, SimError> {
        // Cells have ports that are left open.
        Icarus::of(design, |design| Workshop::of_netlist(design, netlist), &[])
    }

    fn of(
        design: &'a Design,
        workshop: impl FnOnce(&Design) -> Result<Workshop, SimError>,
        warnings: &'static [&'static str],
    ) -> Result<Icarus<'a>, SimError> {
        Icarus::present()?;
        let workshop = workshop(design)?;
        let (interrupted, built, build_time) = (None, None, Duration::ZERO);
        Ok(Icarus { design, workshop, interrupted, warnings, built, build_time })
    }

    /// The same engine, in which each run comes behind one that is interrupted: so many clocks of the
    /// same stimulus, which nothing has reset, and then the reset while pixels are under way. Until the
    /// first pixel and at the reset all pins are X. Values that belong to valid pixels are the same,
    /// and no pixel leaves that did not enter behind the reset.
    pub fn behind_an_interruption(self, clocks: u64) -> Icarus<'a> {
        Icarus { interrupted: Some(clocks), built: None, ..self }
    }

    /// Whether Icarus is installed.
    ///
    /// # Errors
    /// [`SimError::ToolAbsent`] says how to install it.
    pub fn present() -> Result<(), SimError> {
        ICARUS.present()?;
        ICARUS_RUNTIME.present()
    }

    /// Builds the program that watching these signals needs, unless it was built last.
    ///
    /// # Errors
    /// [`SimError::ToolFailed`] with what Icarus printed, warnings included.
    pub fn prepare(&mut self, watched: &[NodeId]) -> Result<(), SimError> {
        let watch = self.workshop.ports.numbers(watched).map_or(Watch::Everything, Watch::Ports);
        if self.built.as_ref() == Some(&watch) {
            return Ok(());
        }
        let begin = Instant::now();
        self.built = None;
        self.workshop
            .write("bench.v", &bench::text(&self.workshop.ports, &watch, self.interrupted))?;
        let source = match watch {
            Watch::Ports(_) => &self.workshop.source,
            Watch::Everything => &self.workshop.traced_source,
        };
        let files = ["-s", bench::NAME, "-o", "run.vvp", "bench.v", source];
        let arguments = ["-g2001"].iter().chain(self.warnings).chain(&files);
        let arguments: Vec<String> = arguments.map(|&argument| argument.to_owned()).collect();
        ICARUS.run(self.workshop.path(), &arguments)?;
        self.build_time += begin.elapsed();
        self.built = Some(watch);
        Ok(())
    }

    /// Seconds spent on building so far.
    pub fn build_seconds(&self) -> f64 {
        self.build_time.as_secs_f64()
    }
}

impl Engine for Icarus<'_> {
    fn name(&self) -> &'static str {
        "icarus"
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
        self.prepare(watched)?;
        self.workshop.write_stimulus(stimulus, self.design)?;
        ICARUS_RUNTIME.run(self.workshop.path(), &["-n", "run.vvp"].map(str::to_owned))?;
        let clocks = stimulus.clocks();
        if self.built == Some(Watch::Everything) {
            let trace = Trace {
                tool: ICARUS.name,
                root: &[bench::NAME, bench::INSTANCE],
                sampling: bench::sampling(self.interrupted),
            };
            return trace.read(self.workshop.open(TRACE)?, self.design, watched, clocks, sink);
        }
        read_results(self.workshop.open(RESULTS)?, ICARUS.name, self.design, watched, clocks, sink)
    }
}

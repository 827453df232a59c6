//! Engines that are separate programs.
use std::path::{Path, PathBuf};
use std::rc::Rc;

use specula_sim::{Icarus, Stimulus, TimedVerilator, Timing};

use super::batch_sink::batch_sink;
use super::checksum::Checksum;
use super::clocked::timed;
use super::runner::{Runner, Timed};
use super::scratch::Scratch;
use super::workload::Workload;
use super::{Config, MeasureError, Mode};
use specula_testbench::{Bench, EngineKind};

/// The file in which waveforms are discarded.
const NOWHERE: &str = if cfg!(windows) { "NUL" } else { "/dev/null" };

/// Verilator. Its program times itself.
pub(crate) struct Verilated<'a> {
    pub program: Rc<TimedVerilator>,
    pub scratch: &'a Scratch,
    pub mode: Mode,
}

impl Verilated<'_> {
    fn dump(&self) -> PathBuf {
        if self.mode == Mode::VcdNull { Path::new(NOWHERE).to_owned() } else { self.scratch.file() }
    }
}

impl Runner for Verilated<'_> {
    fn config(&self) -> Config {
        Config { variant: Some("-O3"), ..Config::only(EngineKind::Verilator, self.mode) }
    }

    fn start_up(&mut self) -> Result<f64, MeasureError> {
        Ok(self.program.build_seconds())
    }

    fn run(&mut self, spans: usize) -> Result<Timed, MeasureError> {
        let result = self.program.run(spans, &self.dump());
        self.scratch.clear();
        let Timing { seconds, clocks, sums } = result?;
        let sum = |channel: usize| sums.get(channel).copied().unwrap_or(0);
        Ok(Timed { seconds, clocks, checksum: Checksum(std::array::from_fn(sum)) })
    }
}

/// Icarus. The measured time includes the start of its program, reading the stimulus from a file
/// and writing the outputs to another: the simulation is so slow that this does not matter.
pub(crate) struct Interpreted<'a> {
    pub bench: &'a Bench<'a>,
    pub workload: &'a Workload,
    pub engine: Icarus<'a>,
    pub scratch: &'a Scratch,
}

impl Runner for Interpreted<'_> {
    fn config(&self) -> Config {
        Config::only(EngineKind::Icarus, Mode::Outputs)
    }

    fn start_up(&mut self) -> Result<f64, MeasureError> {
        self.engine.prepare(&self.bench.design.outputs)?;
        Ok(self.engine.build_seconds())
    }

    fn run(&mut self, spans: usize) -> Result<Timed, MeasureError> {
        let (design, config) = (&self.bench.design, self.config());
        let source = self.workload.spans(spans);
        let stimulus = Stimulus::whole(&source, design);
        let sink = batch_sink(config.mode, design, &design.outputs, &self.scratch.file());
        let sink =
            sink.map_err(|reason| MeasureError::Waveform { config: config.describe(), reason })?;
        timed(config, design, &mut self.engine, &stimulus, &design.outputs, sink)
    }
}

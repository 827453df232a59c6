//! Engines that run in this process.
use std::io;
use std::path::Path;
use std::time::Instant;

use specula_datapath::Design;
use specula_datapath::design::{NodeId, ScopeId};
use specula_sim::fast::Settings;
use specula_sim::{Engine, Fast, Flow, RustHdl, SimError, Stimulus};

use super::batch_sink::batch_sink;
use super::clocked::timed;
use super::runner::{Runner, Timed};
use super::scratch::Scratch;
use super::workload::Workload;
use super::{Config, MeasureError, Mode};
use specula_testbench::Bench;

/// The engine.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    /// The columnar engine.
    Fast(Settings),
    /// rust-hdl's simulator.
    RustHdl,
}

impl Kind {
    fn engine(self, design: &Design) -> Result<Box<dyn Engine + '_>, SimError> {
        Ok(match self {
            Kind::Fast(settings) => Box::new(Fast::with_settings(design, settings)),
            Kind::RustHdl => Box::new(RustHdl::new(design)?),
        })
    }

    /// Number of spans after which an engine that has just been made has delivered its first
    /// values.
    fn first_spans(self, workload: &Workload) -> usize {
        match self {
            // It is given a whole frame, as in a normal run, and stopped after the first batch.
            Kind::Fast(_) => workload.frame(),
            Kind::RustHdl => 1,
        }
    }
}

/// An engine in this process.
pub(crate) struct InProcess<'a> {
    pub bench: &'a Bench<'a>,
    pub workload: &'a Workload,
    pub scratch: &'a Scratch,
    pub config: Config,
    pub kind: Kind,
}

impl InProcess<'_> {
    fn watched(&self, design: &Design) -> Vec<NodeId> {
        if self.config.mode == Mode::Outputs { design.outputs.clone() } else { design.variables() }
    }

    fn failed(&self) -> impl FnOnce(io::Error) -> MeasureError + use<> {
        let config = self.config.describe();
        move |reason| MeasureError::Waveform { config, reason }
    }

    fn run_into(&self, spans: usize, file: &Path) -> Result<Timed, MeasureError> {
        let design = &self.bench.design;
        let source = self.workload.spans(spans);
        let stimulus = Stimulus::whole(&source, design);
        let watched = self.watched(design);
        let sink = batch_sink(self.config.mode, design, &watched, file).map_err(self.failed())?;
        timed(self.config, design, self.kind.engine(design)?.as_mut(), &stimulus, &watched, sink)
    }
}

impl Runner for InProcess<'_> {
    fn config(&self) -> Config {
        self.config
    }

    fn start_up(&mut self) -> Result<f64, MeasureError> {
        let source = self.workload.spans(self.kind.first_spans(self.workload));
        let name = &self.bench.design.scope(ScopeId::TOP).instance;
        let begin = Instant::now();
        let design = specula_hdl::elaborate(self.bench.spec, name)?;
        let stimulus = Stimulus::whole(&source, &design);
        self.kind.engine(&design)?.run(&stimulus, &self.watched(&design), &mut |_| Flow::Stop)?;
        Ok(begin.elapsed().as_secs_f64())
    }

    fn run(&mut self, spans: usize) -> Result<Timed, MeasureError> {
        let file = self.scratch.file();
        let result = self.run_into(spans, &file);
        self.scratch.clear();
        result
    }
}

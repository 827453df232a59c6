//! The runners of a measurement.
use std::rc::Rc;
use std::thread;

use specula_sim::fast::{InstructionSet, Settings};
use specula_sim::{Icarus, Keeping, SimError, Stimulus, TimedVerilator, Verilator};

use super::external::{Interpreted, Verilated};
use super::in_process::{InProcess, Kind};
use super::progress::Step;
use super::runner::Runner;
use super::scratch::Scratch;
use super::workload::Workload;
use super::{Config, MeasureError, Mode, Skipped};
use specula_testbench::{Bench, EngineKind};

/// Number of threads of the rows that use several.
const THREADS: usize = 2;

/// The runners, and the engines that cannot run on this machine.
pub(crate) struct Roster<'a> {
    bench: &'a Bench<'a>,
    workload: &'a Workload,
    scratch: &'a Scratch,
    pub runners: Vec<Box<dyn Runner + 'a>>,
    pub skipped: Vec<Skipped>,
}

impl<'a> Roster<'a> {
    /// All simulators installed on this machine, ready to run.
    ///
    /// # Errors
    /// [`MeasureError`] if a tool that is present fails.
    pub fn gather(
        bench: &'a Bench<'a>,
        workload: &'a Workload,
        scratch: &'a Scratch,
        progress: &mut dyn FnMut(&Step),
    ) -> Result<Roster<'a>, MeasureError> {
        let mut roster = Roster { bench, workload, scratch, runners: vec![], skipped: vec![] };
        roster.add_fast();
        roster.add_rust_hdl();
        roster.add_verilator(progress)?;
        roster.add_icarus()?;
        Ok(roster)
    }

    fn add_fast(&mut self) {
        let best = InstructionSet::best();
        for mode in Mode::ALL {
            self.add_in_process(Config::fast(mode, best, 1), fast(best, 1));
        }
        for mode in [Mode::Outputs, Mode::EverySignal] {
            if best != InstructionSet::BASELINE {
                self.add_in_process(
                    Config::fast(mode, InstructionSet::BASELINE, 1),
                    fast(InstructionSet::BASELINE, 1),
                );
            }
            if thread::available_parallelism().is_ok_and(|cores| cores.get() >= THREADS) {
                self.add_in_process(Config::fast(mode, best, THREADS), fast(best, THREADS));
            }
        }
    }

    fn add_rust_hdl(&mut self) {
        for mode in [Mode::Outputs, Mode::EverySignal] {
            self.add_in_process(Config::only(EngineKind::RustHdl, mode), Kind::RustHdl);
        }
    }

    fn add_in_process(&mut self, config: Config, kind: Kind) {
        let &mut Roster { bench, workload, scratch, .. } = self;
        self.runners.push(Box::new(InProcess { bench, workload, scratch, config, kind }));
    }

    fn add_verilator(&mut self, progress: &mut dyn FnMut(&Step)) -> Result<(), MeasureError> {
        if let Err(absent) = Verilator::present() {
            self.skip(EngineKind::Verilator, None, reason(absent)?);
            return Ok(());
        }
        let programs: [(Keeping, &[Mode]); 4] = [
            (Keeping::Outputs, &[Mode::Outputs]),
            (Keeping::EverySignal, &[Mode::EverySignal]),
            (Keeping::Vcd, &[Mode::Vcd, Mode::VcdNull]),
            (Keeping::Fst, &[Mode::Fst]),
        ];
        let source = self.workload.spans(self.workload.frame());
        let frame = Stimulus::whole(&source, &self.bench.design);
        for (keeping, modes) in programs {
            progress(&Step::Building { engine: EngineKind::Verilator, mode: modes[0] });
            match TimedVerilator::build(&self.bench.design, &frame, keeping) {
                Ok(program) => self.add_verilated(&Rc::new(program), modes),
                // FST needs the headers of zlib, which a system with Verilator need not have.
                Err(SimError::ToolFailed { output, .. }) if keeping == Keeping::Fst => {
                    self.skip(EngineKind::Verilator, Some(Mode::Fst), without_fst(&output));
                }
                Err(error) => return Err(error.into()),
            }
        }
        Ok(())
    }

    fn add_verilated(&mut self, program: &Rc<TimedVerilator>, modes: &[Mode]) {
        for &mode in modes {
            self.runners.push(Box::new(Verilated {
                program: Rc::clone(program),
                scratch: self.scratch,
                mode,
            }));
        }
    }

    fn add_icarus(&mut self) -> Result<(), MeasureError> {
        let &mut Roster { bench, workload, scratch, .. } = self;
        match Icarus::new(&bench.design) {
            Ok(engine) => {
                self.runners.push(Box::new(Interpreted { bench, workload, engine, scratch }))
            }
            Err(absent) => self.skip(EngineKind::Icarus, None, reason(absent)?),
        }
        Ok(())
    }

    fn skip(&mut self, engine: EngineKind, mode: Option<Mode>, reason: String) {
        self.skipped.push(Skipped { engine, mode, reason });
    }
}

fn fast(instruction_set: InstructionSet, threads: usize) -> Kind {
    Kind::Fast(Settings { instruction_set, threads, ..Settings::default() })
}

/// Why a tool is absent, and how to install it; any other error is returned.
fn reason(error: SimError) -> Result<String, MeasureError> {
    match error {
        SimError::ToolAbsent { tool, install, .. } => {
            Ok(format!("{tool} is not installed: {install}"))
        }
        other => Err(other.into()),
    }
}

/// Why a program with FST was not built, according to the compiler's output.
fn without_fst(output: &str) -> String {
    let said =
        output.lines().find(|line| line.contains("error")).unwrap_or("no reason is given").trim();
    format!(
        "Verilator cannot build a program that writes FST ({said}): install zlib's headers, as with `apt install zlib1g-dev`"
    )
}

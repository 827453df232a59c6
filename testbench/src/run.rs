//! The whole path from a frame to compared pixels.
use std::ops::Range;
use std::sync::{Arc, OnceLock};
use std::time::Instant;

use specula_datapath::Design;
use specula_datapath::design::{self, NodeId};
use specula_scene::Frame;
use specula_sim::fast::Settings;
use specula_sim::{
    Batch, Effort, Engine, Fast, FirstPixels, Flow, Icarus, RustHdl, SpanSource, Stimulus,
    Verilator,
};
use specula_spec::CoreSpec;

use crate::checker::{self, Facts, Violation};
use crate::directions::{self, WrongDirection};
use crate::monitor::Monitor;
use crate::scoreboard::{self, Comparison, WorstQuantisation};
use crate::spans::{FrameSpans, KeptSpans};
use crate::steady::{MovedInput, moved_input};
use crate::trace::{self, Choice};
use crate::{BenchError, Image};

/// The engines there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EngineKind {
    /// The columnar engine.
    Fast,
    /// rust-hdl's simulator.
    RustHdl,
    /// Verilator on the emitted Verilog.
    Verilator,
    /// Icarus Verilog on the emitted Verilog.
    Icarus,
}

impl EngineKind {
    /// Every engine.
    pub const ALL: [EngineKind; 4] =
        [EngineKind::Fast, EngineKind::RustHdl, EngineKind::Verilator, EngineKind::Icarus];

    /// The name that the command line uses.
    pub const fn name(self) -> &'static str {
        match self {
            EngineKind::Fast => "fast",
            EngineKind::RustHdl => "rust-hdl",
            EngineKind::Verilator => "verilator",
            EngineKind::Icarus => "icarus",
        }
    }

    /// The name of the program that it is, as tables of measurements have it: Icarus's compiler is
    /// called otherwise than its engine.
    pub const fn program(self) -> &'static str {
        match self {
            EngineKind::Icarus => "iverilog",
            other => other.name(),
        }
    }

    fn engine<'a>(self, design: &'a Design) -> Result<Box<dyn Engine + 'a>, BenchError> {
        match self {
            EngineKind::Fast => {
                let threads = std::thread::available_parallelism().map_or(1, usize::from);
                Ok(Box::new(Fast::with_settings(
                    design,
                    Settings { threads, ..Settings::default() },
                )))
            }
            EngineKind::RustHdl => Ok(Box::new(RustHdl::new(design)?)),
            EngineKind::Verilator => Ok(Box::new(Verilator::new(design, Effort::FastBuild)?)),
            EngineKind::Icarus => Ok(Box::new(Icarus::new(design)?)),
        }
    }
}

/// Told how far a run is: clocks done, and clocks in all.
pub type Progress<'a> = &'a mut dyn FnMut(u64, u64);

/// A core, elaborated, and the frame it is to shade.
pub struct Bench<'a> {
    /// The frame.
    pub frame: &'a Frame,
    /// The core's spec.
    pub spec: &'a CoreSpec,
    /// The core.
    pub design: Design,
    spans: FrameSpans<'a>,
    first_pixels: FirstPixels,
    /// The spans as they are set up for the first run; later runs and traces need them again.
    kept: OnceLock<KeptSpans>,
    entry: Entry,
}

/// When time slots of pixels go in.
enum Entry {
    /// One in each clock.
    Consecutive,
    /// With random bubbles between them.
    Bubbles {
        /// Their seed.
        seed: u64,
    },
    /// In these clocks.
    At(Arc<[u64]>),
}

/// What came of a run.
pub struct Outcome {
    /// Pixels shaded.
    pub pixels: u64,
    /// Clocks from the first pixel's entry to the last one's exit, both counted.
    pub cycles: u64,
    /// Red, green and blue of each pixel, in the order in which they left the core.
    pub codes: Vec<[u8; 3]>,
    /// The simulated picture.
    pub simulated: Image,
    /// How it compares.
    pub comparison: Comparison,
    /// Clocks in which a pixel left though none was due, or was due and did not leave.
    pub wrong_clocks: Vec<u64>,
    /// For each stated fact of the design the smallest and the largest raw value that its signal
    /// had wherever a pixel was.
    pub facts_seen: Vec<Option<design::Range>>,
    /// The first fact that did not hold.
    pub violation: Option<Violation>,
    /// The first input that holds for a frame and did not stand still.
    pub moved_input: Option<MovedInput>,
    /// The first component of a direction that is not the model's.
    pub wrong_direction: Option<WrongDirection>,
    /// What the quantisation error is proven to stay within, in LSBs.
    pub bound_lsb: f64,
    /// Clock in which the worst pixel left the core.
    pub worst_cycle: Option<u64>,
    /// Seconds that the simulation took.
    pub simulation_seconds: f64,
}

impl Outcome {
    /// Whether every pixel agrees, with what leaves beside it, each in its clock, every stated fact held, every input stood still
    /// for as long as it has to, and no quantisation error is above its bound.
    ///
    /// Core and bit-true model are given the same packets, so they agree whatever those hold; the
    /// method in f64 is given none. That a core stays within its bound says that the set-up is
    /// right, and that the bound is.
    pub fn agrees(&self) -> bool {
        let as_the_model = self.comparison.mismatches == 0
            && self.wrong_clocks.is_empty()
            && self.violation.is_none()
            && self.moved_input.is_none()
            && self.wrong_direction.is_none();
        as_the_model && self.beyond_bound().is_none()
    }

    /// The largest quantisation error, if it is above its bound.
    pub fn beyond_bound(&self) -> Option<&WorstQuantisation> {
        self.comparison.worst_quantisation.as_ref().filter(|worst| worst.error_lsb > self.bound_lsb)
    }
}

impl<'a> Bench<'a> {
    /// Elaborates the core of `spec` under the module name `name`.
    ///
    /// # Errors
    /// [`BenchError::TooWide`] if the spec's formats are too fine.
    pub fn new(frame: &'a Frame, spec: &'a CoreSpec, name: &str) -> Result<Bench<'a>, BenchError> {
        Ok(Bench::of_design(frame, spec, specula_hdl::elaborate(spec, name)?))
    }

    /// The bench of a core that has been elaborated from `spec`.
    pub fn of_design(frame: &'a Frame, spec: &'a CoreSpec, design: Design) -> Bench<'a> {
        let spans = FrameSpans::new(frame, spec);
        let (first_pixels, entry) = (FirstPixels::of(&spans), Entry::Consecutive);
        Bench { frame, spec, design, spans, first_pixels, kept: OnceLock::new(), entry }
    }

    /// The same bench with random bubbles of 0 to 4 clocks before each time slot of a pixel. The same
    /// seed gives the same bubbles.
    pub fn with_bubbles(self, seed: u64) -> Bench<'a> {
        Bench { entry: Entry::Bubbles { seed }, ..self }
    }

    /// The same bench with the packets of the frame's spans as a host has sent them, and with their
    /// time slots in these clocks, one behind the other.
    pub fn entering_at(self, packets: &dyn SpanSource, clocks: Vec<u64>) -> Bench<'a> {
        let kept = OnceLock::from(KeptSpans::of(packets));
        Bench { kept, entry: Entry::At(clocks.into()), ..self }
    }

    /// Clocks from the first pixel's entry to the last one's exit, both counted.
    pub fn clocks(&self) -> u64 {
        clocks_of(&self.stimulus(&self.spans, &self.first_pixels), &self.design)
    }

    /// Simulates every clock of the frame and compares every pixel.
    ///
    /// # Errors
    /// [`BenchError`] if the engine fails.
    pub fn run(&self, engine: EngineKind, progress: Progress) -> Result<Outcome, BenchError> {
        let mut engine = engine.engine(&self.design)?;
        let given = (self.kept(), &self.first_pixels);
        self.run_kept(given, engine.as_mut(), &self.watched(), progress)
    }

    /// As [`Bench::run`], in an engine that can watch the core's ports alone, such as that of a
    /// netlist. Nothing is seen of facts about signals inside.
    ///
    /// # Errors
    /// [`BenchError`] if the engine fails.
    pub fn run_ports(
        &self,
        engine: &mut dyn Engine,
        progress: Progress,
    ) -> Result<Outcome, BenchError> {
        self.run_kept((self.kept(), &self.first_pixels), engine, &self.outputs(), progress)
    }

    /// As [`Bench::run`], with packets of the frame's spans that another host has set up.
    ///
    /// # Errors
    /// [`BenchError`] if the engine fails, or if a packet is none that the core takes.
    pub fn run_given(
        &self,
        spans: &dyn SpanSource,
        engine: EngineKind,
        progress: Progress,
    ) -> Result<Outcome, BenchError> {
        let kept = KeptSpans::of(spans);
        let mut engine = engine.engine(&self.design)?;
        let given = (&kept, &FirstPixels::of(&kept));
        self.run_kept(given, engine.as_mut(), &self.watched(), progress)
    }

    fn run_kept(
        &self,
        (spans, first_pixels): (&KeptSpans, &FirstPixels),
        engine: &mut dyn Engine,
        watched: &[NodeId],
        progress: Progress,
    ) -> Result<Outcome, BenchError> {
        let stimulus = self.stimulus(spans, first_pixels);
        let mut monitor = Monitor::new(&self.design, &stimulus);
        let mut facts = Facts::of(&self.design);
        let begin = Instant::now();
        engine.run(&stimulus, watched, &mut |columns| {
            monitor.take(columns);
            facts.take(&stimulus, columns);
            progress(columns.span().end, stimulus.clocks().end);
            Flow::Continue
        })?;
        let simulation_seconds = begin.elapsed().as_secs_f64();
        let Monitor { codes, directions, wrong_clocks, .. } = monitor;
        let bound_lsb = self.design.error_bound();
        let given = scoreboard::Given { spans, first_pixels, codes: &codes };
        let comparison = scoreboard::compare((self.spec, self.frame), &given, bound_lsb)?;
        let worst_cycle = comparison
            .worst_pixel
            .as_ref()
            .map(|worst| trace::leaving_clock(&stimulus, &self.design, worst.span, worst.pixel));
        Ok(Outcome {
            pixels: stimulus.pixels(),
            cycles: clocks_of(&stimulus, &self.design),
            simulated: self.picture(&codes),
            codes,
            comparison,
            wrong_clocks,
            facts_seen: facts.seen,
            violation: facts.violation,
            wrong_direction: directions::first_wrong(self.spec, spans, &directions)?,
            moved_input: moved_input(&self.design, &stimulus),
            bound_lsb,
            worst_cycle,
            simulation_seconds,
        })
    }

    /// Every signal over the clocks of `choice`, handed over a batch of clocks at a time. Says
    /// which clocks those are.
    ///
    /// # Errors
    /// [`BenchError`] if the engine fails.
    pub fn trace(
        &self,
        engine: EngineKind,
        choice: &Choice,
        outcome: &Outcome,
        sink: &mut dyn FnMut(&Batch) -> Flow,
    ) -> Result<Option<Range<u64>>, BenchError> {
        let Some(window) = self.window(choice, outcome) else { return Ok(None) };
        let whole = self.stimulus(self.kept(), &self.first_pixels);
        let lead = whole.leading_to(&window, &self.design);
        let nodes: Vec<NodeId> = self.design.variables();
        engine
            .engine(&self.design)?
            .run(&lead, &nodes, &mut |columns| sink(&columns.within(&window)))?;
        Ok(Some(window))
    }

    /// The clocks that [`Bench::trace`] gives for `choice`; none if it asks for none.
    pub fn window(&self, choice: &Choice, outcome: &Outcome) -> Option<Range<u64>> {
        let worst = outcome.comparison.worst_pixel.as_ref();
        choice.window(&self.stimulus(&self.spans, &self.first_pixels), &self.design, worst)
    }

    /// The clock in which pixel number `pixel` of span number `span` leaves the core.
    pub fn leaving_clock(&self, span: usize, pixel: u32) -> u64 {
        let stimulus = self.stimulus(&self.spans, &self.first_pixels);
        trace::leaving_clock(&stimulus, &self.design, span, pixel)
    }

    /// The whole run of a source's spans.
    fn stimulus<'s>(&self, spans: &'s dyn SpanSource, first_pixels: &FirstPixels) -> Stimulus<'s> {
        let stimulus = Stimulus::in_order(spans, first_pixels, &self.design);
        match &self.entry {
            Entry::Consecutive => stimulus,
            Entry::Bubbles { seed } => stimulus.with_bubbles(*seed),
            Entry::At(clocks) => stimulus.entering_at(clocks),
        }
    }

    fn kept(&self) -> &KeptSpans {
        self.kept.get_or_init(|| KeptSpans::of(&self.spans))
    }

    /// The core's outputs.
    fn outputs(&self) -> Vec<NodeId> {
        self.design.outputs.iter().copied().chain([self.design.valid_out]).collect()
    }

    /// Outputs and signals with stated facts.
    fn watched(&self) -> Vec<NodeId> {
        let mut watched = self.outputs();
        watched.extend(checker::watched(&self.design));
        watched.sort_unstable();
        watched.dedup();
        watched
    }

    fn picture(&self, codes: &[[u8; 3]]) -> Image {
        let mut image = Image::filled(self.frame.width, self.frame.height, self.frame.background);
        let mut rest = codes;
        for span in &self.frame.spans {
            let (run, later) = rest.split_at((span.length as usize).min(rest.len()));
            image.run_mut(span)[..run.len()].copy_from_slice(run);
            rest = later;
        }
        image
    }
}

/// Clocks from the first pixel's entry to the last one's exit, both counted.
fn clocks_of(stimulus: &Stimulus, design: &Design) -> u64 {
    stimulus.begin_of(usize::MAX) - stimulus.begin_of(0) + u64::from(design.depth())
}

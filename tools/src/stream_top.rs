//! `--top axis`: a frame's packets through the core's stream top, with pauses on both sides.
use clap::ValueEnum;
use serde::Serialize;
use specula_datapath::Design;
use specula_flow::stream::{
    self, BlockSimulator, File, FrameVectors, SentPixel, StreamCore, StreamRecord, StreamRun,
    StreamShape, Vectors,
};
use specula_spec::{Positions, WordWidth};
use specula_testbench::{Bench, BenchError, EngineKind, Outcome};

use crate::error::ToolError;
use crate::frame_vectors::frame_vectors;
use crate::job::Job;
use crate::verilog;

/// What of a block is simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Top {
    /// The core alone
    Core,
    /// The core in its stream top: packets of 32-bit words in, pixels with positions out
    Axis,
}

/// A frame that has gone through the model of the stream top.
pub struct StreamedFrame {
    /// The seed of pauses, 0 for none.
    seed: u32,
    frame: [FrameVectors; 1],
    run: StreamRun,
}

/// What came of a stream top.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StreamOutcome {
    /// Pixels that were taken at `m_axis`.
    pub pixels: usize,
    /// Clocks from the one in which the first word was taken to that of the last pixel.
    pub clocks: u64,
    /// The first thing that is wrong.
    pub fault: Option<StreamFault>,
}

/// Something wrong in a stream.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StreamFault {
    /// What it is.
    pub in_words: String,
    /// The clock in which it is seen, if that is known.
    pub cycle: Option<u64>,
}

/// Packets and pixels of the block that is simulated.
const SHAPE: StreamShape = StreamShape { word: WordWidth::Bits32, positions: Positions::Sent };

impl StreamedFrame {
    /// Sends the frame of a job through the stream top of its core.
    ///
    /// # Errors
    /// [`ToolError::NoVectors`] if the frame has no spans, [`ToolError::Stuck`] if the stream stands
    /// still; those of [`stream_core`].
    pub fn new(job: &Job, design: &Design, seed: u32) -> Result<StreamedFrame, ToolError> {
        let frame = [frame_vectors(job, usize::MAX)?];
        let run = StreamRun::new(&stream_core(job, design, SHAPE)?, &frame, seed)?;
        Ok(StreamedFrame { seed, frame, run })
    }

    /// The bench of the core with the packets that the stream top gives it, and when it does.
    pub fn bench<'a>(&self, bench: Bench<'a>) -> Bench<'a> {
        bench.entering_at(&self.run.packets, self.run.entries.clone())
    }

    /// Compares what comes out of the stream top where the core behind it gives the pixels of
    /// `outcome`. Simulators of Verilog run the whole block besides, and have to show the same pixel
    /// in each clock.
    ///
    /// # Errors
    /// [`ToolError::Bench`] if a simulator cannot run the block.
    pub fn outcome(
        &self,
        job: &Job,
        bench: &Bench,
        outcome: &Outcome,
        engine: EngineKind,
    ) -> Result<StreamOutcome, ToolError> {
        let core = stream_core(job, &bench.design, SHAPE)?;
        let expected = Vectors::new(&core, &self.frame).marked_pixels();
        let modelled = self.run.record(&core, &outcome.codes);
        let simulator = match engine {
            EngineKind::Fast | EngineKind::RustHdl => None,
            EngineKind::Icarus => Some(BlockSimulator::Icarus),
            EngineKind::Verilator => Some(BlockSimulator::Verilator),
        };
        let of_block = simulator.map(|simulator| self.simulated(&core, job, bench, simulator));
        let of_block = of_block.transpose()?.and_then(|(record, failure)| {
            wrong_pixel(&record, &expected)
                .or_else(|| other_clock(&record, &modelled))
                .or(failure.map(|in_words| StreamFault { in_words, cycle: None }))
        });
        let last = modelled.pixels.last().map_or(0, |pixel| pixel.clock);
        Ok(StreamOutcome {
            pixels: modelled.pixels.len(),
            clocks: last + 1 - self.run.first_word,
            fault: wrong_pixel(&modelled, &expected).or(of_block),
        })
    }

    /// What comes out of the block's Verilog, and what its bench complains of.
    fn simulated(
        &self,
        core: &StreamCore,
        job: &Job,
        bench: &Bench,
        simulator: BlockSimulator,
    ) -> Result<(StreamRecord, Option<String>), ToolError> {
        let text = verilog::text(&job.origin, bench.spec, &bench.design);
        let own = File { name: verilog::file_name(core.name()), text };
        let mut files = stream::bench_files(core, &self.frame);
        files.push(own);
        let run = simulator.run(core.name(), &files, self.seed);
        let run = run.map_err(BenchError::from)?;
        Ok((run.record, run.failure))
    }
}

impl StreamOutcome {
    /// The outcome as text.
    pub fn in_words(&self) -> String {
        let StreamOutcome { pixels, clocks, fault } = self;
        let verdict = match fault {
            None => "none lost, doubled or wrong, nor its marks or its position",
            Some(_) => "not as they have to be",
        };
        format!(
            "packets of 32-bit words in, {pixels} pixels out in {clocks} clocks from the first word \
             on: {verdict}"
        )
    }
}

/// The core of a job with its streams.
///
/// # Errors
/// [`ToolError::DirectionsInStream`] if directions leave the core, for which pixels in a stream have
/// no place.
pub fn stream_core<'a>(
    job: &'a Job,
    design: &'a Design,
    shape: StreamShape,
) -> Result<StreamCore<'a>, ToolError> {
    match job.spec().direction_outputs() {
        [] => Ok(StreamCore::new(job.spec(), design, shape, &job.file.text())),
        _ => Err(ToolError::DirectionsInStream),
    }
}

/// The first pixel that is not as it has to be.
fn wrong_pixel(record: &StreamRecord, expected: &[u64]) -> Option<StreamFault> {
    let difference = record.difference(expected)?;
    let cycle = difference.found.map(|pixel| pixel.clock);
    Some(StreamFault { in_words: difference.in_words(), cycle })
}

/// The first pixel that is taken in another clock than in the model of the stream top.
fn other_clock(record: &StreamRecord, modelled: &StreamRecord) -> Option<StreamFault> {
    let mut both = record.pixels.iter().zip(&modelled.pixels).enumerate();
    let (number, (found, model)) = both.find(|(_, (found, model))| found.clock != model.clock)?;
    let SentPixel { clock, .. } = found;
    let in_words = format!(
        "pixel {number} of the stream is taken in cycle {clock}, and in {} by the model of the \
         stream top",
        model.clock
    );
    Some(StreamFault { in_words, cycle: Some(*clock) })
}

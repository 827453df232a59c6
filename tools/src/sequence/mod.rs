//! Sequences: every frame of a scene that moves, shaded by one core.
mod animation;
mod files;
mod partial;
mod plot;

use std::io::{self, Write};

use serde::{Deserialize, Serialize};
use specula_datapath::Design;
use specula_scene::{Frame, Sequence};
use specula_testbench::{Bench, EngineKind, Errors, Image, Outcome};

use crate::error::ToolError;
use crate::job::Job;
use crate::output::{Destination, Staging};
use crate::progress;

pub use animation::{ANIMATION, write_animation};
pub use files::{TABLE, table};
pub use partial::{Known, Partial};
pub use plot::{PLOT, plot};

/// How a sequence's frames are simulated.
#[derive(Clone, Copy, Debug)]
pub struct Simulation {
    /// The engine.
    pub engine: EngineKind,
    /// Random bubbles between pixels by this seed, if there are any.
    pub bubbles: Option<u32>,
}

/// What came of all frames.
#[derive(Clone, Debug, Serialize)]
pub struct ShadedSequence {
    /// Number of frames.
    pub frames: u32,
    /// Pixels of all frames.
    pub pixels: u64,
    /// Pixels that are not the model's.
    pub mismatches: u64,
    /// Frames in which everything agrees.
    pub agreeing: usize,
    /// Clocks of all frames, each from its first pixel's entry to its last one's exit.
    pub cycles: u64,
    /// The frame that the rest of a report is about: the first that disagrees, or else the one with
    /// the largest total error.
    pub shown: u32,
    /// Every frame, in the order of time.
    pub by_frame: Vec<ShadedFrame>,
}

/// What came of a frame.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ShadedFrame {
    /// Its number, counted from 0.
    pub frame: u32,
    /// Spans that were shaded.
    pub spans: usize,
    /// Pixels that were shaded.
    pub pixels: u64,
    /// Clocks from the first pixel's entry to the last one's exit.
    pub cycles: u64,
    /// Whether everything agrees, and no error is above its bound.
    pub agrees: bool,
    /// Pixels that are not the model's.
    pub mismatches: u64,
    /// Column and row of the pixel with the largest total error; `None` without errors.
    pub worst_pixel: Option<[u32; 2]>,
    /// Its errors.
    pub error: Errors,
}

/// The name of a frame's picture.
pub fn picture_name(frame: u32) -> String {
    format!("frame_{frame:04}.png")
}

/// Shades every frame with one core, frames side by side, and writes the picture of each as soon as
/// it is there, so that memory does not grow with their number. Frames that an interrupted run has
/// done are not shaded again.
///
/// # Errors
/// [`ToolError`] if a frame cannot be drawn or simulated, or its picture cannot be written.
pub fn shade(
    (job, sequence): (&Job, &Sequence),
    design: &Design,
    simulation: Simulation,
    (destination, staging): (&Destination, &Staging),
) -> Result<(ShadedSequence, Partial), ToolError> {
    let fingerprint = fingerprint(job, sequence, simulation)?;
    let (partial, known) = Partial::open(destination, staging, &fingerprint)?;
    known.tell(sequence.frames());
    let bar = progress::frames(sequence.frames());
    bar.inc(known.frames.len() as u64);
    let missing: Vec<u32> =
        (0..sequence.frames()).filter(|number| !known.frames.contains_key(number)).collect();
    let shaded = sequence.map_some(&missing, |number, frame| {
        let (shaded, image) = shade_frame(job, design, simulation, number, &frame)?;
        partial.add(&shaded, &image).map_err(staging.failed(&picture_name(number)))?;
        bar.inc(1);
        Ok::<_, ToolError>(shaded)
    })?;
    bar.finish_and_clear();
    let mut by_frame = known.frames;
    by_frame.extend(shaded.into_iter().map(|shaded| (shaded.frame, shaded)));
    for &number in by_frame.keys() {
        partial.put(number, staging).map_err(staging.failed(&picture_name(number)))?;
    }
    Ok((ShadedSequence::of(by_frame.into_values().collect()), partial))
}

/// A hash of everything that decides what frames become.
fn fingerprint(
    job: &Job,
    sequence: &Sequence,
    simulation: Simulation,
) -> Result<String, ToolError> {
    let (version, frames) = (env!("CARGO_PKG_VERSION"), sequence.fingerprint()?);
    let all = format!("{version}\n{frames}\n{}\n{simulation:?}", job.file.text());
    Ok(partial::hash(all.as_bytes()))
}

impl Known {
    /// Says on standard error what was found.
    fn tell(&self, frames: u32) {
        let mut stderr = io::stderr().lock();
        // A closed standard error is no reason to stop.
        let _ = match (&self.replaced, self.frames.len()) {
            (Some(folder), _) => writeln!(
                stderr,
                "frames: all are shaded; `{}` was of another scene, core, engine or version, and is replaced",
                folder.display()
            ),
            (None, 0) => Ok(()),
            (None, known) => writeln!(
                stderr,
                "frames: {known} of {frames} are there from a run that was interrupted"
            ),
        };
    }
}

fn shade_frame(
    job: &Job,
    design: &Design,
    simulation: Simulation,
    number: u32,
    frame: &Frame,
) -> Result<(ShadedFrame, Image), ToolError> {
    let bench = Bench::of_design(frame, job.spec(), design.clone());
    let bench = match simulation.bubbles {
        None => bench,
        Some(seed) => bench.with_bubbles(seed.into()),
    };
    let outcome = bench.run(simulation.engine, &mut |_, _| ())?;
    Ok((ShadedFrame::of(number, frame.spans.len(), &outcome), outcome.simulated))
}

impl ShadedFrame {
    fn of(frame: u32, spans: usize, outcome: &Outcome) -> ShadedFrame {
        ShadedFrame {
            frame,
            spans,
            pixels: outcome.pixels,
            cycles: outcome.cycles,
            agrees: outcome.agrees(),
            mismatches: outcome.comparison.mismatches,
            worst_pixel: outcome.comparison.worst_pixel.map(|worst| [worst.x, worst.y]),
            error: outcome.comparison.errors.clone(),
        }
    }
}

impl ShadedSequence {
    fn of(by_frame: Vec<ShadedFrame>) -> ShadedSequence {
        let error = |frame: &&ShadedFrame| frame.error.total.max_lsb;
        let disagrees = by_frame.iter().find(|frame| !frame.agrees);
        // Of equally large errors the first one counts.
        let worst = by_frame.iter().rev().max_by(|a, b| error(a).total_cmp(&error(b)));
        ShadedSequence {
            frames: by_frame.len() as u32,
            pixels: by_frame.iter().map(|frame| frame.pixels).sum(),
            mismatches: by_frame.iter().map(|frame| frame.mismatches).sum(),
            agreeing: by_frame.iter().filter(|frame| frame.agrees).count(),
            cycles: by_frame.iter().map(|frame| frame.cycles).sum(),
            shown: disagrees.or(worst).map_or(0, |frame| frame.frame),
            by_frame,
        }
    }

    /// What came of it, as text.
    pub fn in_words(&self) -> String {
        let last = self.frames.saturating_sub(1);
        let agreeing = match self.frames as usize - self.agreeing {
            0 => "all agree".to_owned(),
            wrong => format!("{wrong} do not agree"),
        };
        format!("{} frames, 0 to {last}: {agreeing}", self.frames)
    }

    /// The frame that a report is about, as text.
    pub fn shown_in_words(&self) -> String {
        let why = if self.agreeing == self.frames as usize {
            "the one with the largest error"
        } else {
            "the first that does not agree"
        };
        format!("{}, {why}; what follows is about it", self.shown)
    }
}

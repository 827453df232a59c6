//! The netlist, simulated on some spans of a scene.
use serde::Serialize;
use specula_flow::synth::Netlist;
use specula_scene::Frame;
use specula_sim::Icarus;
use specula_testbench::{Bench, BenchError, Mismatch, Outcome};

use crate::error::ToolError;
use crate::job::Job;
use crate::progress;

/// How many pixels are simulated, about: those of a picture of 24 by 16.
const PIXELS: u64 = 384;

/// The seed of the clocks between pixels.
const PAUSES: u64 = 14;

/// What came of simulating a netlist.
#[derive(Serialize)]
pub struct NetlistRun {
    /// Name of the scene.
    scene: String,
    spans: usize,
    pixels: u64,
    /// Pixels whose code is not the bit-true model's.
    differing_pixels: u64,
    first_difference: Option<Difference>,
    /// Clocks in which a pixel left that was not due, or was due and did not leave.
    wrong_clocks: usize,
    first_wrong_clock: Option<u64>,
}

/// A pixel that is not as it must be.
#[derive(Serialize)]
struct Difference {
    x: u32,
    y: u32,
    expected: [u8; 3],
    found: [u8; 3],
}

impl NetlistRun {
    /// Simulates a netlist of the job's core in Icarus, on spans from all over the scene's frame,
    /// with random pauses between pixels, and compares every pixel with the bit-true model.
    ///
    /// # Errors
    /// [`ToolError::Synth`] if there are no models of the netlist's cells, [`ToolError::Bench`] if
    /// Icarus fails.
    pub fn of(netlist: &Netlist, job: &Job) -> Result<NetlistRun, ToolError> {
        let source = netlist.with_models()?;
        let frame = some_spans(&job.scene.frame);
        let bench = Bench::new(&frame, job.spec(), &job.module())?.with_bubbles(PAUSES);
        let mut engine = Icarus::of_netlist(&bench.design, &source).map_err(BenchError::from)?;
        let bar = progress::bar("simulating the netlist", bench.clocks() + 1);
        let outcome = bench.run_ports(&mut engine, &mut |done, _| bar.set_position(done));
        bar.finish_and_clear();
        Ok(NetlistRun::found(&job.scene.name, &frame, &outcome?))
    }

    fn found(scene: &str, frame: &Frame, outcome: &Outcome) -> NetlistRun {
        let difference = |first: &Mismatch| {
            let &Mismatch { x, y, expected, simulated: found, .. } = first;
            Difference { x, y, expected, found }
        };
        NetlistRun {
            scene: scene.to_owned(),
            spans: frame.spans.len(),
            pixels: outcome.pixels,
            differing_pixels: outcome.comparison.mismatches,
            first_difference: outcome.comparison.first_mismatch.as_ref().map(difference),
            wrong_clocks: outcome.wrong_clocks.len(),
            first_wrong_clock: outcome.wrong_clocks.first().copied(),
        }
    }

    /// Whether every pixel is the model's and leaves in its clock.
    pub fn agrees(&self) -> bool {
        self.differing_pixels == 0 && self.wrong_clocks == 0
    }

    /// The result as text.
    pub fn in_words(&self) -> String {
        let NetlistRun { scene, spans, pixels, differing_pixels, .. } = self;
        let pixel = self.first_difference.as_ref().map(|Difference { x, y, expected, found }| {
            format!(
                "{differing_pixels} of {pixels} pixels differ, first ({x}, {y}): expected \
                 {expected:?}, found {found:?}"
            )
        });
        let clock = self.first_wrong_clock.map(|clock| {
            format!(
                "{} cycles in which a pixel left that was not due, or was due and did not leave, \
                 first {clock}",
                self.wrong_clocks
            )
        });
        let wrong: Vec<String> = pixel.into_iter().chain(clock).collect();
        if wrong.is_empty() {
            format!("{pixels} pixels equal, of {spans} spans of {scene}")
        } else {
            wrong.join("; ")
        }
    }
}

/// The frame with so few of its spans, from top to bottom, that they have about [`PIXELS`] pixels.
fn some_spans(frame: &Frame) -> Frame {
    let step = frame.shaded_pixels().div_ceil(PIXELS).max(1);
    let spans = frame.spans.iter().step_by(step as usize).cloned().collect();
    Frame { spans, ..frame.clone() }
}

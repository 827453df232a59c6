//! The measured error and the proven bound of a scene and its core.
use std::panic::{AssertUnwindSafe, catch_unwind};

use specula_datapath::Design;
use specula_golden::exact::MethodSpan;
use specula_golden::fixed::{Model, PacketError};
use specula_scene::{Frame, parse};
use specula_spec::{CoreSpec, FULL_SCALE, SceneCore};

use super::genome::FILE;
use specula_testbench::FrameSpans;
use specula_testbench::{Bench, BenchError, EngineKind};

/// The measurement of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// The bound on the quantisation error, in LSBs.
    pub bound: f64,
    /// The largest quantisation error of a code against the method in exact arithmetic, in LSBs.
    pub largest: f64,
    /// The largest error of a sum of light before it is rounded to a code, in LSBs.
    pub unrounded: f64,
}

impl Measure {
    /// The largest quantisation error divided by the bound. Above 1 the bound is broken.
    pub fn ratio(&self) -> f64 {
        self.largest / self.bound.max(f64::MIN_POSITIVE)
    }
}

/// The reason why there is no measurement.
#[derive(Clone, Debug, PartialEq)]
pub enum Unmeasured {
    /// There is no such core, for a reason that a user would be told.
    Refused,
    /// A fault, which must never happen.
    Fault(String),
}

/// A function that gives the bound of a design in LSBs.
pub type Bound = dyn Fn(&Design) -> f64 + Sync;

/// The bound that a design states, in LSBs.
pub fn proven(design: &Design) -> f64 {
    design.error_bound()
}

/// Shades the scene of a file with the bit-true model of its core; `bound` gives the core's bound.
///
/// The scene is parsed from its text, so that the measured scene is the one that the file
/// describes.
///
/// # Errors
/// [`Unmeasured`] if there is no such core, or if it has a fault other than a broken bound.
pub fn measure(text: String, bound: &Bound) -> Result<Measure, Unmeasured> {
    catch_panic(|| {
        let (spec, frame) = read(text)?;
        let design = specula_hdl::elaborate(&spec, "core").map_err(|_| Unmeasured::Refused)?;
        let [largest, unrounded] =
            errors(&spec, &frame).map_err(|error| Unmeasured::Fault(error.to_string()))?;
        Ok(Measure { bound: bound(&design), largest, unrounded })
    })
}

/// Checks that the simulated core agrees with the model.
///
/// # Errors
/// [`Unmeasured`] if it does not.
pub fn simulate(text: String) -> Result<(), Unmeasured> {
    catch_panic(|| {
        let (spec, frame) = read(text)?;
        let run = || Bench::new(&frame, &spec, "core")?.run(EngineKind::Fast, &mut |_, _| ());
        match run() {
            Ok(outcome) if outcome.agrees() => Ok(()),
            Ok(_) => Err(Unmeasured::Fault(
                "the simulated core does not do what the bit-true model says".to_owned(),
            )),
            Err(BenchError::TooWide(_)) => Err(Unmeasured::Refused),
            Err(error) => Err(Unmeasured::Fault(error.to_string())),
        }
    })
}

/// The core and the frame of a scene file.
fn read(text: String) -> Result<(CoreSpec, Frame), Unmeasured> {
    let loaded = parse(FILE, text).map_err(|_| Unmeasured::Refused)?;
    let spec = loaded.core_spec(None).map_err(|_| Unmeasured::Refused)?;
    Ok((spec, loaded.frame))
}

/// Turns a panic into a fault, so that it does not end the search.
fn catch_panic<T>(body: impl FnOnce() -> Result<T, Unmeasured>) -> Result<T, Unmeasured> {
    catch_unwind(AssertUnwindSafe(body))
        .unwrap_or_else(|_| Err(Unmeasured::Fault("a panic".to_owned())))
}

/// The largest errors of codes, and of sums of light, against the method in exact arithmetic, in
/// LSBs.
fn errors(spec: &CoreSpec, frame: &Frame) -> Result<[f64; 2], PacketError> {
    let (model, spans) = (Model::new(spec), FrameSpans::new(frame, spec));
    let mut largest = [0.0_f64; 2];
    for (index, span) in frame.spans.iter().enumerate() {
        let method = MethodSpan::new(spec, frame, span);
        for (sums, pixel) in model.sums(&spans.packet(index))?.into_iter().zip(0..) {
            for (sum, exact) in sums.into_iter().zip(method.pixel(pixel)) {
                let sum = sum.min(FULL_SCALE);
                let code = (sum + 0.5).floor();
                largest =
                    [largest[0].max((code - exact).abs()), largest[1].max((sum - exact).abs())];
            }
        }
    }
    Ok(largest)
}

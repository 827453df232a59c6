//! The core that a scene is given where nobody names a method: the smallest whose picture is near
//! enough to exact shading.
//!
//! A search for formats takes a tenth of a second, and there are some eighty methods with their
//! options, so it is made for few. First, the error of each in exact arithmetic on a sample of pixels
//! says which could be near enough; then the size of each of these in recommended formats, on the
//! target if there is one, says which are small. Those are given their formats, and the smallest that
//! keeps the goal is chosen.
use rayon::prelude::*;
use serde::Serialize;
use specula_scene::{Frame, LoadedScene, Needs};
use specula_spec::{CoreError, CoreSpec, Method, SceneCore};
use specula_testbench::BenchError;

use crate::cost::Cost;
use crate::formats::{Products, default_core};
use crate::picture::{ExactPicture, sampled};
use crate::stress::variant::Variant;

/// The largest total error of a core that nobody chose, in LSBs.
pub const GOAL: f64 = 2.0;

/// Pixels that are looked at, and frames of a sequence.
const SAMPLE: u64 = 6000;
const FRAMES: u32 = 6;
/// What quantisation adds to the error of a method, in LSBs: rounding to 8 bits, and a little.
const QUANTISATION: f64 = 0.6;
/// How many methods are given their formats, and with how many options each.
const METHODS: usize = 3;
const VARIANTS: usize = 2;

/// A method with options that was looked at.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Candidate {
    /// The method, and options that differ from its defaults.
    pub core: String,
    /// The largest total error on the sample, in LSBs; of one that was given no formats, what it is
    /// expected to be.
    pub error: f64,
    /// What it takes, in cells.
    pub cells: u64,
}

/// The choice of a core.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The core, in the formats that are recommended.
    pub spec: CoreSpec,
    /// The choice.
    pub chosen: Candidate,
    /// The next best by another method, if there is one.
    pub next: Option<Candidate>,
    /// Whether the chosen core keeps the goal. Where none does it is the most exact one.
    pub keeps_goal: bool,
    /// The goal, in LSBs.
    pub goal: f64,
}

impl Choice {
    /// Why it was chosen, for people to read.
    pub fn in_words(&self) -> String {
        let Choice { chosen, next, goal, .. } = self;
        let Candidate { core, error, cells } = chosen;
        let why = if self.keeps_goal {
            format!(
                "{core}: the smallest whose error stays within {goal} LSB ({error:.2} LSB, {cells} cells)"
            )
        } else {
            format!(
                "{core}: no core stays within {goal} LSB, and it comes nearest ({error:.2} LSB, {cells} cells)"
            )
        };
        let next = next.as_ref().map(|Candidate { core, error, cells: others }| {
            let more = 100.0 * (*others as f64 / *cells as f64 - 1.0);
            format!("; next best {core}: {error:.2} LSB, {more:+.0} % cells")
        });
        why + &next.unwrap_or_default()
    }
}

/// The core for a scene whose total error stays within `goal` LSBs on a sample of its pixels; the
/// most exact one where there is none.
///
/// # Errors
/// [`CoreError`] if no method has a core for the scene, or a core cannot be built.
pub fn choose(scene: &LoadedScene, goal: f64, products: &Products) -> Result<Choice, AutoError> {
    // What is wrong with the scene's own table is told, where no core at all would be.
    scene.unnamed_formats()?;
    let needs = scene.needs()?;
    let pictures = pictures(scene)?;
    let all: Vec<Variant> = Method::ALL.into_iter().flat_map(Variant::all_of).collect();
    let frames = pictures.iter().map(|picture| picture.frame.clone()).collect();
    let look = Look { scene, needs: &needs, pictures: &pictures, frames, products };
    let mut seen: Vec<Seen> =
        all.into_par_iter().filter_map(|variant| look.at(variant, goal)).collect();
    seen.sort_by(|a, b| a.rank(goal).total_cmp(&b.rank(goal)));
    // One that cannot be built in its formats is none that could be chosen.
    let finished = finalists(seen).into_par_iter().filter_map(|seen| look.finished(seen).ok());
    chosen(finished.collect(), goal).ok_or(AutoError::Nothing)
}

/// The smallest core that is found which is both smaller and more exact than `spec`, a core for the
/// scene alone, on a sample of its pixels; `None` if none is.
///
/// # Errors
/// As [`choose`].
pub fn better_than(
    scene: &LoadedScene,
    spec: &CoreSpec,
    products: &Products,
) -> Result<Option<Candidate>, AutoError> {
    let errors = pictures(scene)?.iter().map(|picture| picture.largest_error(spec)).collect();
    let error = errors_of(errors)?;
    let design = specula_hdl::elaborate(spec, "core").map_err(BenchError::from)?;
    let cells = Cost::of(&design, products.block()).cells();
    let best = choose(scene, error, products)?.chosen;
    Ok((best.error < error && best.cells < cells).then_some(best))
}

/// The largest of several errors.
fn errors_of(errors: Result<Vec<f64>, BenchError>) -> Result<f64, BenchError> {
    Ok(errors?.into_iter().fold(0.0, f64::max))
}

/// The best options of each of the best methods.
fn finalists(seen: Vec<Seen>) -> Vec<Seen> {
    let mut methods: Vec<Method> = vec![];
    let mut kept: Vec<Seen> = vec![];
    for next in seen {
        let method = next.spec.method();
        if !methods.contains(&method) && methods.len() < METHODS {
            methods.push(method);
        }
        let same = kept.iter().filter(|other| other.spec.method() == method).count();
        if methods.contains(&method) && same < VARIANTS {
            kept.push(next);
        }
    }
    kept
}

/// The best of those that have their formats.
fn chosen(mut finalists: Vec<Seen>, goal: f64) -> Option<Choice> {
    finalists.sort_by(|a, b| a.rank(goal).total_cmp(&b.rank(goal)));
    let mut all = finalists.into_iter();
    let best = all.next()?;
    let next = all.find(|other| other.spec.method() != best.spec.method());
    Some(Choice {
        keeps_goal: best.candidate.error <= goal,
        spec: best.spec,
        chosen: best.candidate,
        next: next.map(|next| next.candidate),
        goal,
    })
}

/// Why no core was chosen.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum AutoError {
    /// A frame cannot be drawn, or its file is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Core(#[from] CoreError),
    /// A core cannot be built.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Bench(#[from] BenchError),
    /// No method can shade the scene.
    #[error("no method has a core for the scene")]
    #[diagnostic(code(specula::auto), help("name a method with `--method`: it says what it lacks"))]
    Nothing,
}

impl From<specula_scene::SceneError> for AutoError {
    fn from(error: specula_scene::SceneError) -> AutoError {
        AutoError::Core(error.into())
    }
}

/// A sample of a scene's pixels with their exact shades; of a sequence, from frames over its whole
/// time.
fn pictures(scene: &LoadedScene) -> Result<Vec<ExactPicture>, specula_scene::SceneError> {
    let Some(sequence) = &scene.sequence else {
        return Ok(vec![ExactPicture::new(sampled(&scene.frame, SAMPLE))]);
    };
    let frames = FRAMES.min(sequence.frames());
    let number = |k: u32| k * sequence.frames() / frames;
    let sample = |frame: &Frame| ExactPicture::new(sampled(frame, SAMPLE / u64::from(frames)));
    let all = (0..frames).map(|k| sequence.frame(number(k)));
    let mut all: Vec<Frame> = all.collect::<Result<_, specula_scene::SceneError>>()?;
    all.retain(|frame| !frame.spans.is_empty());
    // Where something is visible for a few frames only, all of these may have missed it.
    if all.is_empty() {
        all.push(scene.frame.clone());
    }
    Ok(all.iter().map(sample).collect())
}

/// What methods are looked at with.
struct Look<'a> {
    scene: &'a LoadedScene,
    needs: &'a Needs,
    pictures: &'a [ExactPicture],
    /// The same without their shades.
    frames: Vec<Frame>,
    products: &'a Products,
}

/// The general core of a method with options, and what is known of it.
struct Seen {
    spec: CoreSpec,
    candidate: Candidate,
}

impl Seen {
    /// By what they are compared: those within the goal by their size, and above them the others by
    /// their error.
    fn rank(&self, goal: f64) -> f64 {
        let Candidate { error, cells, .. } = self.candidate;
        if error <= goal { cells as f64 } else { 1e15 * (1.0 + error) }
    }
}

impl Look<'_> {
    /// A method in recommended formats; none if there is no such core, or it cannot keep the goal and
    /// is no method's default.
    fn at(&self, variant: Variant, goal: f64) -> Option<Seen> {
        let spec = self.scene.core_with(&variant.options().ok()?, self.needs).ok()?;
        let of_method = self.pictures.iter().map(|picture| picture.error_of_method(&spec));
        let error = of_method.fold(0.0, f64::max) + QUANTISATION;
        if error > goal && !variant.table.is_empty() {
            return None;
        }
        let cells = self.cells(&spec.specialised(&self.frames[..])).ok()?;
        let candidate = Candidate { core: variant.describe(), error, cells };
        Some(Seen { spec, candidate })
    }

    /// The same in its own formats, with its measured error.
    fn finished(&self, seen: Seen) -> Result<Seen, BenchError> {
        let frames = &self.frames[..];
        let start = seen.spec.specialised(frames);
        let core = default_core(start, frames, &[], self.products.clone())?;
        let errors = self.pictures.iter().map(|picture| picture.largest_error(&core.spec));
        let error = errors_of(errors.collect())?;
        let cells = self.cells(&core.spec)?;
        Ok(Seen { candidate: Candidate { error, cells, ..seen.candidate }, ..seen })
    }

    fn cells(&self, spec: &CoreSpec) -> Result<u64, BenchError> {
        let design = specula_hdl::elaborate(spec, "core")?;
        Ok(Cost::of(&design, self.products.block()).cells())
    }
}

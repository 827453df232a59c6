//! The search for the narrowest formats that keep a core within an error.
use rayon::prelude::*;
use specula_golden::exact::MethodSpan;
use specula_golden::fixed::Model;
use specula_scene::Frame;
use specula_spec::{CoreSpec, Format};

use specula_testbench::BenchError;
use specula_testbench::FrameSpans;

/// The most fraction bits by which all formats are made finer than the default ones.
const MOST_ADDED: i32 = 6;

/// Why no core was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error, miette::Diagnostic)]
#[error(
    "no formats keep `{method}` within {wanted} LSB of exact shading by that method; the best that were tried come to {best:.3} LSB"
)]
#[diagnostic(
    code(specula::search),
    help(
        "ask for more; rounding to 8 bits alone takes up to 0.5 LSB, so 1lsb is what can be asked of most scenes"
    )
)]
pub struct NotFound {
    /// The method.
    pub method: &'static str,
    /// The error asked for, in LSBs.
    pub wanted: f64,
    /// The smallest found, in LSBs.
    pub best: f64,
}

/// `start` with the narrowest formats that were found to keep every pixel of `frame` within `most`
/// LSBs of exact shading by its method, the rounding to 8 bits counted. Each trial is measured on
/// all pixels with the bit-true model.
///
/// All formats get narrower together, from the documented defaults on (or finer, where those do not
/// do), and then each by itself, in the order of the data, as long as the error stays and
/// multipliers get smaller or stay. It is a descent: what it finds is within the error, and need
/// not be the smallest core there is.
///
/// # Errors
/// [`NotFound`] with the smallest error of those tried; [`BenchError`] where a core cannot be
/// built.
pub fn within(
    start: &CoreSpec,
    frame: &Frame,
    most: f64,
) -> Result<Result<CoreSpec, NotFound>, BenchError> {
    let start = start.general();
    let goal = Goal { most, error: &|spec: &CoreSpec| largest_error(spec, frame), cost: &cost };
    Ok(match goal.together(&start)? {
        Ok(found) => Ok(goal.each(found)?),
        Err(best) => Err(NotFound { method: start.method().name(), wanted: most, best }),
    })
}

/// What formats are narrowed for.
pub(crate) struct Goal<'a, Cost> {
    /// The largest error, in LSBs.
    pub most: f64,
    /// The error of a core, in LSBs.
    pub error: &'a dyn Fn(&CoreSpec) -> Result<f64, BenchError>,
    /// What it costs.
    pub cost: &'a dyn Fn(&CoreSpec) -> Result<Cost, BenchError>,
}

impl<Cost: Ord> Goal<'_, Cost> {
    /// `start` with all formats narrowed together as far as they can be, or made finer as far as
    /// they must; the smallest error of those tried where that is not enough.
    pub fn together(&self, start: &CoreSpec) -> Result<Result<CoreSpec, f64>, BenchError> {
        let mut best = f64::INFINITY;
        let mut found = None;
        for added in 0..=MOST_ADDED {
            let Some(spec) = start.finer(added, &[]) else { continue };
            let error = (self.error)(&spec)?;
            best = best.min(error);
            if error <= self.most {
                found = Some(spec);
                break;
            }
        }
        let Some(mut found) = found else { return Ok(Err(best)) };
        while let Some(spec) = found.finer(-1, &[]) {
            if (self.error)(&spec)? > self.most {
                break;
            }
            found = spec;
        }
        Ok(Ok(found))
    }

    /// Each format by itself narrowed as far as it can be, as long as nothing gets larger.
    pub fn each(&self, mut found: CoreSpec) -> Result<CoreSpec, BenchError> {
        for name in found.narrowing_points().into_iter().map(|point| point.name) {
            while let Some(spec) = narrower(&found, name) {
                if (self.cost)(&spec)? > (self.cost)(&found)? || (self.error)(&spec)? > self.most {
                    break;
                }
                found = spec;
            }
        }
        Ok(found)
    }
}

/// Largest |code - method in f64| over every pixel and channel, in LSBs.
pub(crate) fn largest_error(spec: &CoreSpec, frame: &Frame) -> Result<f64, BenchError> {
    let (model, spans) = (Model::new(spec), FrameSpans::new(frame, spec));
    let of_span = |index: usize| {
        let mut codes = vec![];
        model.shade(&spans.packet(index), &mut codes)?;
        let mut exact = vec![[0.0; 3]; codes.len()];
        MethodSpan::new(spec, frame, &frame.spans[index]).shade(&mut exact);
        let channels = codes.iter().flatten().zip(exact.iter().flatten());
        Ok(channels.map(|(&code, exact)| (f64::from(code) - exact).abs()).fold(0.0, f64::max))
    };
    (0..frame.spans.len())
        .into_par_iter()
        .map(of_span)
        .try_reduce(|| 0.0, |a, b| Ok(f64::max(a, b)))
}

/// Multiplier bits, and then registers.
fn cost(spec: &CoreSpec) -> Result<(u64, u64), BenchError> {
    let size = specula_hdl::elaborate(spec, "core")?.size();
    Ok((size.multiplier_bits, size.register_bits))
}

/// One format narrower by a bit; none where it may not be.
fn narrower(spec: &CoreSpec, name: &str) -> Option<CoreSpec> {
    let point = spec.narrowing_points().into_iter().find(|point| point.name == name)?;
    let fraction_bits = point.format.fraction_bits.checked_sub(1)?;
    spec.with_formats(&[(point.name, Format { fraction_bits, ..point.format })]).ok()
}

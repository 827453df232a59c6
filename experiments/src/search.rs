//! The search for the narrowest formats that keep a core within an error.
use rayon::prelude::*;
use specula_golden::exact::MethodSpan;
use specula_golden::fixed::Model;
use specula_scene::Frame;
use specula_spec::{CoreSpec, Format};

use crate::picture::ExactPicture;
use specula_testbench::BenchError;
use specula_testbench::FrameSpans;

/// Largest number of fraction bits that are added to the default formats.
const MAX_ADDED: i32 = 6;

/// Which error is measured on every pixel of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measured {
    /// Against exact shading.
    Total,
    /// Against exact shading by the core's own method.
    Quantisation,
}

impl Measured {
    /// What codes are compared with.
    fn against(self) -> &'static str {
        match self {
            Measured::Total => "exact shading",
            Measured::Quantisation => "exact shading by that method",
        }
    }
}

/// The reason why no core was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error, miette::Diagnostic)]
#[error(
    "no formats keep `{method}` within {wanted} LSB of {} on this scene; the best that were tried come to {best:.3} LSB{}",
    measured.against(),
    own_in_words(*own)
)]
#[diagnostic(
    code(specula::search),
    help(
        "ask for more; rounding to 8 bits alone takes up to 0.5 LSB, and a total error contains the method's own"
    )
)]
pub struct NotFound {
    /// The method.
    pub method: &'static str,
    /// The error that was measured.
    pub measured: Measured,
    /// The error asked for, in LSBs.
    pub wanted: f64,
    /// The smallest error found, in LSBs.
    pub best: f64,
    /// The error of the method in exact arithmetic, in LSBs, if that alone is larger than what was
    /// asked for.
    pub own: Option<f64>,
}

fn own_in_words(own: Option<f64>) -> String {
    let in_words = |own| {
        format!(
            "; the method's own error, in exact arithmetic, is {own:.3} LSB, which no format lowers"
        )
    };
    own.map(in_words).unwrap_or_default()
}

/// `start` with the narrowest formats found whose error on `frame` is `most` LSBs at most on every
/// pixel, including the rounding to 8 bits. Each trial is measured on all pixels with the bit-true
/// model.
///
/// All formats are narrowed together, starting at the documented defaults (or at finer ones, if
/// those are not enough), and then each separately, in the order of the data flow, as long as the
/// error is kept and multipliers do not grow. This is a descent: the result keeps the error but
/// need not be the smallest core.
///
/// # Errors
/// [`NotFound`] with the smallest error of those tried; [`BenchError`] if a core cannot be built.
pub fn narrowest_formats(
    start: &CoreSpec,
    frame: &Frame,
    (measured, most): (Measured, f64),
) -> Result<Result<CoreSpec, NotFound>, BenchError> {
    let start = start.general();
    let exact = (measured == Measured::Total).then(|| ExactPicture::new(frame.clone()));
    let error = |spec: &CoreSpec| match &exact {
        Some(exact) => exact.largest_error(spec),
        None => largest_error(spec, frame),
    };
    let goal = Goal { most, error: &error, cost: &cost };
    Ok(match goal.narrow_together(&start)? {
        Ok(found) => Ok(goal.narrow_each(found)?),
        Err(best) => {
            let own = exact.map(|exact| exact.error_of_method(&start));
            let own = own.filter(|own| *own > most);
            Err(NotFound { method: start.method().name(), measured, wanted: most, best, own })
        }
    })
}

/// The goal of narrowing formats.
pub(crate) struct Goal<'a, Cost> {
    /// The largest error, in LSBs.
    pub most: f64,
    /// The error of a core, in LSBs.
    pub error: &'a dyn Fn(&CoreSpec) -> Result<f64, BenchError>,
    /// The cost of a core.
    pub cost: &'a dyn Fn(&CoreSpec) -> Result<Cost, BenchError>,
}

impl<Cost: Ord> Goal<'_, Cost> {
    /// `start` with all formats narrowed together as far as possible, or made finer as far as
    /// necessary. The inner error is the smallest error found if that is not enough.
    pub fn narrow_together(&self, start: &CoreSpec) -> Result<Result<CoreSpec, f64>, BenchError> {
        let mut best = f64::INFINITY;
        let mut found = None;
        for added in 0..=MAX_ADDED {
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

    /// Narrows each format separately as far as possible, as long as no cost grows.
    pub fn narrow_each(&self, mut found: CoreSpec) -> Result<CoreSpec, BenchError> {
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

/// Largest error of a core's method in exact arithmetic, against exact shading, over every pixel and
/// channel of a frame, in LSBs.
pub fn error_of_method(spec: &CoreSpec, frame: &Frame) -> f64 {
    ExactPicture::new(frame.clone()).error_of_method(spec)
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

/// The cost: multiplier bits, and then registers.
fn cost(spec: &CoreSpec) -> Result<(u64, u64), BenchError> {
    let size = specula_hdl::elaborate(spec, "core")?.size();
    Ok((size.multiplier_bits, size.register_bits))
}

/// The core with one format narrower by a bit; `None` if it may not be narrower.
fn narrower(spec: &CoreSpec, name: &str) -> Option<CoreSpec> {
    let point = spec.narrowing_points().into_iter().find(|point| point.name == name)?;
    let fraction_bits = point.format.fraction_bits.checked_sub(1)?;
    spec.with_formats(&[(point.name, Format { fraction_bits, ..point.format })]).ok()
}

//! The exact picture of a frame, with which many cores are compared.
use rayon::prelude::*;
use specula_golden::exact::{MethodSpan, PhongSpan};
use specula_golden::fixed::Model;
use specula_scene::Frame;
use specula_spec::CoreSpec;

use specula_testbench::BenchError;
use specula_testbench::FrameSpans;

/// A frame and its exact shades.
pub(crate) struct ExactPicture {
    pub frame: Frame,
    /// The exact shades of each span's pixels, in LSBs.
    exact: Vec<Vec<[f64; 3]>>,
}

impl ExactPicture {
    /// Shades every pixel of a frame.
    pub fn new(frame: Frame) -> ExactPicture {
        let shaded = |span: &specula_scene::Span| {
            let phong = PhongSpan::new(&frame, span);
            (0..span.length).map(|i| phong.pixel(i)).collect()
        };
        let exact = frame.spans.par_iter().map(shaded).collect();
        ExactPicture { frame, exact }
    }

    /// Largest |code - exact| of a core over every pixel and channel in LSBs, computed with the
    /// bit-true model.
    pub fn largest_error(&self, spec: &CoreSpec) -> Result<f64, BenchError> {
        let (model, spans) = (Model::new(spec), FrameSpans::new(&self.frame, spec));
        let of_span = |(index, exact): (usize, &Vec<[f64; 3]>)| {
            let mut codes = Vec::with_capacity(exact.len());
            model.shade(&spans.packet(index), &mut codes)?;
            let channels = codes.iter().flatten().zip(exact.iter().flatten());
            Ok(channels.map(|(&code, exact)| (f64::from(code) - exact).abs()).fold(0.0, f64::max))
        };
        self.exact.par_iter().enumerate().map(of_span).try_reduce(|| 0.0, |a, b| Ok(f64::max(a, b)))
    }

    /// Largest error of a core's method in exact arithmetic, over every pixel and channel, in LSBs.
    pub fn error_of_method(&self, spec: &CoreSpec) -> f64 {
        let of_span = |(index, exact): (usize, &Vec<[f64; 3]>)| {
            let mut own = vec![[0.0; 3]; exact.len()];
            MethodSpan::new(spec, &self.frame, &self.frame.spans[index]).shade(&mut own);
            let channels = own.iter().flatten().zip(exact.iter().flatten());
            channels.map(|(own, exact)| (own - exact).abs()).fold(0.0, f64::max)
        };
        self.exact.par_iter().enumerate().map(of_span).reduce(|| 0.0, f64::max)
    }
}

/// The frame with an evenly distributed part of the spans, which have about `pixels` pixels; the
/// same frame if it has no more.
pub(crate) fn sampled(frame: &Frame, pixels: u64) -> Frame {
    let every = frame.shaded_pixels().div_ceil(pixels).max(1) as usize;
    Frame { spans: frame.spans.iter().step_by(every).cloned().collect(), ..frame.clone() }
}

//! Every pixel against the bit-true model, the method in f64, and exact shading.
use rayon::prelude::*;
use specula_golden::exact::{MethodSpan, PhongSpan};
use specula_golden::fixed::Model;
use specula_scene::{Frame, Span};
use specula_sim::{FirstPixels, SpanSource};
use specula_spec::{CoreSpec, SpanPacket};

use crate::statistics::{Errors, Sums};
use crate::{BenchError, Image, KeptSpans};

/// A pixel whose code is not the model's.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mismatch {
    /// Column.
    pub x: u32,
    /// Row.
    pub y: u32,
    /// Number of the span.
    pub span: usize,
    /// Number of the pixel in its span.
    pub pixel: u32,
    /// What the core gave.
    pub simulated: [u8; 3],
    /// What the model gives.
    pub expected: [u8; 3],
}

/// The pixel with the largest total error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstPixel {
    /// Column.
    pub x: u32,
    /// Row.
    pub y: u32,
    /// Number of the span.
    pub span: usize,
    /// Number of the pixel in its span.
    pub pixel: u32,
    /// Its largest channel error, in LSBs.
    pub error_lsb: f64,
}

/// The channel of a pixel that is furthest from its method in exact arithmetic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstQuantisation {
    /// Column.
    pub x: u32,
    /// Row.
    pub y: u32,
    /// Number of the span.
    pub span: usize,
    /// Number of the pixel in its span.
    pub pixel: u32,
    /// 0 for red, 1 for green, 2 for blue.
    pub channel: usize,
    /// The code that the core gave.
    pub simulated: u8,
    /// The code that the bit-true model gives.
    pub expected: u8,
    /// What the method gives in exact arithmetic, in LSBs.
    pub method: f64,
    /// By how much the code is off from that, in LSBs.
    pub error_lsb: f64,
}

/// The comparison of a whole frame.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Pixels whose code is not the model's.
    pub mismatches: u64,
    /// The first of them.
    pub first_mismatch: Option<Mismatch>,
    /// The error figures.
    pub errors: Errors,
    /// Largest difference between the core's code and the rounded method in f64, in codes.
    pub largest_code_difference: u8,
    /// The pixel with the largest total error; none in a frame without pixels.
    pub worst_pixel: Option<WorstPixel>,
    /// The largest quantisation error; none in a frame without pixels.
    pub worst_quantisation: Option<WorstQuantisation>,
    /// Pixels with a quantisation error above what is proven of it.
    pub beyond_bound: u64,
    /// The bit-true model's picture.
    pub expected: Image,
    /// Exact shading, rounded.
    pub exact: Image,
    /// Total error of each pixel, largest over its channels, in LSBs; negative where nothing is
    /// shaded.
    pub error_map: Vec<f32>,
}

/// What one span adds.
#[derive(Default)]
struct SpanResult {
    expected: Vec<[u8; 3]>,
    exact: Vec<[u8; 3]>,
    errors: Vec<f32>,
    mismatches: u64,
    first_mismatch: Option<Mismatch>,
    worst: Option<WorstPixel>,
    worst_quantisation: Option<WorstQuantisation>,
    beyond_bound: u64,
    largest_code_difference: u8,
    sums: [Sums; 3],
}

/// What the core was given of the frame's spans, and what it gave.
pub(crate) struct Given<'a> {
    pub spans: &'a KeptSpans,
    pub first_pixels: &'a FirstPixels,
    /// One for each pixel, in span order.
    pub codes: &'a [[u8; 3]],
}

/// Compares a core's codes with every model. No error is to exceed `bound` LSBs.
///
/// Spans are worked on in parallel; what they give is put together in their order, so the result
/// does not depend on threads.
///
/// # Errors
/// [`BenchError::Packet`] if the model refuses a span.
pub(crate) fn compare(
    (spec, frame): (&CoreSpec, &Frame),
    given: &Given,
    bound: f64,
) -> Result<Comparison, BenchError> {
    let model = Model::new(spec);
    let mut whole = Whole::new(frame);
    // A block of spans at a time, so that memory does not grow with the frame.
    for block in (0..frame.spans.len()).collect::<Vec<_>>().chunks(4096) {
        let one = |scratch: &mut Scratch, &index: &usize| {
            compare_span((spec, frame), (&model, given), index, scratch, bound)
        };
        let results: Vec<Result<SpanResult, BenchError>> =
            block.par_iter().map_init(Scratch::new, one).collect();
        for (&index, result) in block.iter().zip(results) {
            whole.add(&frame.spans[index], result?);
        }
    }
    Ok(whole.finish())
}

/// Memory that is used again for one span after the other.
struct Scratch {
    packet: SpanPacket,
    method: Vec<[f64; 3]>,
}

impl Scratch {
    fn new() -> Scratch {
        Scratch { packet: SpanPacket { length: 0, inputs: Vec::new() }, method: Vec::new() }
    }

    /// A span as the core was given it.
    fn read(&mut self, spans: &KeptSpans, index: usize) {
        self.packet.length = spans.length(index);
        self.packet.inputs.clear();
        self.packet.inputs.extend_from_slice(spans.inputs(index));
    }
}

fn compare_span(
    (spec, frame): (&CoreSpec, &Frame),
    (model, given): (&Model, &Given),
    index: usize,
    scratch: &mut Scratch,
    bound: f64,
) -> Result<SpanResult, BenchError> {
    let span = &frame.spans[index];
    let mut result = SpanResult::default();
    scratch.read(given.spans, index);
    model.shade(&scratch.packet, &mut result.expected)?;
    scratch.method.resize(span.length as usize, [0.0; 3]);
    MethodSpan::new(spec, frame, span).shade(&mut scratch.method);
    let phong = PhongSpan::new(frame, span);
    let [first, end] = [index, index + 1].map(|index| given.first_pixels.of_span(index) as usize);
    let codes = given.codes.get(first..end).unwrap_or(&[]);
    for pixel in 0..span.length {
        let own = pixel as usize;
        let (expected, method) = (result.expected[own], scratch.method[own]);
        // A pixel that never left the core counts as a mismatch.
        let simulated = codes.get(own).copied();
        let exact = phong.pixel(pixel);
        result.add(Pixel { index, pixel, span, simulated, expected, method, exact }, bound);
    }
    Ok(result)
}

struct Pixel<'a> {
    index: usize,
    pixel: u32,
    span: &'a Span,
    simulated: Option<[u8; 3]>,
    expected: [u8; 3],
    method: [f64; 3],
    exact: [f64; 3],
}

impl Pixel<'_> {
    /// The error of a channel that was given as `simulated`.
    fn quantisation(&self, channel: usize, simulated: u8) -> WorstQuantisation {
        let method = self.method[channel];
        WorstQuantisation {
            x: self.span.x + self.pixel,
            y: self.span.y,
            span: self.index,
            pixel: self.pixel,
            channel,
            simulated,
            expected: self.expected[channel],
            method,
            error_lsb: (f64::from(simulated) - method).abs(),
        }
    }
}

fn code(value: f64) -> u8 {
    // Shading is clamped to 0..=255.
    (value + 0.5).floor() as u8
}

impl SpanResult {
    fn add(&mut self, p: Pixel, bound: f64) {
        let simulated = p.simulated.unwrap_or([0; 3]);
        let (x, y) = (p.span.x + p.pixel, p.span.y);
        if p.simulated != Some(p.expected) {
            self.mismatches += 1;
            let (span, pixel, expected) = (p.index, p.pixel, p.expected);
            self.first_mismatch.get_or_insert(Mismatch { x, y, span, pixel, simulated, expected });
        }
        let mut largest: f64 = 0.0;
        let mut is_beyond = false;
        for (c, &given) in simulated.iter().enumerate() {
            let total = f64::from(given) - p.exact[c];
            largest = largest.max(total.abs());
            self.sums[0].add(total);
            self.sums[1].add(p.method[c] - p.exact[c]);
            let quantisation = f64::from(given) - p.method[c];
            self.sums[2].add(quantisation);
            is_beyond |= quantisation.abs() > bound;
            if self.worst_quantisation.is_none_or(|worst| quantisation.abs() > worst.error_lsb) {
                self.worst_quantisation = Some(p.quantisation(c, given));
            }
            self.largest_code_difference =
                self.largest_code_difference.max(given.abs_diff(code(p.method[c])));
        }
        self.beyond_bound += u64::from(is_beyond);
        if self.worst.is_none_or(|w| largest > w.error_lsb) {
            self.worst =
                Some(WorstPixel { x, y, span: p.index, pixel: p.pixel, error_lsb: largest });
        }
        self.exact.push(p.exact.map(code));
        self.errors.push(largest as f32);
    }
}

/// The frame's comparison while spans are added in order.
struct Whole {
    comparison: Comparison,
    sums: [Sums; 3],
}

impl Whole {
    fn new(frame: &Frame) -> Whole {
        let blank = Image::filled(frame.width, frame.height, frame.background);
        let none = Sums::default().figures();
        let comparison = Comparison {
            mismatches: 0,
            first_mismatch: None,
            errors: Errors { total: none.clone(), method: none.clone(), quantisation: none },
            largest_code_difference: 0,
            worst_pixel: None,
            worst_quantisation: None,
            beyond_bound: 0,
            expected: blank.clone(),
            error_map: vec![-1.0; blank.pixels.len()],
            exact: blank,
        };
        Whole { comparison, sums: Default::default() }
    }

    fn add(&mut self, span: &Span, result: SpanResult) {
        let c = &mut self.comparison;
        c.expected.run_mut(span).copy_from_slice(&result.expected);
        c.exact.run_mut(span).copy_from_slice(&result.exact);
        let first = span.y as usize * c.exact.width as usize + span.x as usize;
        c.error_map[first..first + result.errors.len()].copy_from_slice(&result.errors);
        c.mismatches += result.mismatches;
        c.first_mismatch = c.first_mismatch.take().or(result.first_mismatch);
        c.largest_code_difference = c.largest_code_difference.max(result.largest_code_difference);
        if let Some(worst) =
            result.worst.filter(|w| c.worst_pixel.is_none_or(|old| w.error_lsb > old.error_lsb))
        {
            c.worst_pixel = Some(worst);
        }
        let is_worse = |w: &WorstQuantisation| {
            c.worst_quantisation.is_none_or(|old| w.error_lsb > old.error_lsb)
        };
        if let Some(worst) = result.worst_quantisation.filter(is_worse) {
            c.worst_quantisation = Some(worst);
        }
        c.beyond_bound += result.beyond_bound;
        self.sums.iter_mut().zip(&result.sums).for_each(|(mine, theirs)| mine.merge(theirs));
    }

    fn finish(mut self) -> Comparison {
        let [total, method, quantisation] = self.sums.map(|s| s.figures());
        self.comparison.errors = Errors { total, method, quantisation };
        self.comparison
    }
}

//! The drift of recurrences with the length of a span.
use specula_golden::exact::MethodSpan;
use specula_golden::fixed::Model;
use specula_golden::loops::software::by_name;
use specula_scene::{Frame, Needs, SceneError, parse};
use specula_spec::{CoreOptions, CoreSpec, Method, NarrowingPoint};

use super::draw::tilted;
use super::scene::{RawSpan, SpanScene, lit};
use super::variant::Variant;

/// A recurrence's largest error over spans of growing length.
#[derive(Clone, Debug, PartialEq)]
pub struct Drift {
    /// The name of the recurrence.
    pub name: String,
    /// Steps S of the span, and the largest error on it in LSBs.
    pub points: Vec<(u32, f64)>,
}

/// Numbers of steps from the first pixel to the last.
const STEPS: [u32; 12] = [4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8191];
/// Loops in f32 that add increments from pixel to pixel.
const LOOPS: [&str; 7] = ["duff", "hybrid", "reflection", "slerp", "direct", "phong", "gouraud"];

/// The frame of a span of 30 degrees with a highlight of n = 256, on which every recurrence
/// changes.
fn frame(steps: u32) -> Result<Frame, SceneError> {
    let span = RawSpan::between([tilted(-12.0), tilted(18.0)], steps + 1, lit(256));
    parse("drift.toml", SpanScene::new(&[tilted(10.0)], vec![span]).text(""))
        .map(|scene| scene.frame)
}

/// The errors of all lengths for which `error` gives one.
fn over_lengths(name: &str, steps: &[u32], error: impl Fn(&Frame) -> Option<f64>) -> Drift {
    let point = |&steps: &u32| Some((steps, error(&frame(steps).ok()?)?));
    Drift { name: name.to_owned(), points: steps.iter().filter_map(point).collect() }
}

/// The papers' loops in f32, compared with their methods in f64.
pub fn software(longest: u32) -> Vec<Drift> {
    let steps: Vec<u32> = STEPS.into_iter().filter(|&steps| steps < longest).collect();
    LOOPS.map(|name| over_lengths(name, &steps, |frame| software_error(name, frame))).into()
}

/// Largest difference of an f32 loop from the method of that name in f64.
fn software_error(name: &str, frame: &Frame) -> Option<f64> {
    let (span, needs) = (&frame.spans[0], Needs::of(frame));
    let spec = CoreSpec::for_scene(&needs, None, Some(Method::from_name(name).ok()?)).ok()?;
    let mut shades = vec![[0.0; 3]; span.length as usize];
    by_name(name)?.shade(frame, span, &mut shades);
    let method = MethodSpan::new(&spec, frame, span);
    let off =
        |(i, shade): (usize, &[f32; 3])| (f64::from(shade[1]) - method.pixel(i as u32)[1]).abs();
    Some(shades.iter().enumerate().map(off).fold(0.0, f64::max))
}

/// The bit-true models with the formats for a span of 64 pixels.
pub fn fixed(longest: u32) -> Vec<Drift> {
    let steps: Vec<u32> = STEPS.into_iter().filter(|&steps| steps < longest).collect();
    Method::ALL
        .map(|method| {
            over_lengths(method.name(), &steps, |frame| {
                fixed_error(&short_spec(method, frame)?, frame)
            })
        })
        .into()
}

/// The bit-true models with the formats that are chosen for the span.
pub fn chosen(longest: u32) -> Vec<Drift> {
    let steps: Vec<u32> = STEPS.into_iter().filter(|&steps| steps < longest).collect();
    let error = |method, frame: &Frame| {
        fixed_error(&CoreSpec::for_scene(&Needs::of(frame), None, Some(method)).ok()?, frame)
    };
    Method::ALL
        .map(|method| over_lengths(method.name(), &steps, |frame| error(method, frame)))
        .into()
}

fn short_spec(method: Method, frame: &Frame) -> Option<CoreSpec> {
    let needs = Needs::of(frame);
    let short =
        CoreSpec::for_scene(&Needs { longest_span: 64, ..needs.clone() }, None, Some(method))
            .ok()?;
    let line = |point: &NarrowingPoint| format!("formats.{} = \"{}\"\n", point.name, point.format);
    let table: String = short.narrowing_points().iter().map(line).collect();
    let options: CoreOptions = Variant { method, table }.options().ok()?;
    CoreSpec::for_scene(&needs, Some(&options), Some(method)).ok()
}

fn fixed_error(spec: &CoreSpec, frame: &Frame) -> Option<f64> {
    let span = &frame.spans[0];
    let mut codes = Vec::new();
    Model::new(spec).shade(&spec.packet(frame, span), &mut codes).ok()?;
    let method = MethodSpan::new(spec, frame, span);
    let off = |(i, code): (usize, &[u8; 3])| (f64::from(code[1]) - method.pixel(i as u32)[1]).abs();
    Some(codes.iter().enumerate().map(off).fold(0.0, f64::max))
}

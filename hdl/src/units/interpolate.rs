//! Vectors along a span.
use specula_scene::Format;

use crate::builder::{Builder, Sig, Vector};

/// What the normal along a span is interpolated from.
pub struct SpanNormals<'a> {
    /// 1 at the first pixel.
    pub first: &'a Sig,
    /// N0.
    pub start: &'a Vector,
    /// N1 - N0.
    pub delta: &'a Vector,
    /// 1/S.
    pub weight_step: &'a Sig,
}

/// Where an interpolation rounds.
#[derive(Clone, Copy, Debug)]
pub struct Interpolation {
    /// The weight's accumulator.
    pub accumulator: Format,
    /// The weight.
    pub weight: Format,
    /// Components of the vector.
    pub vector: Format,
    /// How long the vectors at the ends are but for rounding, and so all between them: 1 for
    /// normals.
    pub longest: f64,
    /// How far they are apart at most.
    pub apart: f64,
    /// Steps of the longest span.
    pub steps: u32,
}

/// Interpolates linearly: N' = N0 + a (N1 - N0), where a grows by 1/S with each of at most
/// `steps` + 1 pixels. [Lyon, TR 43; methods B12]
pub fn interpolate(b: &Builder, span: SpanNormals, to: Interpolation) -> Vector {
    let inputs = (
        ("start", span.first),
        ("normal_start", span.start),
        ("normal_delta", span.delta),
        ("weight_step", span.weight_step),
    );
    b.unit(
        "interpolate",
        "N' = N0 + a (N1 - N0) [Lyon, TR 43]",
        inputs,
        |b, (first, start, delta, step)| {
            let a = weight_along(b, &first, &step, to);
            between(&start, &delta, &a, to, "|N'| <= 1").named("normal")
        },
    )
}

/// The weight a = i/S by itself, for several vectors. [Lyon, TR 43; methods B12]
pub fn weight(b: &Builder, first: &Sig, step: &Sig, to: Interpolation) -> Sig {
    b.unit(
        "span_weight",
        "a(i) = i/S [Lyon, TR 43]",
        (("start", first), ("weight_step", step)),
        |b, (first, step)| weight_along(b, &first, &step, to),
    )
}

/// A vector along the span, X' = X0 + a (X1 - X0), whose ends lie in the unit ball. [methods B12,
/// C15]
pub fn along(b: &Builder, start: &Vector, delta: &Vector, a: &Sig, to: Interpolation) -> Vector {
    let inputs = (("vector_start", start), ("vector_delta", delta), ("weight", a));
    b.unit("along", "X' = X0 + a (X1 - X0) [methods B12, C15]", inputs, |_, (start, delta, a)| {
        between(&start, &delta, &a, to, "|X'| <= 1").named("vector")
    })
}

fn weight_along(b: &Builder, first: &Sig, step: &Sig, to: Interpolation) -> Sig {
    let most = 1.0 + slack(to.accumulator, to.steps);
    let a = Sig::accumulated(first, &b.integer(0), step, (0.0, most), to.steps, "0 <= a <= 1");
    a.rounded(to.weight.fraction_bits)
        .assumed(0.0, 1.0 + overshoot(to.accumulator, to.weight, to.steps), "0 <= a <= 1")
        .named("weight")
}

/// X0 and X1 lie in the unit ball but for rounding, √3/2 units of the last place. With a ≤ 1 + o,
/// where o is [`overshoot`], X' is longer than the longer of them by the factor 1 + 2o at most, and
/// each of its components lies within 1 + 2o; longer ends alike.
///
/// # Error
/// The host sends X1 - X0 of rounded ends, so with ends off by e and a' for what a comes out as X'
/// is off by |1 - a'| e + a' e, and by
/// |X1 - X0| times what a' is off.
fn between(start: &Vector, delta: &Vector, a: &Sig, to: Interpolation, fact: &str) -> Vector {
    let reach = 1.0 + 2.0 * overshoot(to.accumulator, to.weight, to.steps);
    let off = start.off().length * reach
        + a.error_value() * to.apart.min(delta.longest() + 2.0 * delta.off().length);
    // Both ends are rounded, so their difference is off by a whole unit, not by half as what is
    // rounded once.
    let delta = delta.map(|component| component.clone().stated_error_value(component.ulp()));
    let vector = (start + &delta.scaled(a)).no_longer_than((to.longest + to.vector.ulp()) * reach);
    let vector = vector.components_assumed_within(to.longest * reach, fact);
    vector.proven_off_by(off).rounded(to.vector.fraction_bits)
}

/// How far the ends are apart of a span in the unit ball that comes no nearer to its centre than
/// `shortest`: a chord.
pub fn chord(shortest: f64) -> f64 {
    2.0 * (1.0 - shortest * shortest).max(0.0).sqrt()
}

/// By how much a weight that is accumulated from 0 on is off after `steps` steps of 1/S, each
/// rounded to half a unit of the last place.
///
/// The host works out 1/S in f64, off by 2^-53 of itself, and so by 2^-53 after S steps. Where the
/// accumulator is no finer than an f64 near 1, that is half a unit at most and never reaches its
/// next number.
fn accumulated_off(accumulator: Format, steps: u32) -> f64 {
    let of_host =
        if accumulator.fraction_bits >= f64::MANTISSA_DIGITS { f64::EPSILON / 2.0 } else { 0.0 };
    0.5 * f64::from(steps) * accumulator.ulp() + of_host
}

/// How far past 1 the accumulated weight is allowed to come: a unit for each step, or more where
/// the host is off by more.
pub(super) fn slack(accumulator: Format, steps: u32) -> f64 {
    (f64::from(steps) * accumulator.ulp()).max(accumulated_off(accumulator, steps))
}

/// How far past 1 the weight can come out.
///
/// By default the accumulator's extra bits keep what it is off by below half a unit of a's, so that
/// a ≤ 1 after rounding; a spec may ask for fewer.
pub(super) fn overshoot(accumulator: Format, weight: Format, steps: u32) -> f64 {
    let accumulated = accumulated_off(accumulator, steps);
    let half = 0.5 * weight.ulp();
    if accumulated < half { 0.0 } else { accumulated + half }
}

//! The normal along a span.
use specula_scene::Format;
use specula_scene::spec::lyon::LyonFormats;

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

/// Interpolates linearly: N' = N0 + a (N1 - N0), where a grows by 1/S with each of at most `steps` + 1 pixels.
/// [Lyon, TR 43; METHODS B12]
///
/// N0 and N1 are unit vectors but for rounding, √3/2 units of the last place. With a ≤ 1 + o, where o is [`overshoot`], N' is longer
/// than the longer of them by the factor 1 + 2o at most, and each of its components lies within 1 + 2o.
pub fn interpolate(b: &Builder, span: SpanNormals, formats: &LyonFormats, steps: u32) -> Vector {
    let inputs =
        (("start", span.first), ("normal_start", span.start), ("normal_delta", span.delta), ("weight_step", span.weight_step));
    b.unit("interpolate", "N' = N0 + a (N1 - N0) [Lyon, TR 43]", inputs, |b, (first, start, delta, step)| {
        let slack = f64::from(steps) * formats.weight_accumulator.ulp();
        let a = Sig::accumulated(&first, &b.integer(0), &step, (0.0, 1.0 + slack), steps, "0 <= a <= 1");
        let overshoot = overshoot(formats.weight_accumulator, formats.weight, steps);
        let a = a.rounded(formats.weight.fraction_bits).assumed(0.0, 1.0 + overshoot, "0 <= a <= 1").named("weight");
        let normal = (&start + &delta.scaled(&a)).no_longer_than((1.0 + formats.vector.ulp()) * (1.0 + 2.0 * overshoot));
        let normal = normal.components_assumed_within(1.0 + 2.0 * overshoot, "|N'| <= 1");
        normal.rounded(formats.vector.fraction_bits).named("normal")
    })
}

/// How far past 1 the weight can come out.
///
/// The accumulator is off by S/2 units of its last place at most. By default its extra bits keep that below half a unit of a's, so
/// that a ≤ 1 after rounding; a spec may ask for fewer.
pub(super) fn overshoot(accumulator: Format, weight: Format, steps: u32) -> f64 {
    let accumulated = 0.5 * f64::from(steps) * accumulator.ulp();
    let half = 0.5 * weight.ulp();
    if accumulated < half { 0.0 } else { accumulated + half }
}

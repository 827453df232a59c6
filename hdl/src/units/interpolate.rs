//! The normal along a span.
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
/// The accumulator is off by S/2 units of its last place at most, which its extra bits keep below half a unit of a's, so a ≤ 1
/// after rounding. N' is then a convex combination of N0 and N1, so each component lies within [-1, 1].
pub fn interpolate(b: &Builder, span: SpanNormals, formats: &LyonFormats, steps: u32) -> Vector {
    let inputs =
        (("start", span.first), ("normal_start", span.start), ("normal_delta", span.delta), ("weight_step", span.weight_step));
    b.unit("interpolate", "N' = N0 + a (N1 - N0) [Lyon, TR 43]", inputs, |b, (first, start, delta, step)| {
        let slack = f64::from(steps) * (-f64::from(formats.weight_accumulator.fraction_bits)).exp2();
        let a = Sig::accumulated(&first, &b.integer(0), &step, (0.0, 1.0 + slack), steps, "0 <= a <= 1");
        let a = a.rounded(formats.weight.fraction_bits).assumed(0.0, 1.0, "0 <= a <= 1").named("weight");
        let normal = &start + &delta.scaled(&a);
        normal.assumed_within(1.0, "|N'| <= 1").rounded(formats.vector.fraction_bits).named("normal")
    })
}

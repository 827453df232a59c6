//! Scenes of several rows.
use crate::stress::draw::Draw;
use crate::stress::row::{Case, Pixel, TrialExtent, all};
use crate::stress::scene::{RawSpan, SpanScene};

/// The case that all spans of a scene have the same code from end to end.
pub(super) fn flat_from_end_to_end(scene: SpanScene) -> Case {
    Case::new(scene).requiring("one code from end to end, bit for bit", all, |pixel| {
        pixel.code() == Pixel { i: 0, ..*pixel }.code()
    })
}

/// Random spans of a row: angles between their ends from the range `degrees`, half of the time at
/// one of its ends, and every length and exponent.
pub(super) fn spans(
    draw: &mut Draw,
    extent: TrialExtent,
    degrees: [f64; 2],
    material: fn(u32) -> specula_scene::Material,
) -> Vec<RawSpan> {
    let one = |draw: &mut Draw| {
        let either = draw.one_of(&degrees);
        let between = draw.within(degrees[0], degrees[1]);
        let angle = draw.one_of(&[either, between]);
        RawSpan::between(
            draw.ends(angle, 80.0),
            draw.length(extent.longest),
            material(draw.even_shininess()),
        )
    };
    (0..extent.spans).map(|_| one(draw)).collect()
}

/// Random spans under two lights: one makes a highlight on the first span, the other on the last
/// span.
pub(super) fn aimed(draw: &mut Draw, spans: Vec<RawSpan>) -> SpanScene {
    let light = |draw: &mut Draw, span: &RawSpan| {
        draw.aimed([span.normals[0], span.normals[1]], span.material.shininess)
    };
    let lights: Vec<glam::DVec3> =
        spans.first().into_iter().chain(spans.last()).map(|span| light(draw, span)).collect();
    SpanScene::new(&lights, spans)
}

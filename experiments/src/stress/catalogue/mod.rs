//! The rows of docs/extremes.md, a file for each subject.
mod anything;
mod bases;
mod breaks;
mod consistent;
mod degenerate;
mod exponents;
mod lengths;
mod lyon;
mod newton;
mod opposite;
mod places;
mod ranges;
mod slerp;
mod viewpoints;
mod wrapped;

use super::draw::Draw;
use super::row::{Case, CatalogueRow, Pixel, Trial, TrialExtent, all, scenes};
use super::scene::{RawSpan, SpanScene, lit, material, matt, mirror};
use super::variant::Variant;

/// Every row, in the order of docs/extremes.md; then what breaks first according to
/// docs/numerics.md, and random spans.
pub static CATALOGUE: [&CatalogueRow; 62] = [
    &opposite::LERP,
    &opposite::DUFF,
    &opposite::WIDE,
    &opposite::HYBRID,
    &bases::NEGATIVE,
    &bases::ABOVE_ONE,
    &wrapped::OPPOSITE,
    &wrapped::BEHIND,
    &wrapped::NEARLY_OPPOSITE,
    &wrapped::ITSELF,
    &wrapped::CHAINED,
    &wrapped::FOLLOWING,
    &viewpoints::OPPOSITE_LIGHT,
    &slerp::NO_ANGLE,
    &slerp::HALF_A_TURN,
    &slerp::SMALL_ANGLE,
    &slerp::FROZEN,
    &slerp::ORIENTATION,
    &newton::FIRST_PIXEL,
    &newton::ALMOST_OPPOSITE,
    &newton::NEW_SPAN,
    &lyon::END_OF_THE_SHAPE,
    &lyon::CENTRE,
    &lyon::TAILS,
    &lyon::LARGEST_EXPONENT,
    &lyon::OPPOSITE_REFLECTION,
    &ranges::LONGER_THAN_ONE,
    &lyon::LARGEST_GAIN,
    &lyon::OVERSHOOT,
    &ranges::ALONG_AXES,
    &lyon::ROOT_OF_N,
    &lyon::ONE_AXIS,
    &viewpoints::LIGHT_BEHIND,
    &viewpoints::EYE_BEHIND,
    &viewpoints::GRAZING,
    &viewpoints::NEARLY_OPPOSITE_LIGHT,
    &slerp::ARC_COSINE,
    &lengths::SHORTEST,
    &lengths::LONGEST,
    &places::IN_THE_SURFACE,
    &places::FAR,
    &consistent::HORIZON,
    &consistent::QUARTER_TURN,
    &consistent::ABOVE,
    &consistent::FLAT,
    &consistent::BEYOND_A_QUARTER,
    &consistent::FROM_BEHIND,
    &consistent::TRIGONOMETRIC,
    &consistent::WIDE_CONES,
    &consistent::VANISHING,
    &degenerate::TRIANGLES,
    &degenerate::FAR_AWAY,
    &lengths::FLAT,
    &bases::CENTRE,
    &exponents::EVERY,
    &ranges::BRIGHT,
    &breaks::SECOND_DIFFERENCES,
    &breaks::REFLECTION_FORM,
    &breaks::SHORT_DIFFERENCE,
    &breaks::SHORT_ACCUMULATOR,
    &breaks::WRAPPED_HIGHLIGHT,
    &anything::ANYTHING,
];

/// The case that all spans of a scene have the same code from end to end.
fn flat_from_end_to_end(scene: SpanScene) -> Case {
    Case::new(scene).requiring("one code from end to end, bit for bit", all, |pixel| {
        pixel.code() == Pixel { i: 0, ..*pixel }.code()
    })
}

/// Random spans of a row: angles between their ends from the range `degrees`, half of the time at
/// one of its ends, and every length and exponent.
fn spans(
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
fn aimed(draw: &mut Draw, spans: Vec<RawSpan>) -> SpanScene {
    let light = |draw: &mut Draw, span: &RawSpan| {
        draw.aimed([span.normals[0], span.normals[1]], span.material.shininess)
    };
    let lights: Vec<glam::DVec3> =
        spans.first().into_iter().chain(spans.last()).map(|span| light(draw, span)).collect();
    SpanScene::new(&lights, spans)
}

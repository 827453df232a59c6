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
mod scenes;
mod slerp;
mod viewpoints;
mod wrapped;

use super::row::CatalogueRow;

/// Every row, in the order of docs/extremes.md; then what breaks first according to
/// docs/numerics.md, random spans, and what was added since.
pub static CATALOGUE: [&CatalogueRow; 63] = [
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
    &places::WEAKER,
];

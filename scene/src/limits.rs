//! How much a scene may have, and so the most that a core is built for.

/// The most lights of a scene, those at places included.
pub const MOST_LIGHTS: usize = 8;
/// The largest exponent n, of a material or a spot (extremes row 24).
pub const LARGEST_SHININESS: u32 = 8191;
/// The longest span, in pixels (extremes row 38).
pub const LONGEST_SPAN: u32 = 8192;

//! Units: short functions from signals to signals that read like the papers' formulas.
mod colour;
mod difference;
mod diffuse;
mod direct;
mod divider;
mod interpolate;
mod normalise;
mod normalise_exactly;
mod power;
mod quadratic;
mod reciprocal_square_root;
mod rotation;
mod shape;
mod square_root;
mod turned;

pub use colour::{Coefficients, Light, channels};
pub use difference::{halfway_cross_normal, reflection_minus_light};
pub use diffuse::{diffuse, gouraud};
pub use direct::{cosine, directed_base, parameter, squared_length};
pub use divider::{QuotientFormat, divider, quotient, signed_quotient};
pub use interpolate::{SpanNormals, interpolate};
pub use normalise::normalise;
pub use normalise_exactly::{ExactNormalisation, normalise_exactly};
pub use power::power;
pub use quadratic::{Differences, quadratic};
pub use reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
pub use rotation::rotation;
pub use shape::shape;
pub use square_root::square_root;
pub use turned::{BaseBound, along_arc, base, corrected, kept_within_one};

/// What the host's f64 arithmetic adds to the error of an accumulated value at most, which shows in formats finer than f64: sums of a few
/// products no larger than 4, each off by 2^-53 of itself. Steps are as small as the span is long, so they add up to no more.
const HOST_ERROR: f64 = 1.0 / (1u64 << 48) as f64;

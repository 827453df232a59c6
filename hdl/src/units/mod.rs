//! Units: short functions from signals to signals that read like the papers' formulas.
mod clamp;
mod colour;
mod consistent_reflection;
mod contraction;
mod cosine;
mod difference;
mod diffuse;
mod direct;
mod divider;
mod followed;
mod gaussian;
mod interpolate;
mod linear;
mod newton_root;
mod normalise;
mod normalise_exactly;
mod power;
mod quadratic;
mod reciprocal_square_root;
mod reflected;
mod rotation;
mod shape;
mod square_root;
mod turned;
mod turned_normal;
mod unit_vectors;
mod vector;
mod wrapped;

pub use crate::error::length_error::LengthError;
pub use clamp::{clamp_nonnegative, clamp_share, clamp_unit};
pub use colour::{Coefficients, Light, channels};
pub use consistent_reflection::{ConsistentCosine, consistent_cosine, consistent_reflection};
pub use contraction::{SpanAngles, contraction};
pub use cosine::{
    Base, Length, cosine, cosine_by_reciprocal, positive_cosine, reflected_base,
    reflected_numerator, root,
};
pub use difference::{
    halfway_cross_normal, halfway_minus_normal, halfway_projection, light_reflection,
    reflection_minus_light,
};
pub use diffuse::{clamped_cosine, diffuse, gouraud};
pub use direct::{
    DirectedBase, KnownProduct, cosine_of_scalar, direct_cosine, direct_scalar, directed_base,
    over_square, parameter, squared_length,
};
pub use divider::{QuotientFormat, divider, quotient, signed_quotient};
pub use followed::{Follow, followed};
pub use gaussian::{gaussian, kept_versine};
pub use interpolate::{Interpolation, SpanNormals, interpolate, vector_between, weight};
pub use linear::{Steps, linear};
pub use newton_root::newton_root;
pub use normalise::normalise;
pub use normalise_exactly::{ExactNormalisation, normalise_exactly};
pub use power::{any_power, any_power_up_to, power, raised};
pub use quadratic::{Differences, quadratic};
pub use reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
pub use rotation::{Turn, rotation, scaled_rotation};
pub use shape::{root_shape, shape};
pub use square_root::square_root;
pub use turned::{along_arc, corrected, product_with_way, specular_base, way_along_arc};
pub use turned_normal::turned_normal;
pub use unit_vectors::{
    HalfwayGain, SHORTEST_HALFWAY, cosine_between, halfway_cosine, halfway_gain, halfway_versine,
    reflected_cosine, spot_cosine, trowbridge_reitz,
};
pub use vector::{gated, half_sum, has_direction};
pub use wrapped::{ToPlace, WrapFormats, WrappedPlace, wrapped, wrapped_place};

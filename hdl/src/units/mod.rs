//! Units: short functions from signals to signals that read like the papers' formulas.
mod colour;
mod difference;
mod diffuse;
mod divider;
mod interpolate;
mod normalise;
mod power;
mod quadratic;
mod shape;

pub use colour::{Coefficients, Light, channels};
pub use difference::{halfway_cross_normal, reflection_minus_light};
pub use diffuse::{diffuse, gouraud};
pub use divider::divider;
pub use interpolate::{SpanNormals, interpolate};
pub use normalise::normalise;
pub use power::power;
pub use quadratic::{Differences, quadratic};
pub use shape::shape;

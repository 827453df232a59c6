//! The papers' inner loops, one pixel after another, as they print them.
//!
//! A [`Scheme`] is set up for a span and a light in f64, as a host sets up hardware, and then gives
//! pixel by pixel what its formula gives, in any [`Number`]. [`software`](crate::software) runs
//! them in f32, tests in f64, and [`operations`](crate::operations) checks the papers' tables with
//! [`Counted`] ones.
mod consistent;
mod counted;
mod differences;
mod distributions;
mod duff;
mod edge;
mod gouraud;
mod line;
mod lyon;
mod number;
mod operations;
mod phong;
mod place;
mod reflection;
mod slerp;

use glam::DVec3;

pub use consistent::{Consistent, ConsistentNormal, Rational, Trigonometric};
pub use counted::{Counted, count};
pub use differences::{Linear, Second, Vector, Walk, dot, vector};
pub use distributions::{Blinn, TorranceSparrow, TrowbridgeReitz};
pub use duff::{Direct, Duff, DuffBlinn, DuffHybrid, DuffQuotient, DuffRoot, Hybrid};
pub use edge::{Edge, Plane, Way};
pub use gouraud::{Gouraud, Uniform, intensities};
pub use line::Line;
pub use lyon::{
    Half, HalfG2, LyonCross, LyonLightReflection, LyonNormal, LyonProjection, LyonReflection, Sum,
    Unit,
};
pub use number::{Number, power};
pub use operations::Operations;
pub use phong::{FastPhong, Phong};
pub use place::{Normalised, Place, Seen, Wrapped};
pub use reflection::{Chained, Reflection, ReflectionBlinn, ReflectionHybrid, ReflectionRoot};
pub use slerp::{Chebyshev, Frame, Slerp};

/// What a scheme gives for a pixel, neither clamped nor raised to a power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<T> {
    /// I_d.
    pub diffuse: T,
    /// I_s before its power.
    pub base: T,
}

/// One light along one span.
pub trait Scheme<T: Number>: Copy {
    /// The set-up, L a unit vector.
    fn new(line: &Line, light: DVec3) -> Self;

    /// This pixel; then to the next.
    fn pixel(&mut self) -> Pair<T>;

    /// The power that the base takes; Phong's own unless the base is another cosine.
    fn exponent(shininess: u32) -> u32 {
        shininess
    }
}

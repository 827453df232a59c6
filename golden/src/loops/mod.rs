//! The papers' inner loops, one pixel after another, as they are printed.
//!
//! A [`Scheme`] is set up for a span and a light in f64, as a host sets up hardware, and then
//! computes its formula pixel by pixel, in any [`Number`]. [`software`] runs schemes in f32, tests
//! run them in f64, and [`operations`] compares the papers' tables with [`Counted`] numbers.
mod consistent;
mod counted;
mod differences;
mod distributions;
mod duff;
mod edge;
mod edge_arcs;
mod exponential;
mod gouraud;
mod line;
mod lyon;
mod number;
mod operation_counts;
pub mod operations;
mod phong;
mod place;
mod reflection;
mod slerp;
pub mod software;

use glam::DVec3;

pub use consistent::{Consistent, ConsistentNormal, Rational, Trigonometric};
pub use counted::{Counted, count};
pub use differences::{Linear, Second, Vector, Walk, dot, vector};
pub use distributions::{Blinn, TorranceSparrow, TrowbridgeReitz};
pub use duff::{Direct, Duff, DuffBlinn, DuffHybrid, DuffQuotient, DuffRoot, Hybrid};
pub use edge::{Edge, EdgeStep, Plane};
pub use edge_arcs::EdgeArcs;
pub use exponential::Exponential;
pub use gouraud::{Gouraud, Uniform, intensities};
pub use line::Line;
pub use lyon::{
    Half, HalfG2, LyonCross, LyonLightReflection, LyonNormal, LyonProjection, LyonReflection, Sum,
    Unit,
};
pub use number::{Number, power};
pub use operation_counts::Operations;
pub use phong::{FastPhong, Phong};
pub use place::{Normalised, PlaceDirection, SeenPlace, Wrapped};
pub use reflection::{Chained, Reflection, ReflectionBlinn, ReflectionHybrid, ReflectionRoot};
pub use slerp::{Chebyshev, FrameSlerp, Slerp};

/// A scheme's result for a pixel, neither clamped nor raised to a power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<T> {
    /// I_d.
    pub diffuse: T,
    /// I_s before its power.
    pub base: T,
}

/// The recurrence of one light along one span.
pub trait Scheme<T: Number>: Copy {
    /// Sets the recurrence up; L is a unit vector.
    fn new(line: &Line, light: DVec3) -> Self;

    /// The values at this pixel; then advances to the next.
    fn pixel(&mut self) -> Pair<T>;

    /// The exponent of the base: Phong's own, unless the base is another cosine.
    fn exponent(shininess: u32) -> u32 {
        shininess
    }
}

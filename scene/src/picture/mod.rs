//! From objects in the world to the visible spans of a [`crate::Frame`].
pub mod camera;
pub mod coverage;
pub mod limits;
mod normal_cones;
pub mod project;
mod rows;
mod visibility;

pub use project::{ConedFace, Light, LightSource, LightSpace, Object, Scene, coned_faces};
pub use rows::{SpanRow, SpanRows};

//! From objects in the world to the visible spans of a [`crate::Frame`].
pub mod camera;
mod clip;
pub mod coverage;
mod error;
mod faces;
pub mod limits;
pub mod normal_cones;
pub mod pinhole;
pub mod project;
mod rows;
mod scene;
mod view;
mod view_transform;
mod viewed;
mod visibility;

pub use faces::{ConedFace, coned_faces};
pub use rows::{SpanRow, SpanRows};
pub use scene::{Light, LightSource, LightSpace, Object, Scene};

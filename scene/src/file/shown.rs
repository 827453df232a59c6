//! What a scene shows.
use crate::picture::{Scene, SpanRows};

/// The contents of a scene.
pub enum Shown {
    /// Objects, seen by a camera.
    Objects(Scene),
    /// Spans that the file gives directly.
    Rows(SpanRows),
}

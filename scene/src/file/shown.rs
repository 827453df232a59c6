//! What a scene shows.
use crate::picture::{Scene, SpanRows};
use crate::sequence::Script;

/// The contents of a scene.
pub enum Shown {
    /// Objects, seen by a camera.
    Objects(Scene),
    /// Objects that move, or are seen by a camera or under lights that do.
    Moving {
        /// The scene as it is written.
        scene: Scene,
        /// The number of frames.
        frames: u32,
        /// What moves it.
        script: Script,
    },
    /// Spans that the file gives directly.
    Rows(SpanRows),
}

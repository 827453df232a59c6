//! What a scene shows.
use crate::picture::{Rows, Scene};

/// What a scene shows.
pub enum Shown {
    /// Objects, seen by a camera.
    Objects(Scene),
    /// Spans as they are given.
    Rows(Rows),
}

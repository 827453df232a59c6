//! What a scene shows.
use super::sequence::SequenceTable;
use crate::picture::{Scene, SpanRows};

/// The contents of a scene.
pub enum Shown {
    /// Objects, seen by a camera.
    Objects(Scene),
    /// Objects that move, or are seen by a camera or under lights that do.
    Moving(Scene, SequenceTable),
    /// Spans that the file gives directly.
    Rows(SpanRows),
}

impl Shown {
    /// The scene of objects that stand still; `None` if there is none.
    pub fn into_still(self) -> Option<Scene> {
        match self {
            Shown::Objects(scene) => Some(scene),
            Shown::Moving(..) | Shown::Rows(_) => None,
        }
    }
}

//! Reasons why a scene cannot be drawn, and what would be right.
use thiserror::Error;

use super::limits;

/// The reason why a scene cannot be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum PictureError {
    /// The picture would be too large, or without pixels.
    #[error("a picture of {0} x {1} pixels cannot be made")]
    Size(u32, u32),
    /// A size was requested for a scene of spans.
    #[error("spans say themselves how large the picture is")]
    OwnSize,
    /// The camera's `up` points to the eye or away from it, or one of the two is 0.
    #[error("the camera does not know what is up")]
    Up,
    /// All objects are at one point as the camera sees them.
    #[error("the objects have no extent as the camera sees them, so it cannot choose a height")]
    NoExtent,
    /// All objects are at one point, or on the line of sight to the target.
    #[error("the objects have no extent as the camera sees them, so it cannot choose a distance")]
    NoDistance,
    /// Part of an object is too far outside the picture for exact arithmetic.
    #[error("an object reaches more than 2 million pixels beyond the picture")]
    TooClose,
    /// No pixel's centre is covered.
    #[error("nothing of the scene is visible")]
    NothingVisible,
    /// The same of a perspective camera, before whose eye there is something.
    #[error("nothing of the scene is in the picture")]
    OutOfSight,
    /// Nothing is before the eye of a perspective camera, farther away than its near plane.
    #[error("all objects are behind the eye, or nearer to it than the near plane")]
    BehindEye,
}

impl PictureError {
    /// What would be right.
    pub fn help(&self) -> String {
        match self {
            PictureError::Size(..) => limits::described(),
            PictureError::OwnSize => "leave the size out".into(),
            PictureError::Up => "give the camera an `up` that does not point along the direction to the eye".into(),
            PictureError::NoExtent => "give the camera a `height`, or turn it so that it does not see the objects edge on".into(),
            PictureError::NoDistance => "give the camera an `eye` and a `target`, or turn it so that it sees the objects from a side".into(),
            PictureError::TooClose => "give the camera a larger `height`, or split the object".into(),
            PictureError::NothingVisible => {
                "aim the camera's `target` at the objects, raise its `height`, or leave both out to have the objects framed".into()
            }
            PictureError::OutOfSight => {
                "aim the camera's `target` at the objects, raise its `field_of_view`, or give a `direction` in place of `eye` to have the objects framed".into()
            }
            PictureError::BehindEye => {
                "the camera looks from `eye` to `target`: exchange them, move `eye` away from the objects, or lower `near`".into()
            }
        }
    }
}

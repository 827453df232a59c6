//! Sequences: scenes over frames, which one core is to shade.
mod keys;
mod motion;
mod movement;
mod moving;
mod nodes;

use rayon::prelude::*;

use crate::{Frame, Needs, SceneError, Surface};

pub use keys::{Keys, Steps};
pub use motion::{Change, Motion, Subject};
pub use movement::Movement;
pub use moving::{MovingScene, Script};
pub use nodes::{
    Between, Blend, FRAMES_A_SECOND, NodeMotions, Pose, Track, Tracks, Transform, TreeNode,
};

/// The most frames of a sequence.
pub const MOST_FRAMES: u32 = 10000;

/// Frames that one core is to shade, one after the other. Each is made when it is asked for, so that
/// memory does not grow with their number.
#[derive(Clone, Debug)]
pub struct Sequence {
    name: String,
    scene: MovingScene,
}

/// A frame of a sequence.
#[derive(Clone, Debug)]
pub struct SequenceFrame {
    /// Its visible spans.
    pub frame: Frame,
    /// The curved surfaces that its objects represent, as [`crate::LoadedScene::surfaces`].
    pub surfaces: Vec<Option<Surface>>,
}

impl Sequence {
    /// A scene that moves; `name` is the scene's in errors.
    pub fn new(name: &str, scene: MovingScene) -> Sequence {
        Sequence { name: name.to_owned(), scene }
    }

    /// The number of frames, at least one.
    pub fn frames(&self) -> u32 {
        self.scene.frames()
    }

    /// Frame number `index`, counted from 0.
    ///
    /// # Errors
    /// [`SceneError::Picture`] if that frame cannot be drawn, or nothing is visible in it.
    pub fn frame(&self, index: u32) -> Result<SequenceFrame, SceneError> {
        let scene = self.scene.scene(index);
        let frame = scene.frame().map_err(|error| {
            SceneError::picture(&format!("{}, frame {index}", self.name), error)
        })?;
        Ok(SequenceFrame { frame, surfaces: scene.surfaces() })
    }

    /// What `of` gives for every frame, in their order; frames are made side by side.
    ///
    /// # Errors
    /// The first error of `of`, or of a frame.
    pub fn map<T: Send, E: From<SceneError> + Send>(
        &self,
        of: impl Fn(u32, SequenceFrame) -> Result<T, E> + Sync,
    ) -> Result<Vec<T>, E> {
        (0..self.frames()).into_par_iter().map(|index| of(index, self.frame(index)?)).collect()
    }

    /// The needs of all frames together.
    ///
    /// # Errors
    /// As [`Sequence::frame`].
    pub fn needs(&self) -> Result<Needs, SceneError> {
        let all: Vec<Needs> = self.map(|_, frame| Ok::<_, SceneError>(Needs::of(&frame.frame)))?;
        Ok(all.into_iter().reduce(Needs::and).expect("a sequence has at least one frame"))
    }
}

#[cfg(test)]
mod tests;

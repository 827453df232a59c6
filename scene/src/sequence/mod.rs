//! Sequences: scenes over frames, which one core is to shade.
mod files;
mod findings;
mod framing;
mod keys;
mod motion;
mod movement;
mod moving;
mod nodes;
mod side_by_side;

use std::sync::{Arc, OnceLock};

use glam::DVec3;

use crate::picture::Scene;
use crate::picture::project::PictureError;
use crate::{Frame, Needs, SceneError, Surface};

pub(crate) use files::Besides;
pub use files::FrameFiles;
pub use findings::Findings;
use framing::Framing;
pub use keys::{Keys, Steps};
pub use motion::{Change, Motion, Subject};
pub use movement::Movement;
pub use moving::{MovingScene, Script};
pub use nodes::{
    Between, Blend, FRAMES_A_SECOND, NodeMotions, Pose, Track, Tracks, Transform, TreeNode,
};
use side_by_side::side_by_side;

/// The most frames of a sequence.
pub const MOST_FRAMES: u32 = 10000;

/// Triangles of frames that are made at once, about 500 bytes each, unless they are of two frames.
const MOST_TRIANGLES_AT_ONCE: usize = 4_000_000;

/// Frames that one core is to shade, one after the other. Each is made when it is asked for, so that
/// memory does not grow with their number.
#[derive(Clone, Debug)]
pub struct Sequence {
    name: String,
    source: FrameSource,
    /// What its cameras show, where they choose that by themselves.
    framing: Option<Framing>,
    /// The needs of all frames together, once they are known.
    needs: Arc<OnceLock<Needs>>,
    /// What else has been found out about it.
    findings: Arc<Findings>,
}

/// Where frames come from.
#[derive(Clone, Debug)]
pub enum FrameSource {
    /// A scene that moves.
    Moving(Box<MovingScene>),
    /// Files in a folder.
    Files(FrameFiles),
}

impl Sequence {
    /// A sequence of these frames; `name` is the scene's in errors.
    ///
    /// A camera that chooses its target or height by itself does so once: all frames are within the
    /// picture, and none is drawn larger than another.
    ///
    /// # Errors
    /// [`SceneError`] if a camera is invalid, or objects have no extent.
    pub fn new(name: &str, source: FrameSource) -> Result<Sequence, SceneError> {
        let (name, needs, findings) = (name.to_owned(), Arc::default(), Arc::default());
        let sequence = Sequence { name, source, framing: None, needs, findings };
        let is_needed = Framing::is_needed(&sequence.scene(0)?.camera);
        let framing = is_needed.then(|| sequence.framed()).transpose()?;
        Ok(Sequence { framing, ..sequence })
    }

    /// The number of frames, at least one.
    pub fn frames(&self) -> u32 {
        match &self.source {
            FrameSource::Moving(scene) => scene.frames(),
            FrameSource::Files(files) => files.frames(),
        }
    }

    /// What shows all frames.
    fn framed(&self) -> Result<Framing, SceneError> {
        let wrong = |index: u32| move |error| self.error(index, error);
        let extent = |index: u32| self.scene(index)?.extent().map_err(wrong(index));
        let all: Vec<u32> = (0..self.frames()).collect();
        let extents = side_by_side(&all, self.at_once(), extent).into_iter();
        let extents: Vec<[DVec3; 2]> = extents.collect::<Result<_, SceneError>>()?;
        let whole = extents.into_iter().map(Framing::around).reduce(Framing::and);
        let whole = whole.expect("a sequence has at least one frame");
        all.into_iter().try_fold(whole, |framing, index| {
            framing.enough_for(&self.scene(index)?).map_err(wrong(index))
        })
    }

    /// The scene of frame number `index`, counted from 0.
    fn scene(&self, index: u32) -> Result<Scene, SceneError> {
        let scene = match &self.source {
            FrameSource::Moving(scene) => scene.scene(index),
            FrameSource::Files(files) => files.scene(index)?,
        };
        Ok(match self.framing {
            None => scene,
            Some(framing) => Scene { camera: framing.applied(scene.camera), ..scene },
        })
    }

    fn error(&self, index: u32, error: PictureError) -> SceneError {
        SceneError::picture(&format!("{}, frame {index}", self.name), error)
    }

    /// Frame number `index`, counted from 0; it has no spans where nothing is visible.
    ///
    /// # Errors
    /// [`SceneError::Picture`] if that frame cannot be drawn.
    pub fn frame(&self, index: u32) -> Result<Frame, SceneError> {
        self.scene(index)?.frame_or_background().map_err(|error| self.error(index, error))
    }

    /// The number of the first frame in which something is visible, and that frame.
    ///
    /// # Errors
    /// [`SceneError::Picture`] if a frame up to it cannot be drawn, or nothing is ever visible: then
    /// it says why there is nothing in the first one.
    pub fn first_visible(&self) -> Result<(u32, Frame), SceneError> {
        for index in 0..self.frames() {
            let frame = self.frame(index)?;
            if !frame.spans.is_empty() {
                return Ok((index, frame));
            }
        }
        let nothing = self.scene(0)?.frame().map_err(|error| self.error(0, error))?;
        Ok((0, nothing))
    }

    /// The curved surfaces that a frame's objects represent, as [`crate::LoadedScene::surfaces`].
    ///
    /// # Errors
    /// [`SceneError`] if the frame's file cannot be read any more.
    pub fn surfaces(&self, index: u32) -> Result<Vec<Option<Surface>>, SceneError> {
        Ok(self.scene(index)?.surfaces())
    }

    /// What `of` gives for every frame, in their order; frames are made side by side.
    ///
    /// # Errors
    /// The first error of `of`, or of a frame.
    pub fn map<T: Send, E: From<SceneError> + Send>(
        &self,
        of: impl Fn(u32, Frame) -> Result<T, E> + Sync,
    ) -> Result<Vec<T>, E> {
        let all: Vec<u32> = (0..self.frames()).collect();
        self.map_some(&all, of)
    }

    /// The same for the frames of these numbers alone.
    ///
    /// # Errors
    /// As [`Sequence::map`].
    pub fn map_some<T: Send, E: From<SceneError> + Send>(
        &self,
        numbers: &[u32],
        of: impl Fn(u32, Frame) -> Result<T, E> + Sync,
    ) -> Result<Vec<T>, E> {
        // All are asked before the first error is looked for, so that it is always the same one.
        let of = |index| self.frame(index).map_err(E::from).and_then(|frame| of(index, frame));
        let all: Vec<Result<T, E>> = side_by_side(numbers, self.at_once(), of);
        all.into_iter().collect()
    }

    /// The number of frames that are made at once: one for each thread, or fewer of large ones.
    fn at_once(&self) -> usize {
        let triangles = match &self.source {
            FrameSource::Moving(scene) => scene.triangles(),
            // The first is not read again for this; folders have had room for theirs.
            FrameSource::Files(_) => 0,
        };
        let few = (MOST_TRIANGLES_AT_ONCE / triangles.max(1)).max(2);
        rayon::current_num_threads().min(few)
    }

    /// Everything that decides what its frames are, as text: where two are alike, so are all frames.
    /// Meshes are in it as hashes.
    ///
    /// # Errors
    /// [`SceneError`] if a frame's file cannot be read any more.
    pub fn fingerprint(&self) -> Result<String, SceneError> {
        let source = match &self.source {
            FrameSource::Moving(scene) => format!("{scene:?}"),
            FrameSource::Files(files) => {
                let scene = |index| Ok(format!("{:?}", files.scene(index)?));
                (0..files.frames()).map(scene).collect::<Result<_, SceneError>>()?
            }
        };
        Ok(format!("{source}{:?}", self.framing))
    }

    /// What has been found out about it.
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// The needs of all frames together.
    ///
    /// # Errors
    /// As [`Sequence::frame`].
    pub fn needs(&self) -> Result<Needs, SceneError> {
        if let Some(known) = self.needs.get() {
            return Ok(known.clone());
        }
        // A frame of the background alone needs nothing.
        let needs = |frame: &Frame| (!frame.spans.is_empty()).then(|| Needs::of(frame));
        let all = self.map(|_, frame| Ok::<_, SceneError>(needs(&frame)))?;
        let needs = match all.into_iter().flatten().reduce(Needs::and) {
            Some(needs) => needs,
            None => Needs::of(&self.first_visible()?.1),
        };
        Ok(self.needs.get_or_init(|| needs).clone())
    }
}

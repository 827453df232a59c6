//! A scene whose camera, objects and lights move.
use std::sync::Arc;

use glam::DVec3;

use crate::picture::Scene;
use crate::picture::camera::{Camera, Window};
use crate::picture::project::PictureError;

use super::motion::Motion;
use super::nodes::NodeMotions;

/// A scene that moves.
#[derive(Clone, Debug)]
pub struct MovingScene {
    /// The scene as it is written: what every motion starts from.
    scene: Scene,
    frames: u32,
    script: Script,
    /// What the camera shows, where it chooses that by itself.
    framing: Option<Framing>,
}

/// What moves a scene.
#[derive(Clone, Debug)]
pub enum Script {
    /// Motions of single things; those of one thing follow each other in their order.
    Motions(Vec<Motion>),
    /// Nodes, with what is at them.
    Nodes(Arc<NodeMotions>),
}

impl From<Vec<Motion>> for Script {
    fn from(motions: Vec<Motion>) -> Script {
        Script::Motions(motions)
    }
}

impl Script {
    fn apply(&self, frame: f64, scene: &mut Scene) {
        match self {
            Script::Motions(motions) => {
                motions.iter().for_each(|motion| motion.apply(frame, scene));
            }
            Script::Nodes(nodes) => nodes.apply(frame, scene),
        }
    }
}

/// What a camera shows in all frames.
#[derive(Clone, Copy, Debug)]
struct Framing {
    /// The point at the picture's centre in view space, where the camera has no target.
    centre: Option<DVec3>,
    /// World units from the picture's bottom to its top.
    height: f64,
}

impl MovingScene {
    /// A scene over `frames` frames, at least one.
    ///
    /// A camera that chooses its target or height by itself does so once: all frames are within the
    /// picture, and no frame is drawn larger than another.
    ///
    /// # Errors
    /// [`PictureError`] if the camera is invalid in a frame, or objects have no extent.
    pub fn new(
        scene: Scene,
        frames: u32,
        script: impl Into<Script>,
    ) -> Result<MovingScene, PictureError> {
        let moving = MovingScene { scene, frames, script: script.into(), framing: None };
        let camera = &moving.scene.camera;
        if camera.target.is_some() && camera.height.is_some() {
            return Ok(moving);
        }
        Ok(MovingScene { framing: Some(moving.framing()?), ..moving })
    }

    /// The number of frames.
    pub fn frames(&self) -> u32 {
        self.frames
    }

    /// The scene at frame number `index`, counted from 0. Meshes are shared, not copied.
    pub fn scene(&self, index: u32) -> Scene {
        let mut scene = self.scene.clone();
        self.script.apply(f64::from(index), &mut scene);
        if let Some(framing) = self.framing {
            framing.apply(&mut scene.camera);
        }
        scene
    }

    /// What shows all frames: the middle of all that is seen over time, in the picture's own
    /// directions, unless a target is given, and the largest height that a frame needs.
    fn framing(&self) -> Result<Framing, PictureError> {
        let scenes = || (0..self.frames).map(|index| self.scene(index));
        let mut bounds: Option<[DVec3; 2]> = None;
        for scene in scenes() {
            let [low, high] = scene.extent()?;
            bounds = Some(bounds.map_or([low, high], |[a, b]| [a.min(low), b.max(high)]));
        }
        let bounds = bounds.ok_or(PictureError::NothingVisible)?;
        let mut height: f64 = 0.0;
        for scene in scenes() {
            let rotation = scene.camera.rotation().ok_or(PictureError::Up)?;
            let window = Window::new(&scene.camera, rotation, bounds, scene.size)
                .ok_or(PictureError::NoExtent)?;
            height = height.max(window.pixel * f64::from(scene.size.1));
        }
        let own = self.scene.camera.target.is_none();
        Ok(Framing { centre: own.then_some((bounds[0] + bounds[1]) / 2.0), height })
    }
}

impl Framing {
    fn apply(self, camera: &mut Camera) {
        camera.height = Some(self.height);
        let to_world = camera.rotation().map(|rotation| rotation.transpose());
        if let (Some(centre), Some(to_world)) = (self.centre, to_world) {
            camera.target = Some(to_world * centre);
        }
    }
}

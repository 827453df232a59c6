//! A scene whose camera, objects and lights move.
use super::motion::Motion;
use crate::picture::Scene;

/// A scene that moves.
#[derive(Clone, Debug)]
pub struct MovingScene {
    /// The scene as it is written: what every motion starts from.
    scene: Scene,
    frames: u32,
    motions: Vec<Motion>,
}

impl MovingScene {
    /// A scene over `frames` frames, at least one. Motions of one thing follow each other in their
    /// order.
    pub fn new(scene: Scene, frames: u32, motions: Vec<Motion>) -> MovingScene {
        MovingScene { scene, frames, motions }
    }

    /// The number of frames.
    pub fn frames(&self) -> u32 {
        self.frames
    }

    /// The scene at frame number `index`, counted from 0. Meshes are shared, not copied.
    pub fn scene(&self, index: u32) -> Scene {
        let mut scene = self.scene.clone();
        for motion in &self.motions {
            motion.apply(f64::from(index), &mut scene);
        }
        scene
    }
}

//! A scene whose camera, objects and lights move.
use std::sync::Arc;

use super::motion::Motion;
use super::nodes::NodeMotions;
use crate::picture::Scene;

/// A scene that moves.
#[derive(Clone, Debug)]
pub struct MovingScene {
    /// The scene as it is written: what every motion starts from.
    scene: Scene,
    frames: u32,
    script: Script,
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

impl MovingScene {
    /// A scene over `frames` frames, at least one.
    pub fn new(scene: Scene, frames: u32, script: impl Into<Script>) -> MovingScene {
        MovingScene { scene, frames, script: script.into() }
    }

    /// The number of frames.
    pub fn frames(&self) -> u32 {
        self.frames
    }

    /// The number of its objects' triangles.
    pub fn triangles(&self) -> usize {
        self.scene.objects.iter().map(|object| object.mesh.triangles.len()).sum()
    }

    /// The scene at frame number `index`, counted from 0. Meshes are shared, not copied.
    pub fn scene(&self, index: u32) -> Scene {
        let mut scene = self.scene.clone();
        self.script.apply(f64::from(index), &mut scene);
        scene
    }
}

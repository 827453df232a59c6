//! The genome that a climber changes.
use specula_scene::{Needs, parse};

use super::core::CoreChoice;
use crate::stress::scene::SpanScene;

/// A scene of spans and the core that shades it.
#[derive(Clone, Debug)]
pub struct Genome {
    /// The scene.
    pub scene: SpanScene,
    /// Its core.
    pub core: CoreChoice,
}

/// The name of scenes in errors.
pub(super) const FILE: &str = "climb.toml";

impl Genome {
    /// The text of the scene file with its `[core]` table, which `specula run` accepts.
    pub fn text(&self) -> String {
        self.scene.text(&self.core.text())
    }

    /// The genome with a core that exists; `None` if the scene is invalid or no core can be
    /// repaired to fit it.
    pub fn repaired(self) -> Option<Genome> {
        let frame = parse(FILE, self.scene.text("")).ok()?.frame;
        let core = self.core.repaired(&Needs::of(&frame))?;
        Some(Genome { core, ..self })
    }
}

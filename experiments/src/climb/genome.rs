//! What is changed on the way up.
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
    /// The scene file, complete with its `[core]` table; `specula run` takes it.
    pub fn text(&self) -> String {
        self.scene.text(&self.core.text())
    }

    /// The same with a core that there is; none where the scene is none, or no core can be brought
    /// into line with it.
    pub fn settled(self) -> Option<Genome> {
        let frame = parse(FILE, self.scene.text("")).ok()?.frame;
        let core = self.core.settled(&Needs::of(&frame))?;
        Some(Genome { core, ..self })
    }
}

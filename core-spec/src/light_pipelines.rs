//! How many lights share hardware.
use serde::{Deserialize, Serialize};

/// What shades the lights of a core.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LightPipelines {
    /// Each light has a pipeline of its own: a pixel enters with every clock.
    #[default]
    Each,
    /// All lights take turns in one pipeline: a pixel takes as many clocks as there are lights.
    Shared,
}

impl LightPipelines {
    /// Both.
    pub const ALL: [LightPipelines; 2] = [LightPipelines::Each, LightPipelines::Shared];

    /// The name that the command line and scene files use.
    pub const fn name(self) -> &'static str {
        match self {
            LightPipelines::Each => "each",
            LightPipelines::Shared => "shared",
        }
    }
}

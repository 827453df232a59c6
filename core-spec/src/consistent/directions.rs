//! Directions for whoever traces reflected rays or looks up an environment.
use serde::{Deserialize, Serialize};

use crate::shading_method::{DirectionOutput, OptionDomain};

/// What leaves the core beside a pixel's colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Directions {
    /// Nothing.
    #[default]
    None,
    /// r, the consistent reflection of the eye.
    Reflection,
    /// N_c, the consistent normal for the eye.
    Normal,
    /// Both.
    Both,
}

const REFLECTION: DirectionOutput = DirectionOutput {
    name: "reflection",
    meaning: "r, the consistent reflection of the direction to the eye",
};
const NORMAL: DirectionOutput = DirectionOutput {
    name: "consistent_normal",
    meaning: "N_c = (V + r)/|V + r|, half-way between the eye and r",
};

impl Directions {
    /// The option's key and values.
    pub const OPTION_DOMAIN: OptionDomain = OptionDomain {
        key: "directions",
        values: &["\"none\"", "\"reflection\"", "\"normal\"", "\"both\""],
    };

    /// Whether there are none.
    pub fn is_none(&self) -> bool {
        *self == Directions::None
    }

    /// Whether r leaves.
    pub const fn has_reflection(self) -> bool {
        matches!(self, Directions::Reflection | Directions::Both)
    }

    /// Whether N_c leaves.
    pub const fn has_normal(self) -> bool {
        matches!(self, Directions::Normal | Directions::Both)
    }

    /// The directions, in the order of their ports.
    pub const fn outputs(self) -> &'static [DirectionOutput] {
        match self {
            Directions::None => &[],
            Directions::Reflection => &[REFLECTION],
            Directions::Normal => &[NORMAL],
            Directions::Both => &[REFLECTION, NORMAL],
        }
    }

    /// Of the spec's options, for people to read; none without directions.
    pub(super) fn option(self) -> Option<(&'static str, String)> {
        let all: Vec<&str> = self.outputs().iter().map(|output| output.meaning).collect();
        (!self.is_none()).then(|| ("directions that leave", all.join("; ")))
    }
}

//! The papers.
use serde::Serialize;

/// A paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Paper {
    /// Lyon, TR 43.
    Lyon,
    /// Hast et al.
    Hast,
    /// The lecture on shading.
    Lecture,
    /// Reshetov, Soupikov and Mark.
    Reshetov,
}

impl Paper {
    /// Every paper.
    pub const ALL: [Paper; 4] = [Paper::Lyon, Paper::Hast, Paper::Lecture, Paper::Reshetov];

    /// The name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Paper::Lyon => "lyon",
            Paper::Hast => "hast",
            Paper::Lecture => "lecture",
            Paper::Reshetov => "reshetov",
        }
    }

    /// Its authors and title.
    pub const fn title(self) -> &'static str {
        match self {
            Paper::Lyon => {
                "R. F. Lyon, Phong Shading Reformulation for Hardware Renderer Simplification"
            }
            Paper::Hast => {
                "A. Hast, T. Barrera and E. Bengtsson, Improved Shading Performance by Avoiding Vector Normalization"
            }
            Paper::Lecture => "Lecture 21, Shading",
            Paper::Reshetov => {
                "A. Reshetov, A. Soupikov and W. R. Mark, Consistent Normal Interpolation"
            }
        }
    }
}

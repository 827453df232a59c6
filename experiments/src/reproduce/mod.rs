//! The papers' claims and figures, computed by Specula's own code: whether each claim holds, and
//! whether the number of docs/numerics.md comes out.
mod angle;
mod claim;
mod differences;
pub mod drawn;
pub mod figure;
pub mod gates;
pub mod hast;
pub mod lecture;
mod lyon;
mod maximum;
mod painted;
mod paper;
pub mod project;
pub mod reshetov;
mod span_core;
mod stepped;

use claim::Claim;
pub use claim::{ClaimVerdict, Ground, Ruling};
pub use figure::Figure;
pub use paper::Paper;

impl Paper {
    fn claims(self) -> Vec<&'static Claim> {
        match self {
            Paper::Lyon => lyon::claims(),
            Paper::Hast => hast::claims(),
            Paper::Lecture => lecture::claims(),
            Paper::Reshetov => reshetov::claims(),
        }
    }

    /// Evaluates the paper's claims.
    pub fn verdicts(self) -> Vec<ClaimVerdict> {
        self.claims().into_iter().map(|claim| claim.verdict(self)).collect()
    }

    /// The paper's figures that are curves.
    pub fn figures(self) -> Vec<Figure> {
        match self {
            Paper::Lyon => lyon::figures(),
            Paper::Hast => vec![],
            Paper::Lecture => lecture::figures(),
            Paper::Reshetov => reshetov::figures(),
        }
    }
}

//! Lyon's conclusion, that his reformulation leads to simpler hardware than standard Phong shading
//! [Lyon, TR 43]: cores of both that quantise equally well, and what decides between them.
mod claim;
mod contender;

pub use claim::{CLAIMS, Comparison, Counts, Measure, SizeClaim};
pub use contender::{CONTENDERS, Contender, EqualCore};

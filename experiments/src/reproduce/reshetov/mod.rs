//! Reshetov, Soupikov and Mark: consistent normal interpolation.
mod angles;
mod curves;
mod figures;
mod goals;
pub mod inward;
pub mod marked_pictures;
pub mod size;

use super::claim::Claim;
pub use figures::figures;

/// All claims, in the order of the paper.
pub(super) fn claims() -> Vec<&'static Claim> {
    let groups: [&'static [Claim]; 4] =
        [&curves::CLAIMS, &goals::CLAIMS, &angles::CLAIMS, &inward::CLAIMS];
    groups.into_iter().flatten().collect()
}

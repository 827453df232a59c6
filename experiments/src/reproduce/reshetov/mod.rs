//! Reshetov, Soupikov and Mark: consistent normal interpolation.
mod angles;
mod appendix;
pub mod curvature;
mod curves;
mod fans;
mod figures;
mod goals;
pub mod headlight;
pub mod inward;
pub mod marked_pictures;
pub mod size;
pub mod tracing;

use super::claim::Claim;
pub use figures::figures;

/// All claims, in the order of the paper.
pub(super) fn claims() -> Vec<&'static Claim> {
    let groups: [&'static [Claim]; 10] = [
        &curves::CLAIMS,
        &goals::CLAIMS,
        &angles::CLAIMS,
        &appendix::CLAIMS,
        &fans::CLAIMS,
        &inward::CLAIMS,
        &tracing::claims::CLAIMS,
        &tracing::tears::CLAIMS,
        &headlight::CLAIMS,
        &curvature::claims::CLAIMS,
    ];
    groups.into_iter().flatten().collect()
}

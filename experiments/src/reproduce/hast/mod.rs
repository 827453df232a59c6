//! Hast et al.: operations of their schemes, and normals by reflection.
pub mod axes;
mod edges;
mod gouraud;
pub mod operations;
mod places;
pub mod quality;
mod vectors;

use super::claim::Claim;

/// All claims, in the paper's order.
pub(super) fn claims() -> Vec<&'static Claim> {
    let groups: [&'static [Claim]; 6] = [
        &gouraud::CLAIMS,
        &operations::CLAIMS,
        &vectors::CLAIMS,
        &places::CLAIMS,
        &axes::CLAIMS,
        &edges::CLAIMS,
    ];
    groups.into_iter().flatten().collect()
}

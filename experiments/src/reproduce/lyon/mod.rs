//! Lyon, TR 43.
mod figures;
mod heights;
mod lengths;
mod normalisation;
mod shapes;
mod vertices;
mod widths;

use super::claim::Claim;

pub use figures::figures;

/// All claims, in the order of the report.
pub fn claims() -> Vec<&'static Claim> {
    let groups: [&'static [Claim]; 5] = [
        &shapes::CLAIMS,
        &vertices::CLAIMS,
        &lengths::CLAIMS,
        &normalisation::CLAIMS,
        &widths::CLAIMS,
    ];
    groups.into_iter().flatten().collect()
}

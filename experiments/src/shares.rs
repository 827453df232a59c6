//! Where a core's error bound comes from: how much of it each place that rounds answers for.
use rayon::prelude::*;
use serde::Serialize;
use specula_scene::Frame;
use specula_spec::{CoreSpec, Format, NarrowingPoint};

/// Fraction bits that make a rounding count for nothing beside the others; fewer where the format
/// may not have so many.
const ADDED: [u32; 4] = [12, 8, 4, 2];

/// A place that rounds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Share {
    /// Its name in the spec.
    pub name: &'static str,
    /// What is rounded.
    pub value: &'static str,
    /// By how much the bound would be smaller if it rounded far finer, in LSBs.
    pub lsb: f64,
}

/// The shares of a core's bound, `bound` LSBs, the largest first; of a core that is for `frame`
/// alone, those of the bound for that frame.
///
/// They do not add up to the bound: half an LSB of it is the rounding to 8 bits, and errors of
/// several places can come together in one product. A place that may not be finer has no share.
pub fn shares(spec: &CoreSpec, frame: &Frame, bound: f64) -> Vec<Share> {
    // Set up once: few places change what inputs are given.
    let special = (!spec.specialisation.is_general()).then(|| spec.specialised(frame));
    let share = |point: NarrowingPoint| {
        let finer = finer(spec, &point, |finer| match &special {
            Some(special) => finer.specialised_as(special, frame),
            None => finer,
        });
        let finer = finer.unwrap_or(bound);
        // Beside a bound that is not finite nothing can be said.
        let lsb = if bound.is_finite() { (bound - finer).max(0.0) } else { 0.0 };
        Share { name: point.name, value: point.value, lsb }
    };
    let mut shares: Vec<Share> = spec.narrowing_points().into_par_iter().map(share).collect();
    shares.sort_by(|a, b| b.lsb.total_cmp(&a.lsb));
    shares
}

/// The bound of the core with more bits at a place, known as well as the core itself is; none if it
/// may not have more.
fn finer(
    spec: &CoreSpec,
    point: &NarrowingPoint,
    known: impl Fn(CoreSpec) -> CoreSpec,
) -> Option<f64> {
    for added in ADDED {
        let format = Format { fraction_bits: point.format.fraction_bits + added, ..point.format };
        let Ok(general) = spec.with_formats(&[(point.name, format)]) else { continue };
        if let Ok(design) = specula_hdl::elaborate(&known(general), "core") {
            return Some(design.error_bound());
        }
    }
    None
}

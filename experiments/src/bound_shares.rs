//! The origin of a core's error bound: the share of it that each narrowing point contributes.
use rayon::prelude::*;
use serde::Serialize;
use specula_spec::{CoreSpec, Format, Frames, NarrowingPoint};

/// Numbers of added fraction bits with which a rounding contributes next to nothing; the smaller
/// ones are for formats that may not have so many.
const ADDED: [u32; 4] = [12, 8, 4, 2];

/// The share of a narrowing point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BoundShare {
    /// Its name in the spec.
    pub name: &'static str,
    /// The value that is rounded there.
    pub value: &'static str,
    /// By how much the bound would shrink if it rounded far more finely, in LSBs.
    pub lsb: f64,
}

/// The shares of a core's bound of `bound` LSBs, the largest first; for a core that is specialised
/// for some frames, those of the bound for these.
///
/// They do not add up to the bound: half an LSB of it is the rounding to 8 bits, and errors of
/// several narrowing points can meet in one product. A narrowing point that may not be finer has no
/// share.
pub fn bound_shares<'a>(
    spec: &CoreSpec,
    frames: impl Into<Frames<'a>>,
    bound: f64,
) -> Vec<BoundShare> {
    let frames = frames.into();
    // Spans are set up once: few narrowing points change the values of inputs.
    let special = (!spec.specialisation.is_general()).then(|| spec.specialised(frames));
    let share = |point: NarrowingPoint| {
        let finer = finer(spec, &point, |finer| match &special {
            Some(special) => finer.specialised_as(special, frames),
            None => finer,
        });
        let finer = finer.unwrap_or(bound);
        // If the bound is not finite, there are no shares.
        let lsb = if bound.is_finite() { (bound - finer).max(0.0) } else { 0.0 };
        BoundShare { name: point.name, value: point.value, lsb }
    };
    let mut shares: Vec<BoundShare> = spec.narrowing_points().into_par_iter().map(share).collect();
    shares.sort_by(|a, b| b.lsb.total_cmp(&a.lsb));
    shares
}

/// The bound of the core with more bits at a narrowing point, with the same knowledge as the core
/// itself; `None` if the point may not have more.
fn finer(
    spec: &CoreSpec,
    point: &NarrowingPoint,
    known: impl Fn(CoreSpec) -> CoreSpec,
) -> Option<f64> {
    for added in ADDED {
        let format = Format { fraction_bits: point.format.fraction_bits + added, ..point.format };
        let Ok(general) = spec.with_formats(&[(point.name, format)]) else { continue };
        if let Ok(bound) = specula_hdl::error_bound(&known(general)) {
            return Some(bound);
        }
    }
    None
}

//! The Pareto front: cores of which no other is both smaller and more exact.
use super::Explored;

/// Those that no other one beats, the smallest first. Of equals the first counts.
pub(super) fn front(mut tried: Vec<Explored>) -> Vec<Explored> {
    // The sort is stable, so equals stay in the order in which they were tried.
    tried.sort_by(|a, b| a.cost.cells().cmp(&b.cost.cells()).then(a.error.total_cmp(&b.error)));
    let mut least = f64::INFINITY;
    tried.retain(|core| {
        let better = core.error < least;
        least = least.min(core.error);
        better
    });
    tried
}

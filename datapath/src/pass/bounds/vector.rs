//! What each rule means for a vector as a whole.
use crate::bound::{Bound, VectorBound, VectorError};
use crate::graph::{Graph, RealVector, VectorId, VectorRule};

use super::Bounds;

/// What is known of a vector besides what its components say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct VectorFacts {
    shortest: f64,
    longest: f64,
    error: VectorError,
}

/// What is known of a vector whose operands' bounds are there.
pub(super) fn facts(graph: &Graph, bounds: &Bounds, of: &RealVector) -> VectorFacts {
    let known = |id: VectorId| bounds.vectors[id.0 as usize].unwrap_or(VectorFacts::UNKNOWN);
    let whole = |id: VectorId| bounds.of_vector(graph, id);
    match &of.rule {
        VectorRule::Components => VectorFacts::UNKNOWN,
        VectorRule::Same(a) => known(*a),
        VectorRule::Rounded(a) => {
            let before = bounds.components(&graph.vectors[a.0 as usize]);
            let moved = moved(before, bounds.components(of));
            VectorFacts {
                shortest: known(*a).shortest,
                longest: known(*a).longest + moved,
                error: whole(*a).error.enlarged_by(moved),
            }
        }
        VectorRule::Choice(a, b) => either(whole(*a), whole(*b)),
        VectorRule::Proven { of: a, error, .. } => VectorFacts { error: *error, ..known(*a) },
        VectorRule::NoLonger(a, length) => {
            VectorFacts { longest: known(*a).longest.min(*length), ..known(*a) }
        }
        VectorRule::NoShorter { of: a, length, .. } => {
            VectorFacts { shortest: known(*a).shortest.max(*length), ..known(*a) }
        }
    }
}

/// By how much rounding moves a vector at most: √3/2 units of the last place, where that of any
/// component is another than `before`.
fn moved(before: [Bound; 3], rounded: [Bound; 3]) -> f64 {
    let narrowed = before.iter().zip(&rounded).filter(|(before, rounded)| before.ulp < rounded.ulp);
    narrowed.map(|(_, rounded)| 0.75f64.sqrt() * rounded.ulp).fold(0.0, f64::max)
}

/// What is true of both.
fn either(a: VectorBound, b: VectorBound) -> VectorFacts {
    let (x, y) = (a.error, b.error);
    VectorFacts {
        shortest: a.shortest.min(b.shortest),
        longest: a.longest.max(b.longest),
        error: VectorError {
            length: x.length.max(y.length),
            transverse: x.transverse.max(y.transverse),
            radial: x.radial.max(y.radial),
            isotropic: x.isotropic.min(y.isotropic),
        },
    }
}

impl VectorFacts {
    pub const UNKNOWN: VectorFacts =
        VectorFacts { shortest: 0.0, longest: f64::INFINITY, error: VectorError::UNKNOWN };

    /// With what the components say: the diagonals of their ranges and of their errors.
    pub fn with_components(self, components: [Bound; 3]) -> VectorBound {
        let diagonal = |of: fn(Bound) -> f64| {
            components.map(|component| of(component).powi(2)).into_iter().sum::<f64>().sqrt()
        };
        let error = |component: Bound| component.error;
        VectorBound {
            shortest: self.shortest,
            longest: self.longest.min(diagonal(Bound::magnitude)),
            error: self.error.intersection(VectorError::ball(diagonal(error))),
            component_error: components.map(error).into_iter().fold(0.0, f64::max),
        }
    }
}

//! The core that a scene is given where nobody asks for another one.
use specula_spec::{CoreSpec, Frames};
use specula_testbench::BenchError;

use super::{FAITHFUL, NotProven, Products, Wanted, cheapest_formats};

/// Goals of cores that cannot be faithful are multiples of this, in LSBs.
const GOAL_STEP: f64 = 0.25;
/// Such a goal is so much larger than the smallest bound, which takes the finest formats there are,
/// or more.
const GOAL_SLACK: f64 = 1.1;
/// Where the bound in recommended formats is not so many times the smallest one, they stay.
const LEAST_IMPROVEMENT: f64 = 2.0;

/// A core, and what is to be told of its formats.
#[derive(Clone, Debug)]
pub struct DefaultCore {
    /// The core.
    pub spec: CoreSpec,
    /// The reason why it has other formats, where none were found for which it is faithful.
    pub not_faithful: Option<NotFaithful>,
}

/// The formats of a core that is not faithful by its bound.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}: {reason}", self.in_words())]
pub struct NotFaithful {
    /// The reason why they are not those of a faithful one.
    pub reason: NotProven,
    /// The goal, in LSBs, that the bound of the cheapest ones found is below; none where they are
    /// the recommended ones.
    pub below: Option<f64>,
}

impl NotFaithful {
    fn in_words(&self) -> String {
        match self.below {
            Some(below) => format!("the cheapest proven to be below {below} LSB"),
            None => "recommended ones".to_owned(),
        }
    }
}

/// `recommended`, a core of a frame or several in recommended formats, in the cheapest that are found for
/// which it is faithful by its bound; where there are none, in the cheapest whose bound is near the
/// smallest one, or as it is where that is little better. Formats that are `named` stay, and where all
/// are, nothing is searched.
///
/// # Errors
/// [`BenchError`] if a core cannot be built.
pub fn default_core<'a>(
    recommended: CoreSpec,
    frames: impl Into<Frames<'a>>,
    named: &[String],
    products: Products,
) -> Result<DefaultCore, BenchError> {
    let is_open = |name: &str| named.iter().all(|named| named != name);
    if !recommended.narrowing_points().iter().any(|point| is_open(point.name)) {
        return Ok(DefaultCore { spec: recommended, not_faithful: None });
    }
    let frames = frames.into();
    let wanted = Wanted { below: FAITHFUL, products, kept: named };
    let reason = match cheapest_formats(&recommended, frames, &wanted)? {
        Ok(proven) => return Ok(DefaultCore { spec: proven.spec, not_faithful: None }),
        Err(reason) => reason,
    };
    let near = wanted.near(&reason);
    let bound = specula_hdl::elaborate(&recommended, "core")?.error_bound();
    let found = if bound > LEAST_IMPROVEMENT * reason.reached {
        cheapest_formats(&recommended, frames, &near)?.ok()
    } else {
        None
    };
    let below = found.as_ref().map(|_| near.below);
    let spec = found.map_or(recommended, |found| found.spec);
    Ok(DefaultCore { spec, not_faithful: Some(NotFaithful { reason, below }) })
}

impl Wanted<'_> {
    /// The same with a goal near the smallest bound there is.
    fn near(&self, reason: &NotProven) -> Self {
        let below = (GOAL_SLACK * reason.reached / GOAL_STEP).ceil() * GOAL_STEP;
        Wanted { below, ..self.clone() }
    }
}

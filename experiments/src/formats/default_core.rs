//! The core that a scene is given where nobody asks for another one.
use specula_spec::{CoreSpec, Frames};
use specula_testbench::BenchError;

use super::{FAITHFUL, NotProven, Products, Wanted, cheapest_formats};

/// A core, and what is to be told of its formats.
#[derive(Clone, Debug)]
pub struct DefaultCore {
    /// The core.
    pub spec: CoreSpec,
    /// The reason why it has recommended formats, where no formats were found for which it is
    /// faithful.
    pub not_faithful: Option<NotProven>,
}

/// `recommended`, a core of a frame or several in recommended formats, in the cheapest that are found for
/// which it is faithful by its bound; as it is where there are none. Formats that are `named` stay,
/// and where all are, nothing is searched.
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
    let wanted = Wanted { below: FAITHFUL, products, kept: named };
    Ok(match cheapest_formats(&recommended, frames, &wanted)? {
        Ok(proven) => DefaultCore { spec: proven.spec, not_faithful: None },
        Err(reason) => DefaultCore { spec: recommended, not_faithful: Some(reason) },
    })
}

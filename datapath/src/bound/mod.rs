//! What is known of a value and of the real one that it stands for.
//!
//! These are plain numbers, as values rather than in units of the last place, so that a proof takes
//! them without knowing of graphs: [`Sig::bound`](crate::builder::Sig::bound) and
//! [`Vector::bound`](crate::builder::Vector::bound) give them. The
//! [pass over the graph](fn@crate::pass::bounds) computes them.
mod interval;
mod model;
mod vector;

pub use interval::Interval;
pub use model::{Angular, ErrorBound, ErrorModel, RELATIVE_BOUNDS, RelativeBound};
pub use vector::{Sensitivity, VectorBound, VectorError};

/// What is known of a value and of the real one that it stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Bound on |fixed - real|.
    pub error: f64,
    /// What is known of the error besides.
    pub model: ErrorModel,
    /// Every fixed value lies here.
    pub fixed: Interval,
    /// Every real value lies here.
    pub real: Interval,
    /// Weight of the last place.
    pub ulp: f64,
}

impl Bound {
    /// A value that is no further than `error` from a real one in `real`, rounded nowhere else.
    pub fn near(real: Interval, error: f64) -> Bound {
        let fixed = real.enlarged_by(error);
        Bound { error, model: ErrorModel::Bounded, fixed, real, ulp: 0.0 }
    }

    /// The largest |fixed|.
    pub fn magnitude(self) -> f64 {
        self.fixed.magnitude()
    }

    /// What is known of the angle of a cosine, if it is known as one.
    pub fn angular(self) -> Option<Angular> {
        match self.model {
            ErrorModel::Angular(angular) => Some(angular),
            _ => None,
        }
    }

    /// What is known of its error.
    pub fn error_bound(self) -> ErrorBound {
        ErrorBound { error: self.error, model: self.model }
    }

    /// Whether fixed and real value are the same.
    pub fn is_exact(self) -> bool {
        self.error == 0.0
    }

    /// What rounding to `fraction_bits` adds to the error: nothing where there are no more.
    pub fn rounding(self, fraction_bits: u32) -> f64 {
        let ulp = crate::format::power_of_two(-i64::from(fraction_bits));
        if self.ulp < ulp { 0.5 * ulp } else { 0.0 }
    }
}

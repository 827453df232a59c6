//! What is known of an error besides its bound.

/// How the error of a value from 0 to 1 depends on the value, where a proof says more than a bound.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ErrorModel {
    /// Nothing besides the bound.
    #[default]
    Bounded,
    /// The value is a cosine, the angle of which is off. Turns show by the root of the exponent in
    /// a power, and what the cosine is off by besides shows by the exponent itself.
    Angular(Angular),
    /// Each of these holds. Of several such values that add up to no more than full scale, the
    /// ratios count once.
    Relative([RelativeBound; RELATIVE_BOUNDS]),
    /// Of all values of this model in one sum, either none is off by more than `together`, or all
    /// but one are exact.
    Exclusive {
        /// Bound on the errors of all, where more than one is off.
        together: f64,
    },
}

/// How many relative bounds are kept: what is small at small values is large at large ones, and
/// which counts is seen where values are added.
pub const RELATIVE_BOUNDS: usize = 8;

/// |fixed - real| ≤ `ratio` · min(fixed, real) + `rest`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeBound {
    /// What grows with the value; not negative.
    pub ratio: f64,
    /// What does not.
    pub rest: f64,
}

/// The real value is s cos t, for a length 0 ≤ s ≤ 1 and an angle t; the fixed one is s cos t' + r:
///
/// ```text
/// |t' - t| ≤ angle
/// |r|      ≤ rest
/// ```
///
/// Both may be kept within 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angular {
    /// By how much the angle is off at most, in radians.
    pub angle: f64,
    /// By how much the cosine is off besides.
    pub rest: f64,
}

impl Angular {
    /// Nothing is known.
    pub const UNKNOWN: Angular = Angular { angle: f64::INFINITY, rest: f64::INFINITY };

    /// Itself, if anything is known.
    pub fn known(self) -> Option<Angular> {
        (self.angle + self.rest).is_finite().then_some(self)
    }
}

/// What a proof says of an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorBound {
    /// Bound on |fixed - real|.
    pub error: f64,
    /// What is known of it besides.
    pub model: ErrorModel,
}

impl ErrorBound {
    /// Of a value that may be 0 where the real one is not, or the other way round: it, or the real
    /// one, is no larger than `most` there.
    pub fn or_gated(self, most: f64) -> ErrorBound {
        let model = match self.model {
            ErrorModel::Relative(shares) => {
                let gated = |share: RelativeBound| share.rest.max(most);
                ErrorModel::Relative(
                    shares.map(|share| RelativeBound { rest: gated(share), ..share }),
                )
            }
            _ => ErrorModel::Bounded,
        };
        ErrorBound { error: self.error.max(most), model }
    }
}

impl From<f64> for ErrorBound {
    fn from(error: f64) -> ErrorBound {
        ErrorBound { error, model: ErrorModel::Bounded }
    }
}

impl From<ErrorModel> for ErrorBound {
    /// Something is known of the error besides the bound that there is.
    fn from(model: ErrorModel) -> ErrorBound {
        ErrorBound { error: f64::INFINITY, model }
    }
}

impl From<Angular> for ErrorBound {
    /// A cosine is off by no more than its angle, and what it is off by besides.
    fn from(angular: Angular) -> ErrorBound {
        match angular.known() {
            Some(Angular { angle, rest }) => {
                ErrorBound { error: angle + rest, model: ErrorModel::Angular(angular) }
            }
            None => f64::INFINITY.into(),
        }
    }
}

//! What a file declares, whatever its format.
use super::survey::Survey;
use super::variables::{Scopes, Variable};

/// What is known of a dump before values are read.
pub struct Contents {
    /// The scopes that the variables are in.
    pub scopes: Scopes,
    /// Every variable, scope by scope, those of a scope before the scopes inside it.
    pub variables: Vec<Variable>,
    /// The unit of time, such as `ns` or `10 ps`.
    pub time_unit: Option<String>,
    /// The times at which something happens.
    pub survey: Survey,
}

//! Which signal of a dump may be its clock.
use super::variables::{Scopes, Variable};

/// Names that a clock may have.
const CLOCKS: [&str; 2] = ["clock", "clk"];

/// Whether a one-bit signal of that name may be a clock.
pub fn is_clock(name: &str) -> bool {
    CLOCKS.iter().any(|clock| name.eq_ignore_ascii_case(clock))
}

/// The number of the outermost variable that may be a clock.
pub fn outermost(variables: &[Variable], scopes: &Scopes) -> Option<usize> {
    let numbered = variables.iter().enumerate();
    let clocks =
        numbered.filter(|(_, variable)| variable.width == Some(1) && is_clock(&variable.name));
    clocks.min_by_key(|(_, variable)| scopes.depth(variable.scope)).map(|(index, _)| index)
}

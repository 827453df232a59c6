//! What is linear along a span.
use super::HOST_ERROR;
use crate::builder::{Builder, Sig};

/// Start value and step of what is linear in the pixel number.
pub struct Steps<'a> {
    /// Value at the first pixel.
    pub start: &'a Sig,
    /// What it grows by with each pixel.
    pub step: &'a Sig,
}

/// x(i+1) = x(i) + d: a value from -1 to 1, by an addition a pixel. [Hast et al., eq. 4; methods
/// C2]
///
/// # Error
/// Start and step are each off by half a unit of the last place, so after `steps` steps the value
/// is off by (1 + `steps`)/2 units, and by no more outside its limits. In formats finer than f64
/// the host's own error is the larger.
pub fn linear(b: &Builder, first: &Sig, of: Steps, steps: u32) -> Sig {
    let inputs = (("start", first), ("value_start", of.start), ("step", of.step));
    b.unit("linear", "x(i+1) = x(i) + d [Hast et al., eq. 4]", inputs, |_, (first, x0, d)| {
        let error = 0.5 * f64::from(steps + 1) * x0.ulp() + HOST_ERROR;
        let limit = 1.0 + error + x0.ulp();
        Sig::accumulated(&first, &x0, &d, (-limit, limit), steps, "-1 <= x <= 1")
            .stated_error_value(error)
            .named("value")
    })
}

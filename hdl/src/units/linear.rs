//! What is linear along a span.
use crate::error;
use specula_datapath::builder::{Builder, Sig};

/// Start value and step of what is linear in the pixel number.
pub struct Steps<'a> {
    /// Value at the first pixel.
    pub start: &'a Sig,
    /// What it grows by with each pixel.
    pub step: &'a Sig,
    /// How far from 0 it comes, but for what it is off by.
    pub limit: f64,
}

/// x(i+1) = x(i) + d, by an addition a pixel. [Hast et al., eq. 4; methods C2]
///
/// The value is outside its limits by no more than it is off.
///
/// # Error
/// [`error::linear::bound`].
pub fn linear(b: &Builder, first: &Sig, of: Steps, steps: u32) -> Sig {
    let inputs = (("start", first), ("value_start", of.start), ("step", of.step));
    b.unit("linear", "x(i+1) = x(i) + d [Hast et al., eq. 4]", inputs, |_, (first, x0, d)| {
        let error = error::linear::bound(steps, x0.ulp());
        let (limit, fact) = (of.limit + error + x0.ulp(), format!("-{0} <= x <= {0}", of.limit));
        Sig::accumulated(&first, &x0, &d, (-limit, limit), steps, &fact)
            .override_error("error::linear::bound", error)
            .named("value")
    })
}

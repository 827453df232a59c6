//! Lyon, TR 43.
mod figures;
mod lengths;
mod normalisation;
mod shapes;
mod widths;

use glam::DVec3;
use specula_golden::exact::reflection::{reflect, reflection_minus_light};
use specula_golden::exact::shape::f_k;
use specula_spec::Method;

use super::claim::Claim;
use super::span_core::{SpanCore, frame, value};
use crate::stress::scene::mirror;
use crate::stress::variant::Variant;

pub use figures::figures;

/// Every claim, in the order of the report.
pub fn claims() -> Vec<&'static Claim> {
    let groups: [&'static [Claim]; 4] =
        [&shapes::CLAIMS, &lengths::CLAIMS, &normalisation::CLAIMS, &widths::CLAIMS];
    groups.into_iter().flatten().collect()
}

/// f_2 of D = R - L for a light where a unit normal in direction `normal` reflects the eye, with a
/// normal that is `length` long.
fn height(normal: DVec3, length: f64, n: u32) -> f64 {
    let d = reflection_minus_light(length * normal, reflect(normal));
    f_k(f64::from(n) / 2.0 * d.length_squared(), 2)
}

/// f_2 in the middle of a span between `ends` by a core with D = R - L, the light where the middle
/// normal reflects the eye.
fn core_height(ends: [DVec3; 2], n: u32, normalisation: &str) -> Option<f64> {
    let frame = frame(ends, 3, reflect((ends[0] + ends[1]).normalize()), mirror(n))?;
    let table = format!(
        "difference = \"reflection-minus-light\"\nnormalisation = \"{normalisation}\"\nnewton_steps = 0\n"
    );
    let core = SpanCore::new(&frame, &Variant { method: Method::Lyon, table })?;
    value(&core.trace(&frame, 1)?, "light0_square1")
}

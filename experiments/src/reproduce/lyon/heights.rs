//! How high a highlight is.
use glam::DVec3;
use specula_golden::exact::formula::reflection::{reflect, reflection_minus_light};
use specula_golden::exact::formula::shape::f_k;
use specula_spec::Method;

use crate::reproduce::span_core::{SpanCore, frame, value};
use crate::stress::scene::mirror;
use crate::stress::variant::Variant;

/// f_2 of D = R - L, with the light in the direction in which a unit normal along `normal` reflects
/// the eye, and with a normal that is `length` long.
pub fn height(normal: DVec3, length: f64, n: u32) -> f64 {
    let d = reflection_minus_light(length * normal, reflect(normal));
    f_k(f64::from(n) / 2.0 * d.length_squared(), 2)
}

/// f_2 in the middle of a span between `ends` with a core that has D = R - L, the light where the
/// middle normal reflects the eye.
pub fn core_height(ends: [DVec3; 2], n: u32, normalisation: &str) -> Option<f64> {
    let frame = frame(ends, 3, reflect((ends[0] + ends[1]).normalize()), mirror(n))?;
    let table = format!(
        "difference = \"reflection-minus-light\"\nnormalisation = \"{normalisation}\"\nnewton_steps = 0\n"
    );
    let core = SpanCore::new(&frame, &Variant { method: Method::Lyon, table })?;
    value(&core.trace(&frame, 1)?, "light0_square1")
}

//! α modulated by curvature (figure 8).
pub mod claims;
mod modulation;
mod zigzag;

use specula_scene::Frame;
use specula_spec::Method;
use specula_testbench::BenchError;

use super::super::drawn::{Drawn, drawn};
pub use modulation::modulated;
pub use zigzag::zigzag;

/// The options of cores with consistent normals for diffuse light.
const CONSISTENT: &str = "consistent.diffuse = \"consistent\"";

/// A frame of the zigzag, drawn by cores in the ways that figure 8 compares, with their names: Phong
/// shading, consistent normals, and consistent normals with modulated angles, which are inputs.
///
/// # Errors
/// [`BenchError`] if a core cannot be built, or does not agree with its model.
pub fn zigzag_pictures(frame: &Frame) -> Result<[(&'static str, Drawn); 3], BenchError> {
    Ok([
        ("Phong's normals", drawn(frame, Method::Phong, "")?),
        ("consistent normals", drawn(frame, Method::Consistent, CONSISTENT)?),
        ("modulated by curvature", drawn(&modulated(frame), Method::Consistent, CONSISTENT)?),
    ])
}

//! Lyon's shape at the vertices of Gouraud shading, of which figure 1's text says that the
//! reformulation serves it too.
use specula_scene::{Needs, Span};
use specula_spec::{CoreSpec, Method};

use super::super::claim::{Claim, Ruling, exact};
use super::super::differences::{self, by_method, differences};
use super::super::stepped::small;

/// The rms error in LSBs of Gouraud shading against exact Phong shading, with options; NaN if there is
/// no such core.
fn error(scene: &str, options: &str) -> f64 {
    let rms = || {
        let frame = small(scene)?;
        let table = format!("[gouraud]\n{options}").parse().ok()?;
        let spec =
            CoreSpec::for_scene(&Needs::of(&frame), Some(&table), Some(Method::Gouraud)).ok()?;
        let shades =
            |span: &Span| [differences::exact(&frame, span), by_method(&spec, &frame, span)];
        Some(differences(&frame, shades).rms_lsb)
    };
    rms().unwrap_or(f64::NAN)
}

/// How much larger the error is with f_2 than with the power.
fn ratio(scene: &str) -> f64 {
    error(scene, "highlight = \"f-k\"\nsquarings = 2") / error(scene, "highlight = \"power\"")
}

const fn vertices(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    let what = "Gouraud shading can have f_2 as well (an error no more than a tenth larger)";
    exact(what, quantity, expected, measure, |ratio| {
        Ruling::of(ratio < 1.1, "f_2 is wider than the power at its foot")
    })
}

/// Claims about vertices. Numbers of pictures are those that were first measured.
pub(super) const CLAIMS: [Claim; 2] = [
    vertices("rms error with f_2 over that with the power, teapot", (1.1254, 5e-5), || {
        ratio("teapot")
    }),
    vertices("rms error with f_2 over that with the power, torus", (1.0229, 5e-5), || {
        ratio("torus")
    }),
];

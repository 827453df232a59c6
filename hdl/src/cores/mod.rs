//! Cores: units put together so that a span goes in and one pixel comes out per clock.
mod consistent;
mod hybrid;
mod lyon;

use std::rc::Rc;

use specula_scene::{CoreSpec, MethodSpec};

use crate::builder::{Builder, TooWide, Vector};
use crate::design::Design;
use crate::target::Generic;

/// The core that a spec asks for, elaborated under the module name `name`.
///
/// # Errors
/// [`TooWide`] if the spec's formats ask for a signal of more than 63 bits.
pub fn elaborate(spec: &CoreSpec, name: &str) -> Result<Design, TooWide> {
    let builder = |formula| Builder::new(name, formula, Rc::new(Generic));
    match &spec.method {
        MethodSpec::Lyon(lyon) => lyon::core(builder("Lyon's reformulation of Phong shading [Lyon, TR 43]"), spec, lyon),
        MethodSpec::Hybrid(hybrid) => {
            hybrid::core(builder("Gouraud diffuse, specular p/q by forward differences [Hast et al.]"), spec, hybrid)
        }
        MethodSpec::Consistent(consistent) => {
            consistent::core(builder("Consistent normal interpolation [Reshetov, Soupikov and Mark]"), spec, consistent)
        }
    }
}

/// V = (0, 0, 1): the eye is at infinity, so what multiplies its components folds away.
fn eye(b: &Builder) -> Vector {
    Vector::new([0, 0, 1].map(|component| b.integer(component)))
}

//! Lyon's figure 9, five spheres shaded by twelve formulas. Its sum is asked of the picture that is
//! written, in `experiments/src/figure9.rs`.
use glam::DVec3;
use specula_fixtures::frames::{frame, mirror};
use specula_fixtures::specs::spec;
use specula_golden::exact::figure9::EXPONENTS;
use specula_golden::exact::formula::distributions::{Formulation, formulation};
use specula_golden::exact::method;
use specula_spec::lyon::{Difference, Halfway, Normalisation};
use specula_spec::{Method, MethodSpec};

/// Each of Lyon's rows that `lyon` has is the formula of that row, whatever the normal and the
/// light.
#[test]
fn the_methods_options_are_the_rows() {
    use Difference::{ReflectionMinusLight, UnitHalfwayMinusNormal, UnitHalfwayProjection};
    let rows = [
        (2, ReflectionMinusLight, Halfway::Unit, 0),
        (3, ReflectionMinusLight, Halfway::Unit, 1),
        (4, ReflectionMinusLight, Halfway::Unit, 2),
        (6, UnitHalfwayMinusNormal, Halfway::Unit, 2),
        (7, UnitHalfwayProjection, Halfway::Half, 2),
        (8, UnitHalfwayProjection, Halfway::HalfG2, 2),
        (9, UnitHalfwayProjection, Halfway::HalfG2, 1),
        (10, UnitHalfwayMinusNormal, Halfway::HalfG2, 2),
    ];
    let light = DVec3::new(1.0, -1.0, 1.0).normalize();
    for n in EXPONENTS {
        for steps in 0..40 {
            let tilt = f64::from(steps) * 0.035;
            let normal = DVec3::new(0.8 * tilt.sin(), -0.6 * tilt.sin(), tilt.cos());
            let frame = frame([normal; 2], 1, &[light], mirror(n));
            for (row, difference, halfway, squarings) in rows {
                let mut core = spec(&frame, Method::Lyon);
                if let MethodSpec::Lyon(lyon) = &mut core.method {
                    (lyon.difference, lyon.halfway, lyon.squarings) =
                        (difference, halfway, squarings);
                    lyon.normalisation = Normalisation::None;
                }
                let shaded = method(&core, &frame, &frame.spans[0], 0)[0] / 255.0;
                let wanted = formulation(Formulation::ALL[row - 1], n, normal, light).min(1.0);
                assert!(
                    (shaded - wanted).abs() < 1e-12,
                    "row {row}, n = {n}: {shaded} instead of {wanted}"
                );
            }
        }
    }
}

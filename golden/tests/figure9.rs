//! Lyon's figure 9, five spheres shaded by twelve formulas; its sum is known from elsewhere (METHODS.md B).
mod common;

use glam::DVec3;
use specula_golden::exact::distributions::{Formulation, formulation};
use specula_golden::exact::figure9::{BACKGROUND, Balls, EXPONENTS, colour};
use specula_golden::exact::method;
use specula_scene::Method;
use specula_scene::spec::MethodSpec;
use specula_scene::spec::lyon::{Difference, Halfway, Normalisation};

/// Sum of the picture with balls of `radius` pixels, rows of the formulas each over those before it.
fn picture_sum(radius: u32) -> f64 {
    let balls = Balls { radius };
    (0..balls.width()).map(|x| column_sum(balls, x)).sum()
}

/// Sum of what lies at one x, of every formula's picture.
fn column_sum(balls: Balls, x: u32) -> f64 {
    let mut column = vec![BACKGROUND; balls.height_of_all() as usize];
    for y in 0..balls.height() {
        if let Some((normal, ball)) = balls.at(x, y) {
            for (row, formula) in Formulation::ALL.into_iter().enumerate() {
                column[y as usize + row * balls.apart() as usize] = colour(formula, normal, ball);
            }
        }
    }
    column.iter().sum()
}

/// Each of Lyon's rows that `lyon` has is the formula of that row, whatever the normal and the light.
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
            let frame = common::frame([normal; 2], 1, &[light], common::mirror(n));
            for (row, difference, halfway, squarings) in rows {
                let mut core = common::spec(&frame, Method::Lyon).unwrap();
                if let MethodSpec::Lyon(lyon) = &mut core.method {
                    (lyon.difference, lyon.halfway, lyon.squarings) = (difference, halfway, squarings);
                    lyon.normalisation = Normalisation::None;
                }
                let shaded = method(&core, &frame, &frame.spans[0], 0)[0] / 255.0;
                let wanted = formulation(Formulation::ALL[row - 1], n, normal, light).min(1.0);
                assert!((shaded - wanted).abs() < 1e-12, "row {row}, n = {n}: {shaded} instead of {wanted}");
            }
        }
    }
}

#[test]
fn the_picture_adds_up() {
    for (radius, sum) in [(16, 1_853_799.137856), (64, 28_579_116.464381)] {
        let got = picture_sum(radius);
        assert!((got - sum).abs() < 1e-5, "radius {radius}: {got} instead of {sum}");
    }
}

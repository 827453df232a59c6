//! `exact` against figures and identities that do not come from it: the papers', docs/methods.md's
//! and docs/numerics.md's.
use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;
use proptest::prelude::*;
use specula_golden::exact::formula::consistent::{Scaling, pixel_angle, vertex_angle};
use specula_golden::exact::formula::hast::{base, eq33, eq34};
use specula_golden::exact::formula::normalisation::{g1, g2, newton, unit};
use specula_golden::exact::formula::reflection::{
    halfway, halfway_cross_normal, reflect, reflection_minus_light,
};
use specula_golden::exact::formula::shape::{f_k, power};
use specula_golden::exact::method::reflection::wrap;
use specula_scene::frame::EYE;

/// f_k of two unit vectors at `angle` radians: x = (n/2)|D|² with |D| = 2 sin(a/2).
fn f_of_angle(angle: f64, n: u32, k: u32) -> f64 {
    let d = 2.0 * (angle / 2.0).sin();
    f_k(f64::from(n) / 2.0 * d * d, k)
}

/// By how much the angles that vertices have to a face of normal z, interpolated as they are, fall
/// short of that of the normal there.
fn shortfall(normals: [DVec3; 3], weights: [f64; 3]) -> f64 {
    let unscaled = Scaling { constant: 0.0, exponent: 1 };
    let interpolated = pixel_angle(normals.map(|n| vertex_angle(n.z, unscaled)), weights);
    let normal: DVec3 = (0..3).map(|v| weights[v] * normals[v]).sum();
    DVec3::new(normal.x, normal.y, 0.0).length().atan2(normal.z) - interpolated
}

/// The most that it can be [Reshetov et al., eq. 5; numerics N1].
const LARGEST_SHORTFALL: f64 = 0.071115;

/// One normal is the face's, one at a right angle to it with the weight u: the normal there is
/// atan(u/(1 - u)) from the face's, and uπ/2 is what is interpolated. With u = (1 + √(4/π - 1))/2
/// the difference is largest.
#[test]
fn interpolated_angles_fall_short_by_four_degrees_at_most() {
    let at = |u: f64| shortfall([DVec3::Z, DVec3::X, DVec3::Z], [1.0 - u, u, 0.0]);
    let worst = (1.0 + (4.0 / PI - 1.0).sqrt()) / 2.0;
    assert!(
        (worst - 0.76136).abs() < 5e-6 && (at(worst) - LARGEST_SHORTFALL).abs() < 5e-7,
        "{} at {worst}",
        at(worst)
    );
    assert!((0..=1000).all(|k| at(f64::from(k) / 1000.0) <= at(worst)));
}

fn direction() -> impl Strategy<Value = DVec3> {
    let component = || -1.0..1.0_f64;
    (component(), component(), component())
        .prop_filter_map("a zero vector has no direction", |(x, y, z)| unit(DVec3::new(x, y, z)))
}

proptest! {
    #[test]
    fn chord_of_reflection_and_light_measures_their_angle(n in direction(), l in direction()) {
        let r = reflect(n);
        prop_assert!((r.length() - 1.0).abs() < 1e-14);
        prop_assert!(((r - l).length_squared() - (2.0 - 2.0 * r.dot(l))).abs() < 1e-14);
        prop_assert!((reflection_minus_light(n, l) - (r - l)).length() < 1e-14);
    }

    /// methods B5 and B13: |H × N| = |D3|, and |D1|² = |D3|² + (V·N - L·N)².
    #[test]
    fn halfway_cross_normal_is_the_projection(n in direction(), l in direction()) {
        let h = halfway(l);
        let d3 = h.dot(n) * n - h;
        prop_assert!((halfway_cross_normal(n, l).length() - d3.length()).abs() < 1e-14);
        let (v_n, l_n) = (EYE.dot(n), l.dot(n));
        let d1 = reflection_minus_light(n, l).length_squared();
        prop_assert!((d1 - d3.length_squared() - (v_n - l_n).powi(2)).abs() < 1e-14);
    }

    /// Reshetov et al., eq. 4 and 5: wherever in a triangle, and however the vertex normals stand
    /// in front of the face.
    #[test]
    fn interpolated_angles_fall_short_by_no_more(normals in prop::array::uniform3(direction()), draw in prop::array::uniform2(0.0..1.0_f64)) {
        let normals = normals.map(|n| DVec3::new(n.x, n.y, n.z.abs()));
        let root = draw[0].sqrt();
        let weights = [1.0 - root, root * (1.0 - draw[1]), root * draw[1]];
        prop_assert!(shortfall(normals, weights) <= LARGEST_SHORTFALL + 1e-6);
    }

    /// Hast, Prop. 2.1: the base of a normal of any length is R·L of its direction.
    #[test]
    fn base_is_the_cosine_to_the_reflection(n in direction(), l in direction(), length in 0.05..3.0_f64) {
        prop_assert!((base(length * n, l) - reflect(n).dot(l).clamp(0.0, 1.0)).abs() < 1e-14);
    }

    /// numerics N1: (17) = (33) = (34) for a normal of any length.
    #[test]
    fn three_formulas_give_one_base(n in direction(), l in direction(), length in 0.05..3.0_f64) {
        let wanted = base(length * n, l);
        prop_assert!((eq33(length * n, l) - wanted).abs() < 1e-13);
        prop_assert!((eq34(length * n, l) - wanted).abs() < 1e-13);
    }

    /// Hast, eq. 27: N' is a unit vector, and N itself where N is one; numerics N2b: where N is l
    /// long and at an angle θ from n, N' falls θ - 2 atan(l sin θ/(1 + l cos θ)) short of it.
    #[test]
    fn wrapped_normals_are_units(normal in direction(), fixed in direction(), length in 0.05..1.0_f64) {
        prop_assume!(normal.dot(fixed) > -0.9);
        prop_assert!((wrap(normal, fixed) - normal).length() < 1e-13);
        let wrapped = wrap(length * normal, fixed);
        prop_assert!((wrapped.length() - 1.0).abs() < 1e-13);
        let theta = fixed.angle_between(normal);
        let short = theta - 2.0 * (length * theta.sin() / (1.0 + length * theta.cos())).atan();
        prop_assert!((fixed.angle_between(wrapped) - (theta - short)).abs() < 1e-6);
    }

    /// "equals cos^n a EXACTLY for n = 2^k" (methods B).
    #[test]
    fn shape_is_a_power_of_the_cosine(angle in 0.0..FRAC_PI_2, k in 0..6_u32) {
        prop_assert!((f_of_angle(angle, 1 << k, k) - angle.cos().powi(1 << k)).abs() < 1e-15 * f64::from(1 << k));
    }
}

/// Percent by which g falls short of 1/length.
fn shortness(g: fn(f64) -> f64, length: f64) -> f64 {
    100.0 * (1.0 - g(length * length) * length)
}

#[test]
fn normalisation_errs_as_lyon_says() {
    let middle_of_90_degrees = 0.5_f64.sqrt();
    assert!((shortness(g1, middle_of_90_degrees) - 11.61).abs() < 0.005);
    assert!((shortness(g2, middle_of_90_degrees) - 2.77).abs() < 0.005);
    let long = (800..=1000).map(|k| shortness(g2, f64::from(k) / 1000.0)).fold(0.0, f64::max);
    assert!((long - 0.416).abs() < 0.0005 && long < 0.42, "{long}");
    let (overshoot, at) = (1..=1000)
        .map(|k| (-shortness(g2, f64::from(k) / 1000.0), k))
        .fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a });
    assert!((overshoot - 0.176).abs() < 0.0005 && at == 894, "{overshoot} at {at}");
    assert_eq!(g2(0.0), 2.0, "extremes row 27");
}

#[test]
fn newton_steps_square_the_error() {
    let z = 0.5_f64;
    let errors: Vec<f64> = [g2(z), newton(g2(z), z), newton(newton(g2(z), z), z)]
        .iter()
        .map(|g| 1.0 - g * z.sqrt())
        .collect();
    // g = (1 - e)/√z becomes (1 - (3e² - e³)/2)/√z.
    for pair in errors.windows(2) {
        let e = pair[0];
        assert!((pair[1] - (3.0 * e * e - e.powi(3)) / 2.0).abs() < 1e-15);
    }
}

/// extremes rows 21 to 23.
#[test]
fn shape_ends_where_it_should() {
    for k in 0..4 {
        let limit = f64::from(1 << k);
        assert_eq!(
            [0.0, limit, limit * (1.0 + f64::EPSILON), 1e9].map(|x| f_k(x, k)),
            [1.0, 0.0, 0.0, 0.0]
        );
        assert!(f_k(limit * (1.0 - f64::EPSILON), k) < 1e-15);
    }
    let at = |degrees: f64| {
        [0, 1, 2, 3].map(|k| (f_of_angle(degrees.to_radians(), 1, k) * 1e4).round() / 1e4)
    };
    assert_eq!(at(180.0), [0.0, 0.0, 0.0625, 0.1001]);
    assert_eq!(at(90.0), [0.0, 0.25, 0.3164, 0.3436]);
}

#[test]
fn powers_are_defined_everywhere() {
    assert_eq!(
        [(-0.5, 2), (0.0, 1), (1.0, 8191), (0.3, 0), (0.0, 0)].map(|(c, n)| power(c, n)),
        [0.0, 0.0, 1.0, 1.0, 1.0]
    );
}

/// numerics N2a: largest and root-mean-square difference of f_k and cos^n over the lobe, to 4/√n
/// and no farther than 90 degrees.
#[test]
fn shape_differs_from_phong_as_measured() {
    let printed = [
        (1, [(0.0, 0.0), (0.250, 0.090), (0.316, 0.118), (0.344, 0.130)]),
        (4, [(0.316, 0.114), (0.090, 0.043), (0.0, 0.0), (0.039, 0.022)]),
        (16, [(0.356, 0.120), (0.145, 0.063), (0.057, 0.028), (0.018, 0.0095)]),
        (64, [(0.365, 0.125), (0.158, 0.069), (0.070, 0.035), (0.031, 0.016)]),
        (256, [(0.367, 0.126), (0.161, 0.071), (0.0728, 0.036), (0.0342, 0.018)]),
        (1024, [(0.3677, 0.126), (0.1617, 0.071), (0.0735, 0.037), (0.0350, 0.0186)]),
        (8000, [(0.3679, 0.127), (0.1619, 0.071), (0.0738, 0.037), (0.0353, 0.0187)]),
    ];
    for (n, row) in printed {
        for (k, (largest, root_mean_square)) in (0..).zip(row) {
            let (max, rms) = difference_from_phong(n, k);
            assert!(
                (max - largest).abs() <= 6e-4 && (rms - root_mean_square).abs() <= 6e-4,
                "n = {n}, k = {k}: {max}, {rms}"
            );
        }
    }
}

fn difference_from_phong(n: u32, k: u32) -> (f64, f64) {
    const STEPS: u32 = 4000;
    let lobe = (4.0 / f64::from(n).sqrt()).min(FRAC_PI_2);
    let difference = |step: u32| {
        let angle = lobe * f64::from(step) / f64::from(STEPS);
        (f_of_angle(angle, n, k) - power(angle.cos(), n)).abs()
    };
    let max = (0..=STEPS).map(difference).fold(0.0, f64::max);
    let mean_square =
        (0..=STEPS).map(|s| difference(s).powi(2)).sum::<f64>() / f64::from(STEPS + 1);
    (max, mean_square.sqrt())
}

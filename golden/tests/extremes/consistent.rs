//! Consistent normal interpolation: rows 41 to 49, and that no reflection enters a face.
use std::f64::consts::{FRAC_2_PI, PI};

use glam::{DQuat, DVec3};
use specula_fixtures::Draw;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::highlights::{Choices, choices};
use specula_fixtures::specs::spec;
use specula_golden::exact::method::consistent::consistent_cosine;
use specula_scene::mesh::Mesh;
use specula_scene::mesh::normals::newell;
use specula_scene::primitive::Primitive;
use specula_scene::{Frame, VertexCone};
use specula_spec::consistent::{Curve, Diffuse, Highlight};
use specula_spec::{CoreSpec, Method, MethodSpec};

use crate::{assert_within_one_code, codes, method, observation, trace, value};

const CURVES: [Curve; 2] = [Curve::Rational, Curve::Trigonometric];

/// The defaults, with a curve and what is diffusely reflected.
fn core(frame: &Frame, curve: Curve, diffuse: Diffuse) -> CoreSpec {
    let mut core = spec(frame, Method::Consistent);
    if let MethodSpec::Consistent(consistent) = &mut core.method {
        (consistent.curve, consistent.diffuse) = (curve, diffuse);
    }
    core
}

/// A frame whose vertices have cones of this cosine.
fn with_cosine(mut frame: Frame, cosine: f64) -> Frame {
    frame.triangles[0].cones = frame.triangles[0].cones.map(|cone| VertexCone { cosine, ..cone });
    frame
}

/// Row 41: r = -I on the horizon, where N_c is undefined: 0, and 0 for a light behind it.
#[test]
fn no_diffuse_light_from_the_horizon_on() {
    for (degrees, cosine) in [(90.0, 1.0), (120.0, 0.9), (180.0, 0.5), (180.0, 0.0)] {
        let frame = with_cosine(
            frame([DVec3::Z; 2], 2, &[tilted(degrees)], material(0.0, 1.0, 0.0, 1)),
            cosine,
        );
        for curve in CURVES {
            assert_eq!(
                codes(&core(&frame, curve, Diffuse::Consistent), &frame),
                [0, 0],
                "{degrees} {cosine}"
            );
        }
    }
    assert_eq!(consistent_cosine(DVec3::Z, 1.0, DVec3::X), 0.0);
}

/// Row 42: α = π/2 and b = -1 is 0/0; r = N and ρ = 0.
#[test]
fn a_quarter_turn_seen_from_behind() {
    let frame = with_cosine(frame([-DVec3::Z; 2], 2, &[-DVec3::Z], mirror(1)), 0.0);
    for curve in CURVES {
        let core = core(&frame, curve, Diffuse::Lambert);
        let trace = trace(&core, &frame, 1);
        let values = ["angle", "contraction", "cos_beta", "sine_ratio", "reflection_z"]
            .map(|name| value(&trace, name));
        assert_eq!(values, [1.0, 0.0, -1.0, 0.0, -1.0]);
        assert_eq!(codes(&core, &frame), [255, 255]);
    }
}

/// Row 43: b = 1 gives r = N whatever ρ.
#[test]
fn seen_from_straight_above() {
    for cosine in [1.0, 0.9, 0.5, 0.1, 0.0] {
        let frame = with_cosine(frame([DVec3::Z; 2], 3, &[DVec3::Z], mirror(1)), cosine);
        for curve in CURVES {
            let trace = trace(&core(&frame, curve, Diffuse::Consistent), &frame, 2);
            let values = ["cos_gamma", "light0_diffuse", "reflection_x", "reflection_y"]
                .map(|name| value(&trace, name));
            assert_eq!(values, [1.0, 1.0, 0.0, 0.0]);
            let ulp = observation(&trace, "reflection_z").format.ulp();
            assert!((value(&trace, "reflection_z") - 1.0).abs() <= ulp, "{cosine}");
        }
    }
}

/// Row 44: α = 0 gives q = ρ = 1 and the plain reflection; one unit of the last place of t is what
/// rounding up costs.
#[test]
fn flat_surroundings_reflect_plainly() {
    for degrees in [0.0, 20.0, 60.0, 80.0] {
        let frame = frame([tilted(degrees); 2], 1, &[DVec3::Z], mirror(16));
        for curve in CURVES {
            let core = core(&frame, curve, Diffuse::Lambert);
            let trace = trace(&core, &frame, 0);
            let ulp = observation(&trace, "angle").format.ulp();
            assert!(
                value(&trace, "angle") <= ulp && value(&trace, "contraction") >= 1.0 - 5.0 * ulp
            );
            let plain = 2.0 * tilted(degrees).z * tilted(degrees) - DVec3::Z;
            let r = ["x", "y", "z"].map(|axis| value(&trace, &format!("reflection_{axis}")));
            assert!(
                (DVec3::from_array(r) - plain).length() < 1e-3,
                "{degrees}: {r:?} instead of {plain}"
            );
            assert_within_one_code(&core, &frame);
        }
    }
}

/// The defaults with Blinn's highlight.
fn blinn(frame: &Frame) -> CoreSpec {
    let mut core = spec(frame, Method::Consistent);
    if let MethodSpec::Consistent(consistent) = &mut core.method {
        consistent.highlight = Highlight::Blinn;
    }
    core
}

/// Row 44: α = 0 makes N_c the normal itself, and Blinn's highlight (N·H)^4n.
#[test]
fn flat_surroundings_have_blinns_plain_highlight() {
    for degrees in [0.0, 10.0, 25.0, 40.0, 60.0] {
        let frame = frame([tilted(degrees); 2], 1, &[tilted(60.0)], mirror(4));
        let plain = 255.0 * tilted(degrees).dot(tilted(30.0)).powi(16);
        let exact = method(&blinn(&frame), &frame)[0];
        assert!((exact - plain).abs() < 1e-9, "{degrees}: {exact} instead of {plain}");
        assert_within_one_code(&blinn(&frame), &frame);
    }
}

/// Row 12: L = -V leaves no H, and so no highlight of Blinn's.
#[test]
fn no_halfway_vector_no_highlight() {
    let frame = with_cosine(frame([tilted(80.0), tilted(100.0)], 5, &[-DVec3::Z], mirror(1)), 0.5);
    assert_eq!(codes(&blinn(&frame), &frame), [0; 5]);
}

/// Row 45: vertices of 90 degrees are enlarged beyond it, and only pixels are clamped.
#[test]
fn angles_are_clamped_at_pixels_alone() {
    assert!((Curve::Rational.quarter_turns(0.0) - 93.27 / 90.0).abs() < 1e-4);
    assert!((Curve::Trigonometric.quarter_turns(0.0) - 95.49 / 90.0).abs() < 1e-3);
    let mut frame = frame([DVec3::Z; 2], 5, &[DVec3::Z], mirror(1));
    frame.triangles[0].cones[0].cosine = 0.0;
    let trace =
        |i| value(&trace(&core(&frame, Curve::Rational, Diffuse::Lambert), &frame, i), "angle");
    // 1 at the vertex, and then down from 1.0363: a clamped vertex would give 0.75.
    assert!(trace(0) == 1.0 && (trace(1) - 0.75 * 1.03632).abs() < 1e-3);
}

/// Row 46: b = -0.99 and α = 0.3: ρ would be 7.07 and stays at 1.
#[test]
fn an_eye_behind_the_surface_is_defined() {
    let m = greatest_cosine(0.3 * FRAC_2_PI);
    let frame = with_cosine(
        frame([tilted(f64::acos(-0.99).to_degrees()); 2], 2, &[DVec3::Z], mirror(4)),
        m,
    );
    for curve in CURVES {
        let core = core(&frame, curve, Diffuse::Consistent);
        assert_eq!(value(&trace(&core, &frame, 0), "sine_ratio"), 1.0);
        assert_within_one_code(&core, &frame);
    }
}

/// The cosine whose enlarged rational angle is `t` quarter turns, by bisection.
fn greatest_cosine(t: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if Curve::Rational.quarter_turns(middle) > t { low = middle } else { high = middle }
    }
    low
}

/// Row 49: opposite normals vanish half-way, where ambient light is left alone.
#[test]
fn normals_that_vanish() {
    for diffuse in [Diffuse::Lambert, Diffuse::Consistent] {
        let frame = with_cosine(
            frame([DVec3::X, -DVec3::X], 3, &[tilted(30.0), -DVec3::Z], material(0.2, 0.5, 0.5, 4)),
            0.0,
        );
        assert_eq!(codes(&core(&frame, Curve::Rational, diffuse), &frame)[1], 51);
    }
}

/// A mesh's triangle as consistent interpolation sees it.
struct Face {
    normals: [DVec3; 3],
    cosines: [f64; 3],
    normal: DVec3,
}

/// Faces with the least cosines around their vertices; a vertex is a place and a normal, seams
/// included.
fn faces(mesh: &Mesh) -> Vec<Face> {
    let places = |t: &[u32; 3]| t.map(|k| mesh.positions[k as usize]);
    let normals: Vec<DVec3> =
        mesh.triangles.iter().map(|t| newell(&places(t)).expect("it has an area")).collect();
    let same = |a: DVec3, b: DVec3| (a - b).length() < 1e-9;
    let least = |place: DVec3, normal: DVec3| {
        let around = (0..normals.len())
            .filter(|&f| (0..3).any(|v| same(places(&mesh.triangles[f])[v], place)));
        around.map(|f| normals[f].dot(normal)).fold(1.0, f64::min)
    };
    let face = |f: usize| {
        let (corners, at) = (places(&mesh.triangles[f]), mesh.normals[f]);
        Face {
            normals: at,
            cosines: std::array::from_fn(|v| least(corners[v], at[v])),
            normal: normals[f],
        }
    };
    (0..normals.len()).map(face).collect()
}

/// A direction in the hemisphere of `face`, uniformly.
fn in_front(face: DVec3, choices: &Choices) -> DVec3 {
    let (height, turn) = (choices[0], 2.0 * PI * choices[1]);
    let across = DQuat::from_axis_angle(face, turn) * face.any_orthonormal_vector();
    (face * height + across * (1.0 - height * height).sqrt()).normalize()
}

/// Weights of a point of a triangle, uniformly.
fn inside(choices: &[f64]) -> [f64; 3] {
    let (root, share) = (choices[0].sqrt(), choices[1]);
    [1.0 - root, root * (1.0 - share), root * share]
}

/// n·r at every pixel of a span of the face seen from `eye`, in fixed arithmetic; and of the plain
/// reflection.
fn heights(face: &Face, eye: DVec3, curve: Curve, choices: &Choices) -> Vec<[f64; 2]> {
    let turn = DQuat::from_rotation_arc(eye, DVec3::Z);
    let mut frame = frame([DVec3::Z; 2], 4, &[DVec3::Z], mirror(16));
    let cone = |v: usize| VertexCone { axis: turn * face.normals[v], cosine: face.cosines[v] };
    frame.triangles[0].cones = std::array::from_fn(cone);
    frame.triangles[0].normals = face.normals.map(|n| turn * n);
    (frame.spans[0].start, frame.spans[0].end) = (inside(&choices[2..4]), inside(&choices[4..6]));
    let core = core(&frame, curve, Diffuse::Lambert);
    let vector = |trace: &[_], name: &str| {
        DVec3::from_array(["x", "y", "z"].map(|axis| value(trace, &format!("{name}_{axis}"))))
    };
    let pixel = |i| {
        let trace = trace(&core, &frame, i);
        let (n, r) = (vector(&trace, "normal"), vector(&trace, "reflection"));
        let outward = turn * face.normal;
        [outward.dot(r), outward.dot(2.0 * n.z * n - DVec3::Z)]
    };
    (0..4).map(pixel).collect()
}

/// numerics N2c and 3e: plain reflections enter faces, consistent ones never do, at the formats
/// that are chosen.
#[test]
fn no_reflection_enters_a_face() {
    let meshes = [
        (Primitive::Icosahedron { level: 0 }, 60, 0.211),
        (Primitive::Icosahedron { level: 1 }, 15, 0.105),
        // 12 x 6 cells; the table has 0.222 for 8 x 6 and 0.154 for 12 x 8.
        (Primitive::Torus { level: 3, tube: 0.4 }, 8, 0.188),
    ];
    let mut draw = Draw::new(2010);
    for (shape, each, phong) in meshes {
        let faces = faces(&shape.mesh());
        for curve in CURVES {
            let (mut inward, mut all) = (0, 0);
            for face in faces.iter().flat_map(|face| std::iter::repeat_n(face, each)) {
                let choices = choices(&mut draw);
                let heights = heights(face, in_front(face.normal, &choices), curve, &choices);
                assert!(
                    heights.iter().all(|[consistent, _]| *consistent >= 0.0),
                    "{shape:?} {curve:?}: {heights:?}"
                );
                // First pixels alone are anywhere in the face.
                (inward, all) = (inward + u32::from(heights[0][1] < 0.0), all + 1);
            }
            let share = f64::from(inward) / f64::from(all);
            assert!((share - phong).abs() < 0.03, "{shape:?}: {share} of plain reflections enter");
        }
    }
}

//! Intensities that are uniform over a polygon.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, tilted};
use specula_fixtures::specs::spec;
use specula_scene::{Facet, Frame, LocalLight, Spot};
use specula_spec::gouraud::Interpolation;
use specula_spec::{CoreSpec, Method, MethodSpec};

use crate::run::{assert_agrees, codes};

fn uniform(frame: &Frame) -> CoreSpec {
    let mut core = spec(frame, Method::Gouraud);
    if let MethodSpec::Gouraud(gouraud) = &mut core.method {
        gouraud.interpolation = Interpolation::Uniform;
    }
    core.check().unwrap();
    core
}

/// Rows 37 and 52: one code from end to end, of the mean of the vertex normals (20, 40 and 20
/// degrees), which stands in for a polygon that is not known, and no step to divide for.
#[test]
fn uniform_spans_have_one_code() {
    let mean = (2.0 * tilted(20.0) + tilted(40.0)).normalize();
    for (length, n) in [(1, 1), (2, 7), (1000, 100)] {
        let frame = frame(
            [tilted(20.0), tilted(40.0)],
            length,
            &[tilted(50.0)],
            material(0.1, 0.4, 0.5, n),
        );
        let core = uniform(&frame);
        assert!(core.inputs().iter().all(|port| !port.name.ends_with("step")));
        let base = (2.0 * mean.z * mean - DVec3::Z).dot(tilted(50.0));
        let lit = 255.0 * (0.1 + 0.4 * mean.dot(tilted(50.0)) + 0.5 * base.powi(n as i32));
        assert_eq!(codes(&core, &frame), vec![lit.round() as u8; length as usize]);
    }
}

/// Row 49: normals that cancel have no mean; ambient light alone is left.
#[test]
fn normals_that_cancel_get_ambient_light() {
    let mut frame = frame([DVec3::X, -DVec3::X], 5, &[-DVec3::Z], material(0.2, 0.4, 0.4, 2));
    let triangle = &mut frame.triangles[0];
    triangle.normals = [DVec3::X, -DVec3::X, DVec3::ZERO];
    triangle.facet = Facet::of_vertices(&triangle.normals, &triangle.positions);
    assert_eq!(codes(&uniform(&frame), &frame), [51; 5]);
}

/// A square of two units with a corner at each place given, under a spot straight above the first
/// of them.
fn floor(exponent: u32, height: f64, eye: Option<DVec3>) -> Frame {
    let mut frame = frame([DVec3::Z, DVec3::Z], 3, &[], material(0.0, 0.5, 0.5, 2));
    let triangle = &mut frame.triangles[0];
    triangle.positions = [DVec3::ZERO, DVec3::X, DVec3::Y];
    triangle.facet = Facet::of_vertices(&triangle.normals, &triangle.positions);
    let spot = Some(Spot { axis: -DVec3::Z, exponent });
    frame.local_lights = vec![LocalLight {
        position: DVec3::new(0.0, 0.0, height),
        spot,
        attenuation: None,
        colour: [1.0; 3],
    }];
    frame.eye = eye;
    frame
}

/// Intensities of vertices are exact wherever light and eye are. At the far vertex L is 45 degrees
/// off, where Lambert's cosine is √½ and Warn's factor its square ½; V = (-1, 0, 1)/√2 towards the
/// eye above the other vertex makes R·L = 0, V = Z makes it √½, its square ½.
#[test]
fn vertices_see_lights_and_eyes_at_places() {
    let far = 0.5 * 0.5f64.sqrt();
    for (eye, highlight) in [(Some(DVec3::Z), 0.0), (None, 0.5)] {
        let frame = floor(2, 1.0, eye);
        let last = 255.0 * 0.5 * (far + 0.5 * highlight);
        let expected = [255.0, (255.0 + last) / 2.0, last].map(|x| x.round() as u8);
        assert_eq!(codes(&spec(&frame, Method::Gouraud), &frame), expected, "{eye:?}");
    }
}

/// Row 39: a light or an eye at the very vertex gives it nothing, and the other one what is due to
/// it.
#[test]
fn a_light_at_a_vertex_does_not_light_it() {
    let frame = floor(1, 0.0, None);
    assert_eq!(codes(&spec(&frame, Method::Gouraud), &frame), [0; 3]);
    let seen_from_the_vertex = floor(1, 1.0, Some(DVec3::ZERO));
    // Diffuse alone at the first: 255/2.
    assert_eq!(codes(&spec(&seen_from_the_vertex, Method::Gouraud), &seen_from_the_vertex)[0], 128);
}

/// One intensity for the polygon is that of its middle.
#[test]
fn uniform_polygons_see_places_from_their_middle() {
    let mut frame = floor(1, 1.0, None);
    let third = 1.0 / 3.0;
    frame.local_lights[0].position = DVec3::new(third, third, 5.0);
    assert_eq!(codes(&uniform(&frame), &frame), [255; 3]);
    assert_agrees(&spec(&frame, Method::Gouraud), &frame);
}

//! Intensities that are uniform over a polygon.
use glam::DVec3;
use specula_scene::spec::gouraud::Interpolation;
use specula_scene::{CoreSpec, Frame, Method, MethodSpec};

use crate::common::{codes, frame, material, spec, tilted};

fn uniform(frame: &Frame) -> CoreSpec {
    let mut core = spec(frame, Method::Gouraud);
    if let MethodSpec::Gouraud(gouraud) = &mut core.method {
        gouraud.interpolation = Interpolation::Uniform;
    }
    core.check().unwrap();
    core
}

/// Rows 37 and 52: one code from end to end, of the mean of the vertex normals (20, 40 and 20 degrees), and no step to divide for.
#[test]
fn uniform_spans_have_one_code() {
    let mean = (2.0 * tilted(20.0) + tilted(40.0)).normalize();
    for (length, n) in [(1, 1), (2, 7), (1000, 100)] {
        let frame = frame([tilted(20.0), tilted(40.0)], length, &[tilted(50.0)], material(0.1, 0.4, 0.5, n));
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
    frame.triangles[0].normals = [DVec3::X, -DVec3::X, DVec3::ZERO];
    assert_eq!(codes(&uniform(&frame), &frame), [51; 5]);
}

//! How normals go along spans: the recurrences that a host starts, run in f64.
use glam::{DQuat, DVec3};
use specula_scene::{Frame, Needs, parse};
use specula_spec::slerp::SlerpSpec;
use specula_spec::{CoreSpec, Method, MethodSpec};

const STEPS: u32 = 50;

/// A span whose ends are so many degrees apart.
fn frame(degrees: f64) -> Frame {
    let end = DQuat::from_axis_angle(DVec3::Y, degrees.to_radians()) * DVec3::Z;
    let text = format!(
        "[[span]]\nlength = {}\nnormals = [[0, 0, 1], [{:.17}, 0, {:.17}]]\n",
        STEPS + 1,
        end.x,
        end.z
    );
    parse("span.toml", text).expect("the scene is right").frame
}

fn slerp(frame: &Frame, axes: &str) -> SlerpSpec {
    let table =
        format!("[slerp]\nform = \"vector\"\nframe = \"{axes}\"").parse().expect("it is a table");
    match CoreSpec::for_scene(&Needs::of(frame), Some(&table), Some(Method::Slerp))
        .expect("slerp serves")
        .method
    {
        MethodSpec::Slerp(slerp) => slerp,
        other => panic!("{other:?}"),
    }
}

/// Normals by the two rotations.
fn walked(slerp: &SlerpSpec, frame: &Frame) -> Vec<DVec3> {
    let rotation = slerp.arc_rotation(frame, &frame.spans[0]);
    let [cosine, sine, back] = rotation.turn;
    let (mut falling, mut rising) = ([1.0, rotation.falling_cosine], [rotation.rising_cosine, 0.0]);
    let turn = |[c, s]: [f64; 2], down: f64, up: f64| [c * cosine - s * down, s * cosine + c * up];
    let pixel = |_| {
        let normal = falling[0] * rotation.axes[0] + rising[1] * rotation.axes[1];
        (falling, rising) = (turn(falling, sine, back), turn(rising, back, sine));
        normal
    };
    (0..=STEPS).map(pixel).collect()
}

/// Below 10 degrees they are on the chord, elsewhere on the arc; with orthonormal axes always.
#[test]
fn rotations_lead_along_the_arc_or_the_chord() {
    for degrees in [0.0, 0.01, 9.9, 10.1, 45.0, 90.0, 150.0, 169.9, 170.1, 179.9] {
        let frame = frame(degrees);
        let ends = frame.unit_end_normals(&frame.spans[0]);
        for (axes, is_linear) in [("orthonormal", false), ("ends", degrees < 10.0)] {
            let walked = walked(&slerp(&frame, axes), &frame);
            for (i, normal) in walked.into_iter().enumerate() {
                let t = i as f64 / f64::from(STEPS);
                let arc = DQuat::from_axis_angle(DVec3::Y, t * degrees.to_radians()) * DVec3::Z;
                let wanted = if is_linear { ends[0].lerp(ends[1], t) } else { arc };
                assert!(
                    normal.distance(wanted) < 1e-11,
                    "{degrees} degrees, {axes}, pixel {i}: {normal} and not {wanted}"
                );
            }
        }
    }
}

//! Lights and eyes at places as the middle of a span sees them.
use glam::DVec3;
use specula_scene::{Frame, ParallelSpan, load};

fn lamps() -> Frame {
    load("lamps", Some((40, 30))).unwrap().frame
}

/// Angles between normals, lights and eye are those of the middle, and so are shares of spots.
#[test]
fn angles_are_those_of_the_middle() {
    let frame = lamps();
    for span in &frame.spans {
        let parallel = ParallelSpan::new(&frame, span);
        let weights = std::array::from_fn(|v| f64::midpoint(span.start[v], span.end[v]));
        let (middle, normal) = (frame.position_at(span, weights), frame.normal_at(span, weights));
        let turned = parallel.frame.normal_at(parallel.span(), weights);
        let eye = frame.view_from(middle).unwrap();
        assert!((turned.z - normal.dot(eye)).abs() < 1e-12);
        for ((light, seen), colour) in
            parallel.frame.lights.iter().zip(frame.lights_from(middle)).zip(frame.light_colours())
        {
            let seen = seen.unwrap();
            assert!((turned.dot(light.direction) - normal.dot(seen.direction)).abs() < 1e-12);
            assert!((light.direction.z - seen.direction.dot(eye)).abs() < 1e-12);
            assert_eq!(light.colour, colour.map(|component| seen.share * component));
        }
    }
}

/// extremes row 39: a light at the middle is dark, an eye there sees no highlight.
#[test]
fn places_in_the_middle_have_no_direction() {
    let mut frame = lamps();
    let span = frame.spans[0].clone();
    let middle = frame
        .position_at(&span, std::array::from_fn(|v| f64::midpoint(span.start[v], span.end[v])));
    frame.local_lights[0].position = middle;
    frame.eye = Some(middle);
    let parallel = ParallelSpan::new(&frame, &span);
    assert_eq!(parallel.frame.lights[1].colour, [0.0; 3]);
    assert_eq!(parallel.frame.materials[0].specular, [0.0; 3]);
    assert!(
        parallel.frame.triangles[0]
            .normals
            .iter()
            .all(|normal| normal.is_finite() && *normal != DVec3::ZERO)
    );
}

/// Places far away are directions.
#[test]
fn places_far_away_are_at_infinity() {
    let mut frame = lamps();
    let (light, eye) = (DVec3::new(0.6, 0.0, 0.8), DVec3::Z);
    frame.local_lights.truncate(1);
    frame.local_lights[0].position = 1e9 * light;
    frame.eye = Some(1e9 * eye);
    for span in &frame.spans {
        let parallel = ParallelSpan::new(&frame, span);
        assert!((parallel.frame.lights[1].direction - light).length() < 1e-7);
        let normals =
            parallel.frame.triangles[0].normals.iter().zip(&frame.triangles[span.triangle].normals);
        assert!(normals.into_iter().all(|(turned, normal)| (*turned - *normal).length() < 1e-7));
    }
}

//! Arcs between unit normals, and normals by slerp along the edges of triangles.
use glam::DVec3;
use proptest::prelude::*;
use specula_scene::{Arc, Frame, ScanLine, load, normal_on_edge};

fn unit() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-1.0..=1.0_f64)
        .prop_map(|v| DVec3::from_array(v).normalize_or_zero())
        .prop_filter("a direction", |v| *v != DVec3::ZERO)
}

/// [sin((1 - t) f) A + sin(t f) B]/sin f [lecture, eq. 4.7].
fn slerp([a, b]: [DVec3; 2], t: f64) -> DVec3 {
    let angle = a.cross(b).length().atan2(a.dot(b));
    (((1.0 - t) * angle).sin() * a + (t * angle).sin() * b) / angle.sin()
}

proptest! {
    #[test]
    fn arcs_are_equation_4_7(a in unit(), b in unit(), t in 0.0..=1.0_f64, s in 0.0..=1.0_f64) {
        prop_assume!(a.dot(b).abs() < 0.999_9);
        let arc = Arc::between([a, b]);
        prop_assert!(arc.at(t).distance(slerp([a, b], t)) < 1e-12);
        let (from, to) = (t.min(s), t.max(s));
        let part = arc.part([from, to]);
        prop_assert!((part.angle - (to - from) * arc.angle).abs() < 1e-15);
        prop_assert!(part.at(0.5).distance(slerp([a, b], f64::midpoint(from, to))) < 1e-12);
    }

    #[test]
    fn edges_have_the_slerp_of_their_vertices(a in unit(), b in unit(), c in unit(), t in 0.0..=1.0_f64) {
        let pairs = [[a, b], [b, c], [c, a]];
        prop_assume!(pairs.iter().all(|[a, b]| a.dot(*b).abs() < 0.999_9));
        let weights = [[1.0 - t, t, 0.0], [0.0, 1.0 - t, t], [t, 0.0, 1.0 - t]];
        for (pair, weights) in pairs.into_iter().zip(weights) {
            let normal = normal_on_edge([a, b, c], weights);
            prop_assert!(normal.distance(slerp(pair, t)) < 1e-12, "{weights:?}");
        }
    }
}

/// What there is of one direction alone is that direction.
#[test]
fn ends_without_a_normal_have_the_others() {
    let [arc, none] = [[DVec3::ZERO, DVec3::Y], [DVec3::ZERO; 2]].map(Arc::between);
    assert_eq!([arc.start, arc.end, arc.at(0.3)], [DVec3::Y; 3]);
    assert_eq!([none.start, none.end, none.at(0.3)], [DVec3::ZERO; 3]);
}

/// The edges' points and the shares between them put the pixels' centres together.
fn check(frame: &Frame) {
    for span in &frame.spans {
        let ScanLine { edges, shares } = frame.scan_line(span);
        assert!(edges.iter().all(|weights| weights.contains(&0.0)), "{span:?}: {edges:?}");
        for (share, weights) in shares.into_iter().zip([span.start, span.end]) {
            assert!((0.0..=1.0).contains(&share), "{span:?}: {share}");
            for k in 0..3 {
                let there = edges[0][k] + share * (edges[1][k] - edges[0][k]);
                assert!((there - weights[k]).abs() < 1e-9, "{span:?}: {there} of {weights:?}");
            }
        }
    }
}

#[test]
fn scan_lines_go_through_the_pixels() {
    for scene in ["teapot", "icosahedron", "torus"] {
        let frame = load(scene, Some((160, 120))).expect("it is built in").frame;
        assert!(frame.spans.iter().any(|span| span.length == 1), "{scene}");
        check(&frame);
    }
}

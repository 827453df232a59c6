//! Methods that wrap normals around the polygon's own [Hast, Barrera and Bengtsson, §4]: it is the
//! one that the polygon has, wherever the normals of its vertices point.

use glam::DVec3;
use specula_fixtures::frames::{frame, material, tilted};
use specula_golden::exact::MethodSpan;
use specula_scene::Needs;
use specula_spec::{CoreSpec, Method};

/// Options that take the polygon's normal, and those that take the one half-way between the ends.
const OPTIONS: [(Method, &str, &str); 2] = [
    (
        Method::Lyon,
        "[lyon]\nnormals = \"wrapped\"\naxis = \"face\"",
        "[lyon]\nnormals = \"wrapped\"\naxis = \"bisector\"",
    ),
    (
        Method::Reflection,
        "[reflection]\nbisector = \"triangle\"",
        "[reflection]\nbisector = \"span\"",
    ),
];

/// (27): N' = 2 H (H·n)/(H·H) - n with H = n + N, N between the ends.
fn wrapped(ends: [DVec3; 2], n: DVec3, t: f64) -> DVec3 {
    let h = n + ends[0] * (1.0 - t) + ends[1] * t;
    2.0 * h * h.dot(n) / h.dot(h) - n
}

#[test]
fn normals_are_wrapped_around_that_of_the_polygon() {
    const LENGTH: u32 = 33;
    let ends = [tilted(-25.0), tilted(35.0)];
    let light = DVec3::new(0.3, 0.4, 0.75_f64.sqrt());
    for face in [
        DVec3::new(0.0, 0.6, 0.8),
        DVec3::new(0.28, -0.75_f64.sqrt(), (0.25_f64 - 0.28 * 0.28).sqrt()),
        tilted(-40.0),
    ] {
        let mut frame = frame(ends, LENGTH, &[light], material(0.0, 1.0, 0.0, 16));
        frame.triangles[0].facet.normal = face;
        for (method, of_polygon, of_span) in OPTIONS {
            let codes = |options: &str| {
                let table = options.parse().expect("it is TOML");
                let core = CoreSpec::for_scene(&Needs::of(&frame), Some(&table), Some(method))
                    .expect("it is a core");
                let span = MethodSpan::new(&core, &frame, &frame.spans[0]);
                (0..LENGTH).map(|i| span.pixel(i)[0]).collect::<Vec<f64>>()
            };
            let (found, others) = (codes(of_polygon), codes(of_span));
            let mut largest = 0.0_f64;
            for (i, (&code, &other)) in (0..LENGTH).zip(found.iter().zip(&others)) {
                let normal = wrapped(ends, face, f64::from(i) / f64::from(LENGTH - 1));
                let right = 255.0 * normal.dot(light).max(0.0);
                assert!((code - right).abs() < 1e-6, "{method:?}, {face}: {code}, not {right}");
                largest = largest.max((code - other).abs());
            }
            assert!(largest > 1.0, "{method:?}: the half-way normal would do as well");
        }
    }
}

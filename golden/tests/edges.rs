//! What is stepped along edges from scan line to scan line, against the weights of the rasteriser.
use std::ops::Range;

use glam::{DVec2, DVec3};
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use specula_fixtures::frames::{frame, material};
use specula_golden::exact::MethodSpan;
use specula_golden::loops::software::{Mesh, by_name};
use specula_golden::loops::{Edge, EdgeArcs, Linear, Plane};
use specula_scene::picture::coverage::{Coverage, Point, STEPS};
use specula_scene::{Frame, Material, Needs, Span, load};
use specula_spec::{CoreSpec, FULL_SCALE, Method};

/// Columns and rows of a drawn picture, and how far outside it corners are at most.
const EXTENT: u32 = 256;

/// A triangle on the rasteriser's grid, seen through a picture.
fn outline() -> impl Strategy<Value = [Point; 3]> {
    let extent = i64::from(EXTENT) * STEPS;
    let coordinate = move || -extent..2 * extent;
    let point = || (coordinate(), coordinate()).prop_map(|(x, y)| Point { x, y });
    [point(), point(), point()]
}

/// Where a line of a triangle is hidden: visible runs are what is left.
fn visible(run: Range<u32>, hidden: [f64; 2]) -> Vec<Range<u32>> {
    let at = |part: f64| run.start + (f64::from(run.end - run.start) * part) as u32;
    let (from, to) = (at(hidden[0].min(hidden[1])), at(hidden[0].max(hidden[1])));
    [run.start..from, to..run.end].into_iter().filter(|run| !run.is_empty()).collect()
}

/// The spans of a triangle behind something that hides parts of lines and whole lines.
fn spans(coverage: &Coverage, hidden: &[[f64; 2]]) -> Vec<Span> {
    let span = |y, run: Range<u32>| Span {
        x: run.start,
        y,
        length: run.end - run.start,
        triangle: 0,
        start: coverage.weights(run.start, y),
        end: coverage.weights(run.end - 1, y),
    };
    let runs = coverage.runs(EXTENT, EXTENT);
    runs.flat_map(|(y, run)| {
        visible(run, hidden[y as usize % hidden.len()]).into_iter().map(move |run| (y, run))
    })
    .map(|(y, run)| span(y, run))
    .collect()
}

/// How far a value up to 1 is off in f64 at most. With each line the edge is off by a rounding of
/// where it is, by which the value is off as much as it rises over the triangle where it is widest,
/// and by a rounding of the value itself.
fn of_edges(outline: [DVec2; 3]) -> f64 {
    let [a, b, c] = outline;
    let heights = [a.y, b.y, c.y];
    let height = heights.iter().copied().fold(f64::MIN, f64::max)
        - heights.iter().copied().fold(f64::MAX, f64::min);
    let widest = (b - a).perp_dot(c - a).abs() / height;
    let extent = 3.0 * f64::from(EXTENT);
    4.0 * f64::EPSILON * height.max(1.0) * (1.0 + extent / widest)
}

/// How far it is off after S steps in f32: the first value is rounded, the step too, which counts S
/// times and is up to 1/S, and S sums are. Each time that is half of 2^-24.
fn of_steps(steps: u32) -> f64 {
    f64::from(f32::EPSILON) / 4.0 * (2.0 + f64::from(steps))
}

/// How far a pixel is off whose intensities are off by as much: they count as what they are
/// multiplied with, and of each light two factors, two products and two sums are rounded.
fn in_pixel(intensity: f64, frame: &Frame, material: &Material) -> f64 {
    let most = |of: [f64; 3]| of.into_iter().fold(0.0, f64::max);
    let lights: f64 = frame.light_colours().map(most).sum();
    let reflected = lights * (most(material.diffuse) + most(material.specular));
    let whole = most(material.ambient) * most(frame.ambient) + reflected;
    let roundings = 1.0 + 6.0 * frame.light_colours().count() as f64;
    FULL_SCALE * (reflected * intensity + whole * roundings * f64::from(f32::EPSILON) / 2.0)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// From the edges in f64: a plane through three values is where the weights say that it is.
    #[test]
    fn planes_are_what_weights_give(
        points in outline(),
        values in prop::array::uniform3(0.0..=1.0_f64),
        hidden in prop::collection::vec(prop::array::uniform2(0.0..=1.0_f64), 7),
    ) {
        let Some(coverage) = Coverage::new(points) else { return Ok(()) };
        let outline = points.map(Point::in_pixels);
        let mut edge = Edge::of_outline(outline);
        let mut plane = Plane::new(&edge, values);
        for span in spans(&coverage, &hidden) {
            let mut along: Linear<f64> = plane.to_span(edge.to_span(&span));
            let most = of_edges(outline) + f64::from(span.steps()) * f64::EPSILON;
            for i in 0..span.length {
                let expected: f64 = span.weights(i).into_iter().zip(values).map(|(w, v)| w * v).sum();
                let error = (along.pixel() - expected).abs();
                prop_assert!(error <= most, "{span:?}, pixel {i}: {error}, and {most} at most");
            }
        }
    }

    /// Normals that turn along edges from line to line, against those of the set-up, which takes the
    /// weights; lines from the last to the first too.
    #[test]
    fn normals_turn_along_edges(
        points in outline(),
        normals in prop::array::uniform9(-1.0..=1.0_f64),
        hidden in prop::collection::vec(prop::array::uniform2(0.0..=1.0_f64), 7),
    ) {
        let Some(coverage) = Coverage::new(points) else { return Ok(()) };
        let outline = points.map(Point::in_pixels);
        let normals = [0, 3, 6]
            .map(|k| DVec3::new(normals[k], normals[k + 1], normals[k + 2]).normalize_or_zero());
        let mut frame = frame([DVec3::Z; 2], 1, &[DVec3::Z], material(0.0, 1.0, 0.0, 1));
        (frame.triangles[0].normals, frame.triangles[0].outline) = (normals, Some(outline));
        frame.spans = spans(&coverage, &hidden);
        // Nearly opposite normals turn in a plane that roundings choose.
        prop_assume!([(0, 1), (1, 2), (2, 0)].iter().all(|&(a, b)| normals[a].dot(normals[b]) > -0.9));
        let mut edges = EdgeArcs::new(outline, normals);
        let upwards = frame.spans.iter().rev();
        for span in frame.spans.iter().chain(upwards) {
            let arc = frame.arc_between_edges(span);
            let Some(ends) = edges.ends(span) else { continue };
            for (one, other) in ends.into_iter().zip([arc.start, arc.end]) {
                prop_assert!(one.distance(other) < 1e-9, "{span:?}: {one} and {other}");
            }
        }
    }

    /// The loop in f32 against the method in f64, which takes the weights, whole lines hidden or not.
    #[test]
    fn gouraud_is_off_by_its_roundings(
        points in outline(),
        normals in prop::array::uniform6(-1.0..=1.0_f64),
        hidden in prop::collection::vec(prop::array::uniform2(0.0..=1.0_f64), 7),
    ) {
        let Some(coverage) = Coverage::new(points) else { return Ok(()) };
        let [a, b, c] = [0, 2, 4].map(|k| DVec3::new(normals[k], normals[k + 1], 1.0).normalize());
        let light = DVec3::new(0.48, 0.6, 0.64);
        let mut frame = frame([a, b], 1, &[light], material(0.1, 0.4, 0.5, 24));
        (frame.triangles[0].normals[2], frame.triangles[0].outline) = (c, Some(points.map(Point::in_pixels)));
        frame.spans = spans(&coverage, &hidden);
        check(&frame, "gouraud", "linear")?;
    }
}

/// Every pixel of a frame against the method's own; spans from the last to the first too, as a loop
/// takes them in any order.
fn check(frame: &Frame, name: &str, interpolation: &str) -> Result<(), TestCaseError> {
    if frame.spans.is_empty() {
        return Ok(());
    }
    let table = format!("[gouraud]\ninterpolation = \"{interpolation}\"").parse().unwrap();
    let core = CoreSpec::for_scene(&Needs::of(frame), Some(&table), Some(Method::Gouraud)).unwrap();
    let mesh = Mesh::of(frame);
    let mut software = (by_name(name).unwrap().of_mesh)(&mesh);
    let upwards = frame.spans.iter().rev().cloned();
    for spans in [frame.spans.clone(), upwards.collect()] {
        software.set_up(&spans);
        for (number, span) in spans.iter().enumerate() {
            let mut out = vec![[0.0; 3]; span.length as usize];
            software.shade(number, &mut out);
            let edges = frame.triangles[span.triangle].outline.map_or(0.0, of_edges);
            let most = in_pixel(edges + of_steps(span.steps()), frame, frame.material(span));
            let exact = MethodSpan::new(&core, frame, span);
            for (i, pixel) in (0..).zip(out) {
                let error = (0..3)
                    .map(|c| (f64::from(pixel[c]) - exact.pixel(i)[c]).abs())
                    .fold(0.0, f64::max);
                prop_assert!(
                    error <= most,
                    "{name}, {span:?}, pixel {i}: {error}, and {most} at most"
                );
            }
        }
    }
    Ok(())
}

/// Meshes whose triangles hide each other, lights and an eye at places among them.
#[test]
fn pictures_are_those_of_the_method() {
    for scene in ["teapot", "icosahedron", "lamps"] {
        let frame = load(scene, Some((80, 60))).unwrap().frame;
        check(&frame, "gouraud", "linear").unwrap();
        check(&frame, "uniform", "uniform").unwrap();
    }
}

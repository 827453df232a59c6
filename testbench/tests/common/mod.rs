//! Frames made by hand, and the bench round them.
// Each test program takes what it needs.
#![allow(dead_code)]
use glam::DVec3;
use specula_scene::{DirectionalLight, Facet, Frame, Material, Needs, Span, Triangle, VertexCone};
use specula_spec::duff::Highlight;
use specula_spec::lyon::{Difference, LyonSpec};
use specula_spec::{CoreSpec, Method, MethodSpec, reflection};
use specula_testbench::{Bench, EngineKind, Outcome};

/// A span to be put on a row of its own.
#[derive(Clone, Debug)]
pub struct Row {
    pub normals: [DVec3; 2],
    pub length: u32,
    pub material: Material,
}

/// A frame with a triangle and a span on each row, lit in white.
pub fn frame_of(rows: &[Row], lights: &[DVec3]) -> Frame {
    let triangle = |(material, row): (usize, &Row)| {
        let [first, last] = row.normals;
        let normals = [first, last, first];
        let positions = [DVec3::ZERO; 3];
        let facet = Facet::of_vertices(&normals, &positions);
        Triangle {
            normals,
            facet,
            positions,
            outline: None,
            cones: normals.map(VertexCone::flat),
            material,
        }
    };
    let span = |(number, row): (usize, &Row)| {
        let (start, end) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
        Span { x: 0, y: number as u32, length: row.length, triangle: number, start, end }
    };
    let light = |&direction: &DVec3| DirectionalLight { direction, colour: [1.0; 3] };
    Frame {
        width: rows.iter().map(|row| row.length).max().unwrap_or(1),
        height: rows.len() as u32,
        background: [7, 8, 9],
        ambient: [1.0; 3],
        lights: lights.iter().map(light).collect(),
        local_lights: Vec::new(),
        eye: None,
        materials: rows.iter().map(|row| row.material.clone()).collect(),
        triangles: rows.iter().enumerate().map(triangle).collect(),
        spans: rows.iter().enumerate().map(span).collect(),
    }
}

/// A frame of one span.
pub fn frame(normals: [DVec3; 2], length: u32, lights: &[DVec3], material: Material) -> Frame {
    frame_of(&[Row { normals, length, material }], lights)
}

/// Grey reflectances.
pub fn material(ambient: f64, diffuse: f64, specular: f64, shininess: u32) -> Material {
    Material { ambient: [ambient; 3], diffuse: [diffuse; 3], specular: [specular; 3], shininess }
}

/// Nothing but highlight at full scale.
pub fn mirror(shininess: u32) -> Material {
    material(0.0, 0.0, 1.0, shininess)
}

/// The unit vector at `degrees` from V towards x.
pub fn tilted(degrees: f64) -> DVec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    DVec3::new(sin, 0.0, cos)
}

/// The spec that the documented defaults give.
pub fn spec(frame: &Frame, method: Method) -> CoreSpec {
    CoreSpec::for_scene(&Needs::of(frame), None, Some(method)).unwrap()
}

/// `lyon` with changes.
pub fn lyon(frame: &Frame, change: impl FnOnce(&mut LyonSpec)) -> CoreSpec {
    let mut core = spec(frame, Method::Lyon);
    if let MethodSpec::Lyon(lyon) = &mut core.method {
        change(lyon);
    }
    core.check().unwrap();
    core
}

/// `lyon` with D = R - L and k squarings.
pub fn reflection_form(frame: &Frame, squarings: u32) -> CoreSpec {
    lyon(frame, |lyon| {
        (lyon.difference, lyon.squarings) = (Difference::ReflectionMinusLight, squarings)
    })
}

/// `lyon` with D = H × N and k squarings.
pub fn cross_form(frame: &Frame, squarings: u32) -> CoreSpec {
    lyon(frame, |lyon| {
        (lyon.difference, lyon.squarings) = (Difference::HalfwayCrossNormal, squarings)
    })
}

/// `duff` with one of its highlights.
pub fn duff(frame: &Frame, highlight: Highlight) -> CoreSpec {
    let mut core = spec(frame, Method::Duff);
    if let MethodSpec::Duff(duff) = &mut core.method {
        duff.specular = highlight;
    }
    core.check().unwrap();
    core
}

/// `duff` with each of its highlights.
pub fn duffs(frame: &Frame) -> [CoreSpec; 4] {
    [Highlight::Blinn, Highlight::Quotient, Highlight::Eq33, Highlight::Eq34]
        .map(|highlight| duff(frame, highlight))
}

/// `reflection` with each of its highlights, and with both fixed normals.
pub fn reflections(frame: &Frame) -> [CoreSpec; 3] {
    use reflection::{Bisector, Highlight};
    let with = |(bisector, specular)| {
        let mut core = spec(frame, Method::Reflection);
        if let MethodSpec::Reflection(reflection) = &mut core.method {
            (reflection.bisector, reflection.specular) = (bisector, specular);
        }
        core.check().unwrap();
        core
    };
    let (span, triangle) = (Bisector::Span, Bisector::Triangle);
    [(span, Highlight::Blinn), (triangle, Highlight::Hybrid), (triangle, Highlight::Eq34)].map(with)
}

/// `lyon` with both differences, `duff` and `reflection` with each of their highlights, and the
/// other methods.
pub fn cores(frame: &Frame) -> Vec<CoreSpec> {
    let several = [Method::Lyon, Method::Duff, Method::Reflection];
    let others = Method::ALL
        .into_iter()
        .filter(|method| !several.contains(method))
        .map(|method| spec(frame, method));
    let lyons = [cross_form(frame, 2), reflection_form(frame, 2)];
    lyons.into_iter().chain(duffs(frame)).chain(reflections(frame)).chain(others).collect()
}

/// Runs a core. Every pixel must be the model's and leave in its clock, every stated fact hold, and
/// no error exceed its bound.
pub fn shade(core: &CoreSpec, frame: &Frame) -> Outcome {
    let bench = Bench::new(frame, core, "core").unwrap();
    let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.comparison.first_mismatch, None, "{core:?}");
    assert_eq!((&outcome.violation, &outcome.wrong_clocks), (&None, &vec![]), "{core:?}");
    let (error, bound) =
        (outcome.comparison.errors.quantisation.max_lsb, bench.design.error_bound());
    assert!(error <= bound, "off by {error} LSB, bound {bound}: {core:?}");
    assert!(outcome.agrees());
    outcome
}

/// The red codes of a row, from left to right; the frames here are grey.
pub fn row(outcome: &Outcome, frame: &Frame, number: usize) -> Vec<u8> {
    let first = number * frame.width as usize;
    let length = frame.spans[number].length as usize;
    outcome.simulated.pixels[first..first + length].iter().map(|code| code[0]).collect()
}

/// The red codes of a frame's only span.
pub fn codes(core: &CoreSpec, frame: &Frame) -> Vec<u8> {
    row(&shade(core, frame), frame, 0)
}

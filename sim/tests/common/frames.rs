//! Small frames made by hand, and cores for them.
use glam::DVec3;
use specula_datapath::{Design, SpanPacket};
use specula_scene::{
    DirectionalLight, Facet, Frame, LocalLight, Material, Needs, Span, Spot, Triangle, VertexCone,
};
use specula_spec::lyon::LyonSpec;
use specula_spec::{CoreSpec, Method, MethodSpec};

use super::random::Random;

/// Some spans of different lengths, normals and materials under so many lights.
pub fn frame(seed: u64, lights: usize, spans: usize) -> Frame {
    let mut random = Random(seed);
    let light = |_| DirectionalLight { direction: direction(&mut random), colour: [1.0, 0.9, 0.7] };
    let lights = (0..lights).map(light).collect();
    let material = |shininess| Material {
        ambient: [0.1; 3],
        diffuse: [0.5, 0.3, 0.2],
        specular: [0.6; 3],
        shininess,
    };
    let mut frame = Frame {
        width: 64,
        height: spans as u32,
        background: [0; 3],
        ambient: [1.0; 3],
        lights,
        local_lights: Vec::new(),
        eye: None,
        materials: [16, 64].map(material).to_vec(),
        triangles: vec![],
        spans: vec![],
    };
    for index in 0..spans {
        let normal = direction(&mut random);
        let normals =
            [0.0, 0.3, -0.2].map(|tilt| (normal + tilt * direction(&mut random)).normalize());
        let positions = [DVec3::ZERO; 3];
        frame.triangles.push(Triangle {
            normals,
            facet: Facet::of_vertices(&normals, &positions),
            positions,
            outline: None,
            cones: normals.map(VertexCone::flat),
            material: index % 2,
        });
        // The first is long, so that cores for few spans differ little from those for many; single
        // pixels are among the rest.
        let length = if index == 0 { 32 } else { random.between(1, 9) as u32 };
        let (start, end) = ([1.0, 0.0, 0.0], [0.0, 0.5, 0.5]);
        frame.spans.push(Span { x: 0, y: index as u32, length, triangle: index, start, end });
    }
    frame
}

/// Makes a lamp of the second light and a spot of the third, near triangles that now lie apart, and
/// brings the eye near.
pub fn place_lights(frame: &mut Frame) {
    for (index, triangle) in (0..).zip(&mut frame.triangles) {
        let corner = DVec3::new(0.0, 0.2 * f64::from(index), 0.0);
        triangle.positions = [corner, corner + DVec3::X, corner + DVec3::new(1.0, 1.0, 0.3)];
    }
    let spot = Spot { axis: DVec3::new(0.1, 0.2, -1.0).normalize(), exponent: 9 };
    let light = |position, spot| LocalLight { position, spot, colour: [0.8, 0.9, 1.0] };
    frame.lights.truncate(1);
    frame.local_lights =
        vec![light(DVec3::new(0.5, 0.0, 2.0), None), light(DVec3::new(0.2, 1.0, 3.0), Some(spot))];
    frame.eye = Some(DVec3::new(0.0, 0.5, 4.0));
}

/// A direction in the half space of the eye.
fn direction(random: &mut Random) -> DVec3 {
    let [x, y] = [0; 2].map(|_| random.signed_unit());
    DVec3::new(x, y, 0.8 + 0.2 * random.signed_unit()).normalize()
}

/// The default spec of a method for a frame.
pub fn spec(frame: &Frame, method: Method) -> CoreSpec {
    CoreSpec::for_scene(&Needs::of(frame), None, Some(method)).unwrap()
}

/// A method's spec for a frame, with these lines in the method's table.
pub fn spec_with(frame: &Frame, method: Method, options: &str) -> CoreSpec {
    let table = format!("[{}]\n{options}", method.name()).parse().unwrap();
    CoreSpec::for_scene(&Needs::of(frame), Some(&table), Some(method)).unwrap()
}

/// The default spec of `lyon` for a frame, changed.
pub fn lyon(frame: &Frame, change: impl FnOnce(&mut LyonSpec)) -> CoreSpec {
    let mut spec = spec(frame, Method::Lyon);
    if let MethodSpec::Lyon(lyon) = &mut spec.method {
        change(lyon);
    }
    spec
}

/// A frame's spans, set up for a core.
pub fn packets(spec: &CoreSpec, frame: &Frame) -> Vec<SpanPacket> {
    frame.spans.iter().map(|span| spec.packet(frame, span)).collect()
}

/// A core, elaborated.
pub fn design(spec: &CoreSpec) -> Design {
    specula_hdl::elaborate(spec, spec.method().name()).unwrap()
}

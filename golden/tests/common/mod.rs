//! Frames of one triangle and one span, made by hand.
// Each test program takes what it needs.
#![allow(dead_code)]
pub mod draw;

use glam::DVec3;
use specula_golden::fixed::Observation;
use specula_scene::{DirectionalLight, Facet, Frame, Material, Needs, Span, Triangle, VertexCone};
use specula_spec::{CoreSpec, Method, SpanPacket, SpecError};

pub const WHITE: [f64; 3] = [1.0; 3];

/// A span from the first to the second of `normals` over `length` pixels; the lights are white.
pub fn frame(normals: [DVec3; 2], length: u32, lights: &[DVec3], material: Material) -> Frame {
    let light = |&direction: &DVec3| DirectionalLight { direction, colour: WHITE };
    let span =
        Span { x: 0, y: 0, length, triangle: 0, start: [1.0, 0.0, 0.0], end: [0.0, 1.0, 0.0] };
    Frame {
        width: length,
        height: 1,
        background: [0; 3],
        ambient: WHITE,
        lights: lights.iter().map(light).collect(),
        local_lights: Vec::new(),
        eye: None,
        materials: vec![material],
        triangles: vec![triangle([normals[0], normals[1], normals[0]])],
        spans: vec![span],
    }
}

/// A triangle whose vertices stand among faces that have its normals.
fn triangle(normals: [DVec3; 3]) -> Triangle {
    let positions = [DVec3::ZERO; 3];
    let facet = Facet::of_vertices(&normals, &positions);
    Triangle {
        normals,
        facet,
        positions,
        outline: None,
        cones: normals.map(VertexCone::flat),
        material: 0,
    }
}

/// Grey reflectances.
pub fn material(ambient: f64, diffuse: f64, specular: f64, shininess: u32) -> Material {
    Material { ambient: [ambient; 3], diffuse: [diffuse; 3], specular: [specular; 3], shininess }
}

/// Nothing but highlight at full scale.
pub fn mirror(shininess: u32) -> Material {
    material(0.0, 0.0, 1.0, shininess)
}

/// The spec that the documented defaults give, for spans of up to 4 pixels at least.
pub fn spec(frame: &Frame, method: Method) -> Result<CoreSpec, SpecError> {
    CoreSpec::for_scene(&needs(frame), None, Some(method))
}

/// A frame's needs, and spans of up to 4 pixels at least.
pub fn needs(frame: &Frame) -> Needs {
    let needs = Needs::of(frame);
    Needs { longest_span: needs.longest_span.max(4), ..needs }
}

/// A span set up for a core, kept within its ports' ranges: with 51 fraction bits or more, N·N =
/// 1 + 2^-52 of a unit normal is not.
pub fn packet(core: &CoreSpec, frame: &Frame) -> SpanPacket {
    let mut packet = core.packet(frame, &frame.spans[0]);
    for (raw, port) in packet.inputs.iter_mut().zip(core.inputs()) {
        *raw = (*raw).clamp(port.range.0, port.range.1);
    }
    packet
}

/// The value of that name.
pub fn value(trace: &[Observation], name: &str) -> f64 {
    trace
        .iter()
        .find(|o| o.name == name)
        .unwrap_or_else(|| panic!("no value is named {name}"))
        .value()
}

/// The unit vector at `degrees` from V towards x.
pub fn tilted(degrees: f64) -> DVec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    DVec3::new(sin, 0.0, cos)
}

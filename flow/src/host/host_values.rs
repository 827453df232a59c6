//! What a host has for a span of a frame, by the names that host code has for it.
use specula_scene::Attenuation;
use specula_scene::frame::{Frame, Span};
use specula_spec::gouraud::LitPoint;
use specula_spec::{CoreSpec, MethodSpec};

use super::program::{Holder, Source};

/// The numbers of a value: one, or three of a vector or a colour. None for one that is not known.
pub fn host_value(
    spec: &CoreSpec,
    frame: &Frame,
    span: &Span,
    source: &Source,
) -> Option<Vec<f64>> {
    match source.holder {
        Holder::Material => of_material(frame, span, &source.name),
        Holder::Frame if source.name == "ambient_light" => Some(frame.ambient.to_vec()),
        Holder::Frame if source.name == "eye_place" => Some(frame.eye?.to_array().to_vec()),
        Holder::Frame | Holder::Span => match of_light(&source.name) {
            Some((index, name)) => light_value(spec, frame, span, index, name),
            None => of_span(spec, frame, span, &source.name),
        },
    }
}

/// The number of a light and the rest of a name such as `light0_direction`.
fn of_light(name: &str) -> Option<(usize, &str)> {
    let (index, rest) = name.strip_prefix("light")?.split_once('_')?;
    Some((index.parse().ok()?, rest))
}

fn of_material(frame: &Frame, span: &Span, name: &str) -> Option<Vec<f64>> {
    let material = frame.material(span);
    Some(match name {
        "ambient" => material.ambient.to_vec(),
        "diffuse" => material.diffuse.to_vec(),
        "specular" => material.specular.to_vec(),
        "shininess" => vec![material.shininess.into()],
        _ => return None,
    })
}

fn of_span(spec: &CoreSpec, frame: &Frame, span: &Span, name: &str) -> Option<Vec<f64>> {
    let triangle = &frame.triangles[span.triangle];
    let axis = |weights: [f64; 3]| {
        let axes = triangle.cones.map(|cone| cone.axis);
        let sum = axes[0] * weights[0] + axes[1] * weights[1] + axes[2] * weights[2];
        sum.to_array().to_vec()
    };
    let angle = |weights: [f64; 3]| match &spec.method {
        MethodSpec::Consistent(consistent) => {
            let angles = triangle.cones.map(|cone| consistent.curve.quarter_turns(cone.cosine));
            Some(vec![interpolated(angles, weights)])
        }
        _ => None,
    };
    let vector = |vector: [f64; 3]| Some(vector.to_vec());
    if let Some((corner, what)) = name.strip_prefix("corner").and_then(|rest| rest.split_once('_'))
    {
        let corner: usize = corner.parse().ok()?;
        return match what {
            "normal" => vector(triangle.normals.get(corner)?.to_array()),
            "axis" => vector(triangle.cones.get(corner)?.axis.to_array()),
            _ => None,
        };
    }
    match name {
        "first_normal" => vector(frame.normal_at(span, span.start).to_array()),
        "last_normal" => vector(frame.normal_at(span, span.end).to_array()),
        "facet_normal" => vector(frame.facet_normal(span).to_array()),
        "first_axis" => Some(axis(span.start)),
        "last_axis" => Some(axis(span.end)),
        "first_angle" => angle(span.start),
        "last_angle" => angle(span.end),
        "first_weights" => vector(span.start),
        "last_weights" => vector(span.end),
        "first_position" => vector(frame.position_at(span, span.start).to_array()),
        "last_position" => vector(frame.position_at(span, span.end).to_array()),
        "left_weights" => vector(frame.scan_line(span).edges[0]),
        "right_weights" => vector(frame.scan_line(span).edges[1]),
        "first_share" => Some(vec![frame.scan_line(span).shares[0]]),
        "last_share" => Some(vec![frame.scan_line(span).shares[1]]),
        "middle" => vector(frame.position_at(span, span.middle()).to_array()),
        _ => None,
    }
}

fn light_value(
    spec: &CoreSpec,
    frame: &Frame,
    span: &Span,
    index: usize,
    name: &str,
) -> Option<Vec<f64>> {
    match name {
        "direction" => return Some(frame.lights.get(index)?.direction.to_array().to_vec()),
        "colour" => return Some(frame.light_colours().nth(index)?.to_vec()),
        "place" | "axis" | "exponent" | "constant" | "linear" | "quadratic" => {
            return place_value(frame, index, name);
        }
        _ => {}
    }
    let (place, what) = name.split_once('_')?;
    let of = |point: &LitPoint| match (what, &spec.method) {
        ("intensity", _) => Some(point.diffuse(index)),
        ("diffuse", _) => Some(point.attenuation(index) * point.diffuse(index)),
        ("specular", MethodSpec::Gouraud(gouraud)) => {
            let n = frame.material(span).shininess;
            let highlight = point.highlight(index, gouraud.vertex_highlight(n));
            Some(point.attenuation(index) * highlight)
        }
        _ => None,
    };
    let triangle = &frame.triangles[span.triangle];
    let weights = match place {
        "first" => span.start,
        "last" => span.end,
        "polygon" => {
            let facet = triangle.facet;
            return Some(vec![of(&LitPoint::new(frame, facet.normal, facet.middle))?]);
        }
        _ => return None,
    };
    let vertex = |v: usize| of(&LitPoint::new(frame, triangle.normals[v], triangle.positions[v]));
    Some(vec![interpolated([vertex(0)?, vertex(1)?, vertex(2)?], weights)])
}

fn place_value(frame: &Frame, index: usize, name: &str) -> Option<Vec<f64>> {
    let light = frame.local_lights.get(index.checked_sub(frame.lights.len())?)?;
    let spot = light.spot.as_ref();
    let whole = Attenuation { constant: 1.0, linear: 0.0, quadratic: 0.0 };
    let attenuation = light.attenuation.unwrap_or(whole);
    Some(match name {
        "place" => light.position.to_array().to_vec(),
        "axis" => spot?.axis.to_array().to_vec(),
        "constant" => vec![attenuation.constant],
        "linear" => vec![attenuation.linear],
        "quadratic" => vec![attenuation.quadratic],
        _ => vec![spot?.exponent.into()],
    })
}

fn interpolated(at_vertices: [f64; 3], weights: [f64; 3]) -> f64 {
    (0..3).map(|v| weights[v] * at_vertices[v]).sum()
}

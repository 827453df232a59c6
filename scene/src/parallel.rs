//! Lights and an eye at places, for methods that use one direction to each for a whole span: the
//! one that the middle of the span sees.
//!
//! "A parallel light vector, which means that we can use the same vector over the polygon" [Hast,
//! Barrera and Bengtsson, §5]; here it is used over a span.
use glam::{DQuat, DVec3};

use crate::frame::{DirectionalLight, EYE, Facet, Frame, Span, Triangle, VertexCone};

/// A span by itself, under lights and an eye at infinity.
#[derive(Clone, Debug, PartialEq)]
pub struct ParallelSpan {
    /// A frame with only this span, its triangle and its material.
    pub frame: Frame,
}

impl ParallelSpan {
    /// A span of `frame`, lit and seen from its middle. The eye is at infinity in the direction
    /// [`EYE`], so everything is rotated until the middle sees it there, which preserves the angles
    /// between vectors.
    ///
    /// What distance leaves of a light is not part of it ([`Frame::attenuation_along`]).
    ///
    /// A light at the very middle is dark; an eye there sees no highlight (extremes row 39).
    pub fn new(frame: &Frame, span: &Span) -> ParallelSpan {
        ParallelSpan::seen_from(frame, span, span.middle())
    }

    /// The same, lit and seen from the point at barycentric `weights`.
    pub fn seen_from(frame: &Frame, span: &Span, weights: [f64; 3]) -> ParallelSpan {
        let triangle = &frame.triangles[span.triangle];
        let point = frame.position_at(span, weights);
        let view = frame.view_from(point);
        let turn = DQuat::from_rotation_arc(view.unwrap_or(EYE), EYE);
        let mut material = frame.materials[triangle.material].clone();
        if view.is_none() {
            material.specular = [0.0; 3];
        }
        let lights = frame.lights_from(point).zip(frame.light_colours()).map(|(light, colour)| {
            let (direction, share) =
                light.map_or((EYE, 0.0), |light| (turn * light.direction, light.share));
            DirectionalLight { direction, colour: colour.map(|component| share * component) }
        });
        let frame = Frame {
            lights: lights.collect(),
            local_lights: Vec::new(),
            eye: None,
            materials: vec![material],
            triangles: vec![turned(triangle, turn)],
            spans: vec![Span { triangle: 0, ..span.clone() }],
            ..*frame
        };
        ParallelSpan { frame }
    }

    /// The span.
    pub fn span(&self) -> &Span {
        &self.frame.spans[0]
    }
}

fn turned(triangle: &Triangle, turn: DQuat) -> Triangle {
    // Skipping the identity preserves every bit.
    let vector = |v: DVec3| if turn == DQuat::IDENTITY { v } else { turn * v };
    Triangle {
        normals: triangle.normals.map(vector),
        facet: Facet {
            normal: vector(triangle.facet.normal),
            middle: vector(triangle.facet.middle),
        },
        positions: triangle.positions.map(vector),
        outline: triangle.outline,
        perspective: triangle.perspective,
        cones: triangle.cones.map(|cone| VertexCone { axis: vector(cone.axis), ..cone }),
        material: 0,
    }
}

impl Frame {
    /// Whether the directions to all lights and to the eye are the same at every pixel.
    pub fn directions_are_constant(&self) -> bool {
        self.local_lights.is_empty() && self.eye.is_none()
    }
}

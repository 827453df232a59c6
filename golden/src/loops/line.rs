//! The data from which the recurrences of a span are set up.
use glam::DVec3;
use specula_scene::frame::EYE;
use specula_scene::{Frame, Span};

use crate::exact::formula::normalisation::unit;

/// One span, as the set-up of a loop needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Normals at the first and last pixel; the longer has length 1.
    pub ends: [DVec3; 2],
    /// The number S of steps between them; 0 for a single pixel.
    pub steps: u32,
    /// Unit normals at the triangle's vertices.
    pub vertices: [DVec3; 3],
    /// The unit normal of the polygon; the direction of V if the polygon has none.
    pub face: DVec3,
    /// Barycentric weights at the first and last pixel.
    pub weights: [[f64; 3]; 2],
    /// Phong's exponent n.
    pub shininess: u32,
    /// V, a unit vector: the direction to the eye, constant along the span.
    pub eye: DVec3,
}

impl Line {
    /// The line of a frame's span, seen by an eye at infinity.
    pub fn new(frame: &Frame, span: &Span) -> Line {
        let triangle = &frame.triangles[span.triangle];
        Line {
            ends: frame.end_normals(span),
            steps: span.steps(),
            vertices: triangle.normals,
            face: unit(triangle.facet.normal).unwrap_or(EYE),
            weights: [span.start, span.end],
            shininess: frame.material(span).shininess,
            eye: EYE,
        }
    }

    /// The step k of the normal: (N1 - N0)/S, and 0 in a span of one pixel (extremes row 37).
    pub fn step(&self) -> DVec3 {
        (self.ends[1] - self.ends[0]) * self.per_step()
    }

    /// 1/S, and 0 for S = 0.
    pub fn per_step(&self) -> f64 {
        if self.steps == 0 { 0.0 } else { 1.0 / f64::from(self.steps) }
    }

    /// The unit normals at the ends; the direction of V where one vanishes.
    pub fn unit_ends(&self) -> [DVec3; 2] {
        self.ends.map(|end| unit(end).unwrap_or(EYE))
    }
}

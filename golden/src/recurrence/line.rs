//! What the recurrences of a span are set up from.
use glam::DVec3;
use specula_scene::frame::EYE;
use specula_scene::{Frame, Span};

use crate::exact::normalisation::unit;

/// One span as its set-up sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Normals at the first and last pixel; the longer has length 1.
    pub ends: [DVec3; 2],
    /// S, the number of steps between them; 0 for a single pixel.
    pub steps: u32,
    /// Unit normals at the triangle's vertices.
    pub vertices: [DVec3; 3],
    /// The unit normal of the polygon; V's direction for one that has none.
    pub face: DVec3,
    /// Barycentric weights at the first and last pixel.
    pub weights: [[f64; 3]; 2],
    /// Phong's exponent n.
    pub shininess: u32,
}

impl Line {
    /// A span of a frame.
    pub fn new(frame: &Frame, span: &Span) -> Line {
        let triangle = &frame.triangles[span.triangle];
        Line {
            ends: frame.end_normals(span),
            steps: span.steps(),
            vertices: triangle.normals,
            face: unit(triangle.facet.normal).unwrap_or(EYE),
            weights: [span.start, span.end],
            shininess: frame.material(span).shininess,
        }
    }

    /// k, the step of the normal: (N1 - N0)/S, and 0 in a span of one pixel (extremes row 37).
    pub fn step(&self) -> DVec3 {
        (self.ends[1] - self.ends[0]) * self.per_step()
    }

    /// 1/S, and 0 for S = 0.
    pub fn per_step(&self) -> f64 {
        if self.steps == 0 { 0.0 } else { 1.0 / f64::from(self.steps) }
    }

    /// The unit normals at the ends, V's direction for one that vanishes.
    pub fn unit_ends(&self) -> [DVec3; 2] {
        self.ends.map(|end| unit(end).unwrap_or(EYE))
    }
}

//! Gouraud diffuse with Hast's specular base, without rounding [Hast, Barrera and Bengtsson, eq. 17
//! to 26; methods C3].
use glam::{DQuat, DVec3};
use specula_scene::frame::EYE;
use specula_scene::{Frame, Span};

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use crate::exact::formula::diffuse::{gouraud, lambert};
use crate::exact::formula::hast::base;
use crate::exact::formula::illumination::{Illumination, lights_from, view_from};
use crate::exact::formula::shape::power;

/// One span, shaded by `hybrid`.
pub struct HybridSpan<'a> {
    frame: &'a Frame,
    span: &'a Span,
    /// Lambert's cosine at the vertices of each light, times what a spot leaves of it there.
    at_vertices: Vec<[f64; 3]>,
    start: DVec3,
    delta: DVec3,
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> HybridSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(frame: &'a Frame, span: &'a Span) -> Self {
        let [start, end] = frame.end_normals(span);
        HybridSpan {
            frame,
            span,
            at_vertices: at_vertices(frame, span),
            start,
            delta: end - start,
            shininess: frame.material(span).shininess,
            coefficients: Coefficients::new(frame, span),
        }
    }

    /// The highlight of a light for a normal of any length, as a pixel sees both: turned until the
    /// eye is where the formula has it.
    fn specular(&self, normal: DVec3, light: &Illumination, view: DVec3) -> f64 {
        let turn = DQuat::from_rotation_arc(view, EYE);
        let turned = |v: DVec3| if view == EYE { v } else { turn * v };
        light.share * power(base(turned(normal), turned(light.direction)), self.shininess)
    }
}

fn at_vertices(frame: &Frame, span: &Span) -> Vec<[f64; 3]> {
    let triangle = &frame.triangles[span.triangle];
    let mut at_vertices = vec![[0.0; 3]; frame.lights.len() + frame.local_lights.len()];
    for v in 0..3 {
        let lights = lights_from(frame, triangle.positions[v]);
        for (light, of_light) in lights.zip(&mut at_vertices) {
            of_light[v] = light
                .map_or(0.0, |light| light.share * lambert(triangle.normals[v], light.direction));
        }
    }
    at_vertices
}

impl ShadeSpan for HybridSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let weights = self.span.weights(i);
        let normal = self.start + self.span.parameter(i) * self.delta;
        let position = self.frame.position_at(self.span, weights);
        let view = view_from(self.frame, position);
        let lights = lights_from(self.frame, position).zip(&self.at_vertices);
        self.coefficients.sum_of(lights.map(|(light, &at_vertices)| Amounts {
            diffuse: gouraud(at_vertices, weights),
            specular:
                light.zip(view).map_or(0.0, |(light, view)| self.specular(normal, &light, view)),
        }))
    }
}

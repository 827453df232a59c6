//! Phong shading as it is meant.
use glam::DVec3;
use specula_scene::{Frame, Span};

use super::coefficients::{Amounts, Coefficients, Light};
use super::diffuse::lambert;
use super::normalisation::unit;
use super::reflection::reflect;
use super::shape::power;

/// True shading of one span: the normal interpolated linearly between the triangle's vertices and normalised at each pixel, then
/// ambient + Σ kd max(N·L, 0) + ks max(R·L, 0)^n with R = 2(N·V)N - V [METHODS.md A3, A5, B1].
pub struct PhongSpan<'a> {
    frame: &'a Frame,
    span: &'a Span,
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> PhongSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(frame: &'a Frame, span: &'a Span) -> Self {
        let shininess = frame.material(span).shininess;
        PhongSpan { frame, span, shininess, coefficients: Coefficients::new(frame, span) }
    }

    /// Pixel `i`, 0 to length - 1: 0..=255 LSB a channel. Where the interpolated normal vanishes, ambient light is all there is.
    pub fn pixel(&self, i: u32) -> [f64; 3] {
        match unit(self.frame.normal_at(self.span, self.span.weights(i))) {
            Some(normal) => self.lit(normal),
            None => self.coefficients.sum(|_| Amounts::default()),
        }
    }

    fn lit(&self, normal: DVec3) -> [f64; 3] {
        let reflection = reflect(normal);
        self.coefficients.sum(|light: &Light| Amounts {
            diffuse: lambert(normal, light.direction),
            specular: power(reflection.dot(light.direction), self.shininess),
        })
    }
}

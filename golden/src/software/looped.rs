//! The loop round every scheme.
use specula_scene::spec::FULL_SCALE;
use specula_scene::{Colour, Frame, Span};

use super::Software;
use crate::recurrence::{Line, Scheme};

/// A span's schemes, one for each light, with what material and light make of their amounts.
pub struct Loop<S> {
    ambient: [f32; 3],
    exponent: u32,
    lights: Vec<Lit<S>>,
}

struct Lit<S> {
    scheme: S,
    diffuse: [f32; 3],
    specular: [f32; 3],
}

impl<S: Scheme<f32>> Loop<S> {
    /// Sets up a span of a frame.
    pub fn new(frame: &Frame, span: &Span) -> Self {
        let (line, material) = (Line::new(frame, span), frame.material(span));
        let lit = |light: &specula_scene::DirectionalLight| Lit {
            scheme: S::new(&line, light.direction),
            diffuse: product(material.diffuse, light.colour),
            specular: product(material.specular, light.colour),
        };
        Loop {
            ambient: product(material.ambient, frame.ambient),
            exponent: S::exponent(material.shininess),
            lights: frame.lights.iter().map(lit).collect(),
        }
    }
}

impl<S: Scheme<f32>> Software for Loop<S> {
    fn shade(&self, out: &mut [[f32; 3]]) {
        out.fill(self.ambient);
        for lit in &self.lights {
            // A copy: the span can be shaded again.
            let mut scheme = lit.scheme;
            for pixel in out.iter_mut() {
                let amounts = scheme.pixel();
                let diffuse = amounts.diffuse.clamp(0.0, 1.0);
                let specular = power(amounts.base.clamp(0.0, 1.0), self.exponent);
                for (c, channel) in pixel.iter_mut().enumerate() {
                    *channel += lit.diffuse[c] * diffuse + lit.specular[c] * specular;
                }
            }
        }
        for pixel in out {
            *pixel = pixel.map(|channel| channel.min(FULL_SCALE as f32));
        }
    }
}

/// x^n by squaring; 1 for n = 0.
#[inline(always)]
pub(super) fn power(mut x: f32, mut n: u32) -> f32 {
    let mut result = 1.0;
    while n > 0 {
        if n & 1 == 1 {
            result *= x;
        }
        x *= x;
        n >>= 1;
    }
    result
}

pub(super) fn product(reflectance: Colour, light: Colour) -> [f32; 3] {
    std::array::from_fn(|c| (FULL_SCALE * reflectance[c] * light[c]) as f32)
}

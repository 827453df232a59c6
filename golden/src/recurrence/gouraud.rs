//! Shading without normals in the loop [lecture, §2 and §3; METHODS.md A3, A4].
use glam::DVec3;

use super::{Line, Linear, Number, Pair, Scheme};
use crate::exact::diffuse::{gouraud, lambert};
use crate::exact::shape::power;
use crate::exact::specular::textbook;

/// The face's own normal everywhere [eq. 2.1].
#[derive(Clone, Copy, Debug)]
pub struct Uniform<T>(Pair<T>);

impl<T: Number> Scheme<T> for Uniform<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let normal = line.face;
        Uniform(Pair { diffuse: T::of(lambert(normal, light)), base: T::of(textbook(normal, light)) })
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        self.0
    }
}

/// Intensities at the vertices, interpolated: one addition for each of I_d and I_s^n [eq. 3.6].
#[derive(Clone, Copy, Debug)]
pub struct Gouraud<T> {
    diffuse: Linear<T>,
    specular: Linear<T>,
}

impl<T: Number> Scheme<T> for Gouraud<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let specular = |weights: [f64; 3]| -> f64 {
            line.vertices.iter().zip(weights).map(|(&n, w)| w * power(textbook(n, light), line.shininess)).sum()
        };
        Gouraud {
            diffuse: between(line.weights.map(|w| gouraud(&line.vertices, w, light)), line),
            specular: between(line.weights.map(specular), line),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        Pair { diffuse: self.diffuse.pixel(), base: self.specular.pixel() }
    }

    /// The power was taken at the vertices.
    fn exponent(_: u32) -> u32 {
        1
    }
}

/// From its value at the first pixel to that at the last.
pub(super) fn between<T: Number>(ends: [f64; 2], line: &Line) -> Linear<T> {
    Linear::new(ends[0], (ends[1] - ends[0]) * line.per_step())
}

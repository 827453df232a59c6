//! Shading without normals in the loop [lecture, §2 and §3; methods A3, A4].
use glam::DVec3;

use super::{Line, Linear, Number, Pair, Scheme};
use crate::exact::diffuse::lambert;
use crate::exact::shape::power;
use crate::exact::specular::textbook;

/// The polygon's own normal everywhere [eq. 2.1]: I_d and I_s^n, which are worked out once for all
/// spans of the polygon.
#[derive(Clone, Copy, Debug)]
pub struct Uniform<T>(Pair<T>);

impl<T: Number> Uniform<T> {
    /// A polygon with these intensities.
    pub fn of(intensities: Pair<f64>) -> Self {
        Uniform(Pair { diffuse: T::of(intensities.diffuse), base: T::of(intensities.base) })
    }
}

impl<T: Number> Scheme<T> for Uniform<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        Uniform::of(intensities(line.face, light, line.shininess))
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        self.0
    }

    /// The power was taken for the polygon.
    fn exponent(_: u32) -> u32 {
        1
    }
}

/// I_d and I_s^n of a normal under a light at infinity.
fn intensities(normal: DVec3, light: DVec3, shininess: u32) -> Pair<f64> {
    Pair { diffuse: lambert(normal, light), base: power(textbook(normal, light), shininess) }
}

/// A value at a polygon's three vertices, linear between them: that of the last, and what the
/// others have more. It is worked out once for all spans of the polygon.
#[derive(Clone, Copy, Debug)]
pub struct Corners {
    last: f64,
    more: [f64; 2],
}

impl Corners {
    /// From the values at the vertices.
    pub fn new([first, second, last]: [f64; 3]) -> Corners {
        Corners { last, more: [first - last, second - last] }
    }

    /// Along a span with these weights at its first and last pixel, 1/S apart [eq. 3.5 and 3.6].
    /// What an edge is at there [eq. 3.2 to 3.4] is in the weights.
    #[inline]
    pub fn along<T: Number>(&self, [start, end]: [[f64; 3]; 2], per_step: f64) -> Linear<T> {
        let more = |by: [f64; 2]| by[0] * self.more[0] + by[1] * self.more[1];
        let step = more([end[0] - start[0], end[1] - start[1]]) * per_step;
        Linear::new(self.last + more([start[0], start[1]]), step)
    }
}

/// I_d and I_s^n at a polygon's vertices.
#[derive(Clone, Copy, Debug)]
pub struct AtVertices {
    diffuse: Corners,
    specular: Corners,
}

impl AtVertices {
    /// From the intensities at the vertices.
    pub fn new(intensities: [Pair<f64>; 3]) -> AtVertices {
        AtVertices {
            diffuse: Corners::new(intensities.map(|at| at.diffuse)),
            specular: Corners::new(intensities.map(|at| at.base)),
        }
    }
}

/// Intensities at the vertices, interpolated: one addition for each of I_d and I_s^n [eq. 3.6].
#[derive(Clone, Copy, Debug)]
pub struct Gouraud<T> {
    diffuse: Linear<T>,
    specular: Linear<T>,
}

impl<T: Number> Gouraud<T> {
    /// A span of a polygon, from the weights at its ends and 1/S.
    #[inline]
    pub fn along(polygon: &AtVertices, weights: [[f64; 3]; 2], per_step: f64) -> Self {
        Gouraud {
            diffuse: polygon.diffuse.along(weights, per_step),
            specular: polygon.specular.along(weights, per_step),
        }
    }
}

impl<T: Number> Scheme<T> for Gouraud<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let polygon = AtVertices::new(line.vertices.map(|n| intensities(n, light, line.shininess)));
        Gouraud::along(&polygon, line.weights, line.per_step())
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

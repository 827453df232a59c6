//! Shading without normals in the loop [lecture, §2 and §3; methods A3, A4].
use glam::DVec3;

use super::differences::{dot, vector};
use super::number::power;
use super::{Line, Linear, Number, Pair, Plane, Scheme};

/// The polygon's own normal everywhere [eq. 2.1]: I_d and I_s^n are computed once for all spans of
/// the polygon.
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
        Uniform::of(intensities(line.face, light, line.eye, line.shininess))
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        self.0
    }

    /// The power was computed for the polygon.
    fn exponent(_: u32) -> u32 {
        1
    }
}

/// I_d and I_s^n for a unit normal, or 0 for none, with a light and an eye in these directions [eq.
/// 2.1].
#[inline]
pub fn intensities<T: Number>(normal: DVec3, light: DVec3, eye: DVec3, shininess: u32) -> Pair<T> {
    let (n, l, v) = (vector::<T>(normal), vector(light), vector(eye));
    let (j, k) = (dot(n, l), dot(n, v));
    let jk = j * k;
    // Nothing is reflected where there is no normal.
    let cosine = ((jk + jk) - dot(l, v)).positive().at_most_one().where_positive(dot(n, n));
    Pair { diffuse: j.positive(), base: power(cosine, shininess) }
}

/// Intensities at the vertices, interpolated: one addition for each of I_d and I_s^n [eq. 3.6].
#[derive(Clone, Copy, Debug)]
pub struct Gouraud<T> {
    diffuse: Linear<T>,
    specular: Linear<T>,
}

impl<T: Number> Gouraud<T> {
    /// The scheme along a span, from I_d and I_s^n there.
    pub fn of([diffuse, specular]: [Linear<T>; 2]) -> Self {
        Gouraud { diffuse, specular }
    }
}

impl<T: Number> Scheme<T> for Gouraud<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let at_vertices: [Pair<f64>; 3] =
            line.vertices.map(|n| intensities(n, light, line.eye, line.shininess));
        Gouraud {
            diffuse: Plane::along(line, at_vertices.map(|at| at.diffuse)),
            specular: Plane::along(line, at_vertices.map(|at| at.base)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        Pair { diffuse: self.diffuse.pixel(), base: self.specular.pixel() }
    }

    /// The power was computed at the vertices.
    fn exponent(_: u32) -> u32 {
        1
    }
}

/// The function with these values at the first and the last pixel.
pub(super) fn between<T: Number>(ends: [f64; 2], line: &Line) -> Linear<T> {
    Linear::new(ends[0], (ends[1] - ends[0]) * line.per_step())
}

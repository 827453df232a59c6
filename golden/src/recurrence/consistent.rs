//! Consistent normals: r of the eye, and N·L as it is [Reshetov, Soupikov and Mark; METHODS.md D], with the rational q.
use std::f64::consts::PI;

use glam::DVec3;
use specula_scene::frame::EYE;

use super::differences::{Vector, dot, scaled, vector};
use super::{Line, Linear, Number, Pair, Scheme, Walk};
use crate::exact::consistent::{Scaling, vertex_angle};

/// base r·L with r = (g + ρb)N - ρV; α comes from the vertices and is clamped at the pixel.
#[derive(Clone, Copy, Debug)]
pub struct Consistent<T> {
    normal: Walk<T>,
    /// 1 - t with t = 2α/π.
    complement: Linear<T>,
    light: Vector<T>,
    eye: Vector<T>,
    light_eye: T,
}

impl<T: Number> Scheme<T> for Consistent<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let face = line.face();
        let angles = line.vertices.map(|n| vertex_angle(n.dot(face), Scaling::RATIONAL));
        let complement = |weights: [f64; 3]| 1.0 - weights.iter().zip(angles).map(|(w, a)| w * a).sum::<f64>() * 2.0 / PI;
        Consistent {
            normal: Walk::new(line.ends[0], line.step()),
            complement: super::gouraud::between(line.weights.map(complement), line),
            light: vector(light),
            eye: vector(EYE),
            light_eye: T::of(light.dot(EYE)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let one = T::of(1.0);
        let n = self.normal.pixel();
        let s = one / dot(n, n).floored().square_root();
        let n = scaled(s, n);
        let b = dot(n, self.eye);
        // α ≤ π/2 keeps 1 - t at 0 or more.
        let u = self.complement.pixel().positive();
        // (1-t)²/(1 + (π-2)t), t = 1 - u.
        let q = u * u / (T::of(PI - 1.0) - T::of(PI - 2.0) * u);
        let g = one - q * (one - b);
        // At most 1: an eye behind the face would ask for more (EXTREMES row 46).
        let rho = (q * (one + g) / (one + b).floored()).positive().at_most_one().square_root();
        let diffuse = dot(n, self.light);
        Pair { diffuse, base: (g + rho * b) * diffuse - rho * self.light_eye }
    }
}

//! Consistent normals [Reshetov, Soupikov and Mark; methods D]: r of the eye with plain N·L, or N_c
//! of each incoming vector.
use std::f64::consts::{FRAC_PI_2, PI};
use std::marker::PhantomData;

use glam::DVec3;

use super::differences::{Vector, dot, scaled, vector};
use super::lyon::{Halfway, Unit};
use super::{Line, Linear, Number, Pair, Scheme, Walk};
use crate::exact::formula::consistent::{Scaling, vertex_angle};

/// The dependence of q on the angle α.
pub trait Curve: Copy {
    /// The enlargement of vertex angles that belongs to it.
    const SCALING: Scaling;

    /// q as a function of u = 1 - 2α/π, 0 to 1.
    fn q<T: Number>(u: T) -> T;
}

/// (1-t)²/(1 + (π-2)t) with t = 2α/π [figure 6].
#[derive(Clone, Copy, Debug)]
pub struct Rational;

impl Curve for Rational {
    const SCALING: Scaling = Scaling::RATIONAL;

    #[inline(always)]
    fn q<T: Number>(u: T) -> T {
        u * u / (T::of(PI - 1.0) - T::of(PI - 2.0) * u)
    }
}

/// (1 - sin α)/(1 + sin α) [eq. 1], with the scaling that suffices everywhere (extremes row 47).
#[derive(Clone, Copy, Debug)]
pub struct Trigonometric;

impl Curve for Trigonometric {
    const SCALING: Scaling = Scaling::TRIGONOMETRIC_LINEAR;

    #[inline(always)]
    fn q<T: Number>(u: T) -> T {
        let (one, sine) = (T::of(1.0), (T::of(FRAC_PI_2) * (T::of(1.0) - u)).sine());
        (one - sine) / (one + sine)
    }
}

/// The unit normal and q, from pixel to pixel; α is interpolated between the vertices and clamped
/// at the pixel.
#[derive(Clone, Copy, Debug)]
struct Surface<T, C> {
    normal: Walk<T>,
    /// 1 - t with t = 2α/π.
    complement: Linear<T>,
    curve: PhantomData<C>,
}

impl<T: Number, C: Curve> Surface<T, C> {
    fn new(line: &Line) -> Self {
        let face = line.face;
        let angles = line.vertices.map(|n| vertex_angle(n.dot(face), C::SCALING));
        let complement = |weights: [f64; 3]| {
            1.0 - weights.iter().zip(angles).map(|(w, a)| w * a).sum::<f64>() * 2.0 / PI
        };
        Surface {
            normal: Walk::new(line.ends[0], line.step()),
            complement: super::gouraud::between(line.weights.map(complement), line),
            curve: PhantomData,
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> (Vector<T>, T) {
        let n = self.normal.pixel();
        let s = T::of(1.0) / dot(n, n).floored().square_root();
        // α ≤ π/2 keeps 1 - t from being negative.
        (scaled(s, n), C::q(self.complement.pixel().positive()))
    }
}

/// g and ρ, computed from q and b = N·I; with them, r = (g + ρb)N - ρI.
#[inline(always)]
fn turned<T: Number>(q: T, b: T) -> [T; 2] {
    let one = T::of(1.0);
    let g = one - q * (one - b);
    // The clamp to 1 matters for an eye behind the face (extremes row 46).
    let rho = (q * (one + g) / (one + b).floored()).positive().at_most_one().square_root();
    [g, rho]
}

/// The base r·L, with r of the eye.
#[derive(Clone, Copy, Debug)]
pub struct Consistent<T, C> {
    surface: Surface<T, C>,
    light: Vector<T>,
    eye: Vector<T>,
    light_eye: T,
}

impl<T: Number, C: Curve> Scheme<T> for Consistent<T, C> {
    fn new(line: &Line, light: DVec3) -> Self {
        Consistent {
            surface: Surface::new(line),
            light: vector(light),
            eye: vector(line.eye),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let (n, q) = self.surface.pixel();
        let b = dot(n, self.eye);
        let [g, rho] = turned(q, b);
        let diffuse = dot(n, self.light);
        Pair { diffuse, base: (g + rho * b) * diffuse - rho * self.light_eye }
    }
}

/// N_c·L for I = L, and Blinn's N_c·H* for I = H*, to the power 4n [§2.4].
#[derive(Clone, Copy, Debug)]
pub struct ConsistentNormal<T, C> {
    surface: Surface<T, C>,
    light: Vector<T>,
    halfway: Vector<T>,
    /// |H*|, 0 where L = -V (extremes row 12).
    has_halfway: T,
}

impl<T: Number, C: Curve> Scheme<T> for ConsistentNormal<T, C> {
    fn new(line: &Line, light: DVec3) -> Self {
        let halfway = Unit::of(light + line.eye);
        ConsistentNormal {
            surface: Surface::new(line),
            light: vector(light),
            halfway: vector(halfway),
            has_halfway: T::of(halfway.length()),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let (n, q) = self.surface.pixel();
        let base = cosine(q, dot(n, self.halfway)).where_positive(self.has_halfway);
        Pair { diffuse: cosine(q, dot(n, self.light)), base }
    }

    fn exponent(shininess: u32) -> u32 {
        4 * shininess
    }
}

/// N_c·I = √((1 + b(g + ρb) - ρ)/2), from half the angle between I and r; 0 for an I so far below
/// the horizon that this is 90 degrees or more.
#[inline(always)]
fn cosine<T: Number>(q: T, b: T) -> T {
    let [g, rho] = turned(q, b);
    (T::of(1.0) + b * (g + rho * b) - rho).halved().positive().square_root().where_positive(g + b)
}

//! Lyon's loop: approximate normalisation, D, and 1 - x/2^k to the power 2^k [Lyon, TR 43; METHODS.md B1 to B13], with k = 2.
use glam::DVec3;
use specula_scene::frame::EYE;

use super::differences::{Vector, difference, dot, scaled, vector};
use super::{Line, Number, Pair, Scheme, Walk};
use crate::exact::reflection::halfway;

/// k: "visually indistinguishable" from Phong's.
const SQUARINGS: u32 = 2;

/// N = g2(N'·N') N' [METHODS.md B9].
#[derive(Clone, Copy, Debug)]
struct Normal<T>(Walk<T>);

impl<T: Number> Normal<T> {
    #[inline(always)]
    fn pixel(&mut self) -> Vector<T> {
        let n = self.0.pixel();
        let y = T::of(1.0) - dot(n, n);
        scaled(T::of(1.0) + (y + y * y).halved(), n)
    }
}

/// 1 - x/2^k with x = (n/2) D·D, as the base of a power 2^k.
#[inline(always)]
fn shape<T: Number>(scale: T, difference: Vector<T>) -> T {
    T::of(1.0) - scale * dot(difference, difference)
}

/// n/2^(k+1).
fn scale<T: Number>(line: &Line) -> T {
    T::of(f64::from(line.shininess) / f64::from(2 << SQUARINGS))
}

/// D = R - L with R = 2(V·N)N - V [figures 2 and 7].
#[derive(Clone, Copy, Debug)]
pub struct LyonReflection<T> {
    normal: Normal<T>,
    light: Vector<T>,
    twice_eye: Vector<T>,
    halfway: Vector<T>,
    scale: T,
}

impl<T: Number> Scheme<T> for LyonReflection<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        LyonReflection {
            normal: Normal(Walk::new(line.ends[0], line.step())),
            light: vector(light),
            twice_eye: vector(2.0 * EYE),
            halfway: vector(halfway(light)),
            scale: scale(line),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let n = self.normal.pixel();
        let d = difference(scaled(dot(n, self.twice_eye), n), self.halfway);
        Pair { diffuse: dot(n, self.light), base: shape(self.scale, d) }
    }

    fn exponent(_: u32) -> u32 {
        1 << SQUARINGS
    }
}

/// D = H × N [METHODS.md B13].
#[derive(Clone, Copy, Debug)]
pub struct LyonCross<T> {
    normal: Normal<T>,
    light: Vector<T>,
    halfway: Vector<T>,
    scale: T,
}

impl<T: Number> Scheme<T> for LyonCross<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        LyonCross {
            normal: Normal(Walk::new(line.ends[0], line.step())),
            light: vector(light),
            halfway: vector(halfway(light)),
            scale: scale(line),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let (n, h) = (self.normal.pixel(), self.halfway);
        let d = [h[1] * n[2] - h[2] * n[1], h[2] * n[0] - h[0] * n[2], h[0] * n[1] - h[1] * n[0]];
        Pair { diffuse: dot(n, self.light), base: shape(self.scale, d) }
    }

    fn exponent(_: u32) -> u32 {
        1 << SQUARINGS
    }
}

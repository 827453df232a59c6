//! The lecture's two ways to shade with an interpolated normal [lecture, §4.1 to §4.3; methods
//! A5 to A7].
use glam::DVec3;

use super::differences::{Vector, dot, vector};
use super::gouraud::between;
use super::{Line, Linear, Number, Pair, Scheme, Walk};

/// N += ΔN, N/|N|, then N·L and 2(L·N)(N·V) - L·V [eq. 4.1, 4.2, 4.5].
#[derive(Clone, Copy, Debug)]
pub struct Phong<T> {
    normal: Walk<T>,
    light: Vector<T>,
    eye: Vector<T>,
    light_eye: T,
}

impl<T: Number> Scheme<T> for Phong<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        Phong {
            normal: Walk::new(line.ends[0], line.step()),
            light: vector(light),
            eye: vector(line.eye),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let n = self.normal.pixel();
        let length = dot(n, n).floored().square_root();
        let unit = n.map(|c| c / length);
        let (j, k) = (dot(unit, self.light), dot(unit, self.eye));
        let jk = j * k;
        Pair { diffuse: j, base: (jk + jk) - self.light_eye }
    }
}

/// J += ΔJ, K += ΔK, N += ΔN, D = N·N; √D by Newton steps from the previous pixel; I_d = J/√D, base
/// 2JK/D - L·V [eq. 4.3 to 4.6].
#[derive(Clone, Copy, Debug)]
pub struct FastPhong<T, const STEPS: usize> {
    /// J.
    j: Linear<T>,
    /// 2K.
    twice_k: Linear<T>,
    normal: Walk<T>,
    length: T,
    light_eye: T,
}

impl<T: Number, const STEPS: usize> Scheme<T> for FastPhong<T, STEPS> {
    fn new(line: &Line, light: DVec3) -> Self {
        FastPhong {
            j: between(line.ends.map(|n| n.dot(light)), line),
            twice_k: between(line.ends.map(|n| 2.0 * n.dot(line.eye)), line),
            normal: Walk::new(line.ends[0], line.step()),
            // The root is exact at the first pixel: nothing is taken over from another span
            // (extremes rows 18 and 20).
            length: T::of(line.ends[0].length()).floored(),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let (n, j, twice_k) = (self.normal.pixel(), self.j.pixel(), self.twice_k.pixel());
        let d = dot(n, n).floored();
        for _ in 0..STEPS {
            self.length = newton(self.length, d);
        }
        Pair { diffuse: j / self.length, base: twice_k * j / d - self.light_eye }
    }
}

/// x - (x² - D)/(2x) = (x + D/x)/2: one division, one addition and a shift.
#[inline(always)]
fn newton<T: Number>(x: T, square: T) -> T {
    (x + square / x).halved().floored()
}

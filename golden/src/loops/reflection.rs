//! Reflection shading: the face's normal wrapped around n + N [Hast, Barrera and Bengtsson, §4;
//! methods C6, C7, C12 to C14].
//!
//! The caller checks [`wrap::serves`](crate::exact::formula::wrap::serves) first (extremes row 8).
use glam::DVec3;

use super::differences::{Vector, difference, dot, scaled, sum, vector};
use super::duff::{Base, unit_halfway};
use super::{Line, Number, Pair, Scheme, Second, Walk};
use crate::exact::formula::quadratic::Quadratic;

/// The numerator [2(H·a)(H·n) - (n·a)(H·H)] of N'·a [eq. 29 to 32].
fn numerator<T: Number>(line: &Line, along: DVec3) -> Second<T> {
    let (face, k) = (line.face, line.step());
    let m = line.ends[0] + face;
    let p =
        Quadratic::product(m, k, 2.0 * face, along).plus(-face.dot(along), Quadratic::square(m, k));
    Second::new(p)
}

/// N'·L as p/q, without a highlight [methods C6].
#[derive(Clone, Copy, Debug)]
pub struct Reflection<T> {
    p: Second<T>,
    q: Second<T>,
}

impl<T: Number> Scheme<T> for Reflection<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let q = Quadratic::square(line.ends[0] + line.face, line.step());
        Reflection { p: numerator(line, light), q: Second::new(q) }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        Pair { diffuse: self.p.pixel() / self.q.pixel().floored(), base: T::of(0.0) }
    }
}

/// N'·L, and N'·H/|H| to the power 4n, over one q [methods C12].
#[derive(Clone, Copy, Debug)]
pub struct ReflectionBlinn<T> {
    lambert: Reflection<T>,
    halfway: Second<T>,
}

impl<T: Number> Scheme<T> for ReflectionBlinn<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        ReflectionBlinn {
            lambert: Reflection::new(line, light),
            halfway: numerator(line, unit_halfway(light, line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let per_q = T::of(1.0) / self.lambert.q.pixel().floored();
        Pair { diffuse: self.lambert.p.pixel() * per_q, base: self.halfway.pixel() * per_q }
    }

    fn exponent(shininess: u32) -> u32 {
        4 * shininess
    }
}

/// N'·L, and the highlight of hybrid shading [methods C13].
#[derive(Clone, Copy, Debug)]
pub struct ReflectionHybrid<T> {
    lambert: Reflection<T>,
    base: Base<T>,
}

impl<T: Number> Scheme<T> for ReflectionHybrid<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        ReflectionHybrid { lambert: Reflection::new(line, light), base: Base::new(line, light) }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        Pair { base: self.base.pixel(), ..self.lambert.pixel() }
    }
}

/// N'·L and r = 2N'·V over one q: base r I_d - L·V [methods C14].
#[derive(Clone, Copy, Debug)]
pub struct ReflectionRoot<T> {
    lambert: Reflection<T>,
    eye: Second<T>,
    light_eye: T,
}

impl<T: Number> Scheme<T> for ReflectionRoot<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        ReflectionRoot {
            lambert: Reflection::new(line, light),
            eye: numerator(line, 2.0 * line.eye),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let per_q = T::of(1.0) / self.lambert.q.pixel().floored();
        let diffuse = self.lambert.p.pixel() * per_q;
        Pair { diffuse, base: self.eye.pixel() * per_q * diffuse - self.light_eye }
    }
}

/// Each N' wrapped around the previous one: the vector itself, without a quadratic [methods C7].
#[derive(Clone, Copy, Debug)]
pub struct Chained<T> {
    before: Vector<T>,
    normal: Walk<T>,
    light: Vector<T>,
    twice_eye: Vector<T>,
    light_eye: T,
}

impl<T: Number> Scheme<T> for Chained<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        Chained {
            before: vector(line.unit_ends()[0]),
            normal: Walk::new(line.ends[0], line.step()),
            light: vector(light),
            twice_eye: vector(2.0 * line.eye),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let h = sum(self.before, self.normal.pixel());
        let along = dot(h, self.before);
        let turned = scaled((along + along) / dot(h, h).floored(), h);
        self.before = difference(turned, self.before);
        let diffuse = dot(self.before, self.light);
        Pair { diffuse, base: dot(self.before, self.twice_eye) * diffuse - self.light_eye }
    }
}

//! Lyon's loop: approximate normalisation, D, and 1 - x/K to the power K, with K = 2^k or any other
//! number [Lyon, TR 43; methods B1 to B13].
use std::marker::PhantomData;

use glam::DVec3;

use super::differences::{Vector, difference, dot, scaled, vector};
use super::{Line, Number, Pair, Scheme, Walk};
use crate::exact::formula::normalisation::{g2, unit};

/// N = g2(N'·N') N' [methods B9].
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

/// The vector D between two directions, whose length measures the distance from the highlight.
pub trait DifferenceVector<T: Number>: Copy {
    /// The factor of n that goes with D·D.
    const FACTOR: u32;

    /// Sets the vector up for a light and an eye in the unit directions L and V.
    fn new(light: DVec3, eye: DVec3) -> Self;

    /// D for a normal.
    fn of(&self, normal: Vector<T>) -> Vector<T>;
}

/// N·L, and 1 - x/K with x = (n/2) D·D; the power K is computed afterwards [methods B10]. K = 4 is
/// "visually indistinguishable" from Phong's.
#[derive(Clone, Copy, Debug)]
pub struct Lyon<T, D, const K: u32> {
    normal: Normal<T>,
    light: Vector<T>,
    chord: D,
    /// n/2K.
    scale: T,
}

impl<T: Number, D: DifferenceVector<T>, const K: u32> Scheme<T> for Lyon<T, D, K> {
    fn new(line: &Line, light: DVec3) -> Self {
        Lyon {
            normal: Normal(Walk::new(line.ends[0], line.step())),
            light: vector(light),
            chord: D::new(light, line.eye),
            scale: T::of(f64::from(D::FACTOR * line.shininess) / f64::from(2 * K)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let n = self.normal.pixel();
        let d = self.chord.of(n);
        Pair { diffuse: dot(n, self.light), base: T::of(1.0) - self.scale * dot(d, d) }
    }

    fn exponent(_: u32) -> u32 {
        K
    }
}

/// D = R - L with R = 2(V·N)N - V [figures 2 and 7].
#[derive(Clone, Copy, Debug)]
pub struct Reflected<T> {
    twice_eye: Vector<T>,
    halfway: Vector<T>,
}

impl<T: Number> DifferenceVector<T> for Reflected<T> {
    const FACTOR: u32 = 1;

    fn new(light: DVec3, eye: DVec3) -> Self {
        Reflected { twice_eye: vector(2.0 * eye), halfway: vector(light + eye) }
    }

    #[inline(always)]
    fn of(&self, n: Vector<T>) -> Vector<T> {
        difference(scaled(dot(n, self.twice_eye), n), self.halfway)
    }
}

/// D2 = 2(L·N)N - H [figure 5].
#[derive(Clone, Copy, Debug)]
pub struct LightReflected<T> {
    twice_light: Vector<T>,
    halfway: Vector<T>,
}

impl<T: Number> DifferenceVector<T> for LightReflected<T> {
    const FACTOR: u32 = 1;

    fn new(light: DVec3, eye: DVec3) -> Self {
        LightReflected { twice_light: vector(2.0 * light), halfway: vector(light + eye) }
    }

    #[inline(always)]
    fn of(&self, n: Vector<T>) -> Vector<T> {
        difference(scaled(dot(n, self.twice_light), n), self.halfway)
    }
}

/// D = H × N [methods B13].
#[derive(Clone, Copy, Debug)]
pub struct Cross<T>(Vector<T>);

impl<T: Number> DifferenceVector<T> for Cross<T> {
    const FACTOR: u32 = 1;

    fn new(light: DVec3, eye: DVec3) -> Self {
        Cross(vector(light + eye))
    }

    #[inline(always)]
    fn of(&self, n: Vector<T>) -> Vector<T> {
        let h = self.0;
        [h[1] * n[2] - h[2] * n[1], h[2] * n[0] - h[0] * n[2], h[0] * n[1] - h[1] * n[0]]
    }
}

/// A kind of half-way vector.
pub trait Halfway: Copy {
    /// The factor of n that goes with D·D.
    const FACTOR: u32;

    /// The half-way vector of L and V, from their sum.
    fn of(sum: DVec3) -> DVec3;
}

/// H = L + V.
#[derive(Clone, Copy, Debug)]
pub struct Sum;

impl Halfway for Sum {
    const FACTOR: u32 = 1;

    fn of(sum: DVec3) -> DVec3 {
        sum
    }
}

/// H* = H/|H|; 0 where L = -V.
#[derive(Clone, Copy, Debug)]
pub struct Unit;

impl Halfway for Unit {
    const FACTOR: u32 = 4;

    fn of(sum: DVec3) -> DVec3 {
        unit(sum).unwrap_or(DVec3::ZERO)
    }
}

/// h = (L + V)/2, not normalised.
#[derive(Clone, Copy, Debug)]
pub struct Half;

impl Halfway for Half {
    const FACTOR: u32 = 4;

    fn of(sum: DVec3) -> DVec3 {
        sum / 2.0
    }
}

/// h1 = h g2(h·h).
#[derive(Clone, Copy, Debug)]
pub struct HalfG2;

impl Halfway for HalfG2 {
    const FACTOR: u32 = 4;

    fn of(sum: DVec3) -> DVec3 {
        let h = Half::of(sum);
        g2(h.length_squared()) * h
    }
}

/// D = (h·N)N - h: D3, and rows 7 to 9 of figure 9.
#[derive(Clone, Copy, Debug)]
pub struct ToProjection<T, H>(Vector<T>, PhantomData<H>);

impl<T: Number, H: Halfway> DifferenceVector<T> for ToProjection<T, H> {
    const FACTOR: u32 = H::FACTOR;

    fn new(light: DVec3, eye: DVec3) -> Self {
        ToProjection(vector(H::of(light + eye)), PhantomData)
    }

    #[inline(always)]
    fn of(&self, n: Vector<T>) -> Vector<T> {
        difference(scaled(dot(n, self.0), n), self.0)
    }
}

/// D = h - N: rows 6 and 10 of figure 9.
#[derive(Clone, Copy, Debug)]
pub struct ToNormal<T, H>(Vector<T>, PhantomData<H>);

impl<T: Number, H: Halfway> DifferenceVector<T> for ToNormal<T, H> {
    const FACTOR: u32 = H::FACTOR;

    fn new(light: DVec3, eye: DVec3) -> Self {
        ToNormal(vector(H::of(light + eye)), PhantomData)
    }

    #[inline(always)]
    fn of(&self, n: Vector<T>) -> Vector<T> {
        difference(self.0, n)
    }
}

/// R - L.
pub type LyonReflection<T, const K: u32> = Lyon<T, Reflected<T>, K>;
/// D2, K = 4.
pub type LyonLightReflection<T> = Lyon<T, LightReflected<T>, 4>;
/// H × N, K = 4.
pub type LyonCross<T> = Lyon<T, Cross<T>, 4>;
/// (h·N)N - h.
pub type LyonProjection<T, H, const K: u32> = Lyon<T, ToProjection<T, H>, K>;
/// h - N, K = 4.
pub type LyonNormal<T, H> = Lyon<T, ToNormal<T, H>, 4>;

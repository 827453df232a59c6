//! Highlights that depend on the angle between N and the half-way vector H*, with N normalised
//! exactly [Lyon, TR 43, appendix, rows 5, 11 and 12].
use glam::DVec3;

use super::differences::{Vector, dot, scaled, vector};
use super::lyon::{Halfway, Unit};
use super::{Line, Number, Pair, Scheme, Walk};

/// N·L and N·H*; H* is 0 where L = -V.
#[derive(Clone, Copy, Debug)]
struct Cosines<T> {
    normal: Walk<T>,
    light: Vector<T>,
    halfway: Vector<T>,
}

impl<T: Number> Cosines<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        Cosines {
            normal: Walk::new(line.ends[0], line.step()),
            light: vector(light),
            halfway: vector(Unit::of(light + line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> [T; 2] {
        let n = self.normal.pixel();
        let n = scaled(T::of(1.0) / dot(n, n).floored().square_root(), n);
        [dot(n, self.light), dot(n, self.halfway)]
    }
}

/// Row 5: (H*·N)^4n.
#[derive(Clone, Copy, Debug)]
pub struct Blinn<T>(Cosines<T>);

impl<T: Number> Scheme<T> for Blinn<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        Blinn(Cosines::new(line, light))
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let [diffuse, base] = self.0.pixel();
        Pair { diffuse, base }
    }

    fn exponent(shininess: u32) -> u32 {
        4 * shininess
    }
}

/// Row 11: exp(-2n α²), whose base is exp(-2α²).
#[derive(Clone, Copy, Debug)]
pub struct TorranceSparrow<T>(Cosines<T>);

impl<T: Number> Scheme<T> for TorranceSparrow<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        TorranceSparrow(Cosines::new(line, light))
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let [diffuse, cosine] = self.0.pixel();
        // Rounding must not make the argument of an arc cosine larger than 1 (extremes row 36).
        let angle = cosine.at_most_one().arc_cosine();
        Pair { diffuse, base: (T::of(-2.0) * angle * angle).exponential() }
    }
}

/// Row 12: (1 + n sin² α)^-2, and (1 + n)^-2 from 90 degrees on.
#[derive(Clone, Copy, Debug)]
pub struct TrowbridgeReitz<T> {
    cosines: Cosines<T>,
    shininess: T,
}

impl<T: Number> Scheme<T> for TrowbridgeReitz<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        TrowbridgeReitz {
            cosines: Cosines::new(line, light),
            shininess: T::of(line.shininess.into()),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let one = T::of(1.0);
        let [diffuse, cosine] = self.cosines.pixel();
        let cosine = cosine.positive().at_most_one();
        Pair { diffuse, base: one / (one + (one - cosine * cosine) * self.shininess) }
    }

    fn exponent(_: u32) -> u32 {
        2
    }
}

//! Duff's scalars along a scan line, and the highlights that go with them [Hast, Barrera and
//! Bengtsson, §1.2, §3, §4.2; methods C2, C3, C8 to C11].
use glam::DVec3;

use super::gouraud::between;
use super::{Line, Linear, Number, Pair, Plane, Scheme, Second};
use crate::exact::formula::diffuse::lambert;
use crate::exact::formula::direct;
use crate::exact::formula::normalisation::unit;
use crate::exact::formula::quadratic::Quadratic;

/// p = N·L and q = N·N [eq. 6 to 8].
#[derive(Clone, Copy, Debug)]
pub struct Duff<T> {
    p: Linear<T>,
    q: Second<T>,
}

impl<T: Number> Duff<T> {
    /// p and q at this pixel; then advances to the next.
    #[inline(always)]
    fn terms(&mut self) -> [T; 2] {
        [self.p.pixel(), self.q.pixel().floored()]
    }
}

/// I_d = p/√q without a highlight.
impl<T: Number> Scheme<T> for Duff<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let (m, k) = (line.ends[0], line.step());
        Duff {
            p: between(line.ends.map(|n| n.dot(light)), line),
            q: Second::new(Quadratic::square(m, k)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let [p, q] = self.terms();
        Pair { diffuse: p / q.square_root(), base: T::of(0.0) }
    }
}

/// The specular numerator 2(N·V)(N·L) - (L·V)(N·N) and q [eq. 18 to 26].
#[derive(Clone, Copy, Debug)]
pub(super) struct Base<T> {
    p: Second<T>,
    q: Second<T>,
}

impl<T: Number> Base<T> {
    #[inline(always)]
    pub(super) fn new(line: &Line, light: DVec3) -> Self {
        let (m, k) = (line.ends[0], line.step());
        let q = Quadratic::square(m, k);
        let p = Quadratic::product(m, k, 2.0 * line.eye, light).plus(-light.dot(line.eye), q);
        Base { p: Second::new(p), q: Second::new(q) }
    }

    #[inline(always)]
    pub(super) fn pixel(&mut self) -> T {
        self.p.pixel() / self.q.pixel().floored()
    }
}

/// Gouraud's diffuse term, and p/q [methods C3].
#[derive(Clone, Copy, Debug)]
pub struct Hybrid<T> {
    diffuse: Linear<T>,
    base: Base<T>,
}

impl<T: Number> Hybrid<T> {
    /// The scheme along a span, from the diffuse intensity there.
    #[inline(always)]
    pub fn of(diffuse: Linear<T>, line: &Line, light: DVec3) -> Self {
        Hybrid { diffuse, base: Base::new(line, light) }
    }
}

impl<T: Number> Scheme<T> for Hybrid<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let diffuse = line.vertices.map(|n| lambert(n, light));
        Hybrid::of(Plane::along(line, diffuse), line, light)
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        Pair { diffuse: self.diffuse.pixel(), base: self.base.pixel() }
    }
}

/// Duff with r = N·H/|H|: s = 1/√q, I_d = ps, I_s = rs, to the power 4n [methods C8].
#[derive(Clone, Copy, Debug)]
pub struct DuffBlinn<T> {
    duff: Duff<T>,
    r: Linear<T>,
}

impl<T: Number> Scheme<T> for DuffBlinn<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        DuffBlinn {
            duff: Duff::new(line, light),
            r: between(line.ends.map(|n| n.dot(unit_halfway(light, line.eye))), line),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let [p, q] = self.duff.terms();
        let s = T::of(1.0) / q.square_root();
        Pair { diffuse: p * s, base: self.r.pixel() * s }
    }

    fn exponent(shininess: u32) -> u32 {
        4 * shininess
    }
}

/// H/|H|, or 0 for L = -V, which gives no highlight (extremes row 12).
pub(super) fn unit_halfway(light: DVec3, eye: DVec3) -> DVec3 {
    unit(light + eye).unwrap_or(DVec3::ZERO)
}

/// Duff with the specular numerator of [`Hybrid`] over the same q [methods C9].
#[derive(Clone, Copy, Debug)]
pub struct DuffHybrid<T> {
    duff: Duff<T>,
    p: Second<T>,
}

impl<T: Number> Scheme<T> for DuffHybrid<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        DuffHybrid { duff: Duff::new(line, light), p: Base::new(line, light).p }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let [p, q] = self.duff.terms();
        Pair { diffuse: p / q.square_root(), base: self.p.pixel() / q }
    }
}

/// Duff with r = 2N·V: base r(p/q) - L·V [eq. 33; methods C10].
#[derive(Clone, Copy, Debug)]
pub struct DuffQuotient<T> {
    duff: Duff<T>,
    r: Linear<T>,
    light_eye: T,
}

impl<T: Number> Scheme<T> for DuffQuotient<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        DuffQuotient {
            duff: Duff::new(line, light),
            r: twice_eye(line),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let [p, q] = self.duff.terms();
        Pair { diffuse: p / q.square_root(), base: self.r.pixel() * (p / q) - self.light_eye }
    }
}

/// Duff with s = 1/√q and r = 2N·V: base (rs)(ps) - L·V [eq. 34; methods C11].
#[derive(Clone, Copy, Debug)]
pub struct DuffRoot<T> {
    duff: Duff<T>,
    r: Linear<T>,
    light_eye: T,
}

impl<T: Number> Scheme<T> for DuffRoot<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        DuffRoot {
            duff: Duff::new(line, light),
            r: twice_eye(line),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let [p, q] = self.duff.terms();
        let s = T::of(1.0) / q.square_root();
        let diffuse = p * s;
        Pair { diffuse, base: (self.r.pixel() * s) * diffuse - self.light_eye }
    }
}

fn twice_eye<T: Number>(line: &Line) -> Linear<T> {
    between(line.ends.map(|n| 2.0 * n.dot(line.eye)), line)
}

/// [`DuffRoot`] with q = q0 + t(q1 - q0) - κ t(1-t) from t, without second differences, which
/// accumulate errors [numerics N3b].
#[derive(Clone, Copy, Debug)]
pub struct Direct<T> {
    t: Linear<T>,
    p: [T; 2],
    r: [T; 2],
    q: [T; 2],
    kappa: T,
    light_eye: T,
}

impl<T: Number> Scheme<T> for Direct<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let lerp = |along: DVec3| {
            [line.ends[0].dot(along), (line.ends[1] - line.ends[0]).dot(along)].map(T::of)
        };
        let [q0, q1] = line.ends.map(DVec3::length_squared);
        Direct {
            t: Linear::new(0.0, line.per_step()),
            p: lerp(light),
            r: lerp(2.0 * line.eye),
            q: [q0, q1 - q0].map(T::of),
            kappa: T::of(direct::kappa(line.ends)),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let t = self.t.pixel();
        let [p, r, chord] = [self.p, self.r, self.q].map(|[start, step]| start + t * step);
        let q = (chord - self.kappa * (t * (T::of(1.0) - t))).floored();
        let s = T::of(1.0) / q.square_root();
        let diffuse = p * s;
        Pair { diffuse, base: (r * s) * diffuse - self.light_eye }
    }
}

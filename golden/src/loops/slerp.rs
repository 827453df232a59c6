//! J = L·N and K = V·N along an arc [lecture, eq. 4.9 to 4.12; methods A10 to A12].
//!
//! The caller checks [`slerp::angle`](crate::exact::formula::slerp::angle) first; without an angle the arc
//! is that of [`Phong`](super::Phong).
use glam::DVec3;

use super::{Line, Number, Pair, Scheme};
use crate::exact::formula::slerp::{angle, tangent};

/// sin and cos of an angle that grows by δ a pixel: four multiplications and two additions.
#[derive(Clone, Copy, Debug)]
struct Rotation<T> {
    sine: T,
    cosine: T,
    step_sine: T,
    step_cosine: T,
}

impl<T: Number> Rotation<T> {
    fn new(start: f64, step: f64) -> Self {
        let [sine, cosine] = [start.sin(), start.cos()].map(T::of);
        let [step_sine, step_cosine] = [step.sin(), step.cos()].map(T::of);
        Rotation { sine, cosine, step_sine, step_cosine }
    }

    /// [sin, cos] at this pixel; then advances to the next.
    #[inline(always)]
    fn pixel(&mut self) -> [T; 2] {
        let here = [self.sine, self.cosine];
        self.sine = here[0] * self.step_cosine + here[1] * self.step_sine;
        self.cosine = here[1] * self.step_cosine - here[0] * self.step_sine;
        here
    }
}

/// The angle φ, or 0 where slerp cannot be used.
fn arc(line: &Line) -> f64 {
    angle(line.unit_ends()).unwrap_or(0.0)
}

/// Two rotations, for tφ and (1-t)φ; 1/sin φ is part of the four end products.
#[derive(Clone, Copy, Debug)]
pub struct Slerp<T> {
    rising: Rotation<T>,
    falling: Rotation<T>,
    /// L·N0 and L·N1, divided by sin φ.
    j: [T; 2],
    /// 2V·N0 and 2V·N1, divided by sin φ.
    twice_k: [T; 2],
    light_eye: T,
}

impl<T: Number> Scheme<T> for Slerp<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let angle = arc(line);
        let step = angle * line.per_step();
        let products =
            |v: DVec3| line.unit_ends().map(|n| T::of(n.dot(v) / angle.sin().max(f64::EPSILON)));
        Slerp {
            rising: Rotation::new(0.0, step),
            // (1-t)φ falls: eq. 4.10 and 4.12 are a rotation by -δ.
            falling: Rotation::new(angle, -step),
            j: products(light),
            twice_k: products(2.0 * line.eye),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let ([after, _], [before, _]) = (self.rising.pixel(), self.falling.pixel());
        let [j, twice_k] = [self.j, self.twice_k].map(|ends| before * ends[0] + after * ends[1]);
        Pair { diffuse: j, base: twice_k * j - self.light_eye }
    }
}

/// One rotation in the frame of N0 and T: N = cos(tφ) N0 + sin(tφ) T [methods A11].
#[derive(Clone, Copy, Debug)]
pub struct FrameSlerp<T> {
    rotation: Rotation<T>,
    j: [T; 2],
    twice_k: [T; 2],
    light_eye: T,
}

impl<T: Number> Scheme<T> for FrameSlerp<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let ends = line.unit_ends();
        let axes = [ends[0], tangent(ends).unwrap_or(DVec3::ZERO)];
        FrameSlerp {
            rotation: Rotation::new(0.0, arc(line) * line.per_step()),
            j: axes.map(|a| T::of(a.dot(light))),
            twice_k: axes.map(|a| T::of(2.0 * a.dot(line.eye))),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let [sine, cosine] = self.rotation.pixel();
        let [j, twice_k] = [self.j, self.twice_k].map(|axes| cosine * axes[0] + sine * axes[1]);
        Pair { diffuse: j, base: twice_k * j - self.light_eye }
    }
}

/// J' = 2cos(δ) J - J_before: one multiplication and one subtraction, with an error that grows with
/// S² [Barrera; methods A12].
#[derive(Clone, Copy, Debug)]
struct Harmonic<T> {
    before: T,
    here: T,
    twice_cosine: T,
}

impl<T: Number> Harmonic<T> {
    fn new(value: f64, quarter_on: f64, step: f64) -> Self {
        let at = |i: f64| T::of(value * (i * step).cos() + quarter_on * (i * step).sin());
        Harmonic { before: at(-1.0), here: at(0.0), twice_cosine: T::of(2.0 * step.cos()) }
    }

    #[inline(always)]
    fn pixel(&mut self) -> T {
        let here = self.here;
        self.here = self.twice_cosine * here - self.before;
        self.before = here;
        here
    }
}

/// J and K by Chebyshev's recurrence.
#[derive(Clone, Copy, Debug)]
pub struct Chebyshev<T> {
    j: Harmonic<T>,
    twice_k: Harmonic<T>,
    light_eye: T,
}

impl<T: Number> Scheme<T> for Chebyshev<T> {
    fn new(line: &Line, light: DVec3) -> Self {
        let (ends, step) = (line.unit_ends(), arc(line) * line.per_step());
        let across = tangent(ends).unwrap_or(DVec3::ZERO);
        let harmonic = |v: DVec3| Harmonic::new(ends[0].dot(v), across.dot(v), step);
        Chebyshev {
            j: harmonic(light),
            twice_k: harmonic(2.0 * line.eye),
            light_eye: T::of(light.dot(line.eye)),
        }
    }

    #[inline(always)]
    fn pixel(&mut self) -> Pair<T> {
        let (j, twice_k) = (self.j.pixel(), self.twice_k.pixel());
        Pair { diffuse: j, base: twice_k * j - self.light_eye }
    }
}

//! Polynomials by forward differences, and vectors by additions.
use glam::DVec3;

use super::Number;
use crate::exact::formula::quadratic::Quadratic;

/// A linear function: one addition a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Linear<T> {
    value: T,
    step: T,
}

impl<T: Number> Linear<T> {
    /// The function that is `value` at x = 0 and grows by `step`.
    pub fn new(value: f64, step: f64) -> Self {
        Linear { value: T::of(value), step: T::of(step) }
    }

    /// The value at this pixel; then advances to the next.
    #[inline(always)]
    pub fn pixel(&mut self) -> T {
        let here = self.value;
        self.value = self.value + self.step;
        here
    }
}

/// A quadratic function: two additions a pixel [Hast, Barrera and Bengtsson, eq. 7 and 8].
#[derive(Clone, Copy, Debug)]
pub struct Second<T> {
    value: T,
    first: T,
    second: T,
}

impl<T: Number> Second<T> {
    /// The function from x = 0 on.
    pub fn new(quadratic: Quadratic) -> Self {
        let [value, first, second] = quadratic.differences().map(T::of);
        Second { value, first, second }
    }

    /// The value at this pixel; then advances to the next.
    #[inline(always)]
    pub fn pixel(&mut self) -> T {
        let here = self.value;
        self.value = self.value + self.first;
        self.first = self.first + self.second;
        here
    }
}

/// A vector with three components.
pub type Vector<T> = [T; 3];

/// A vector as a constant of the loop. It does not use an array's `map`, which goes through memory
/// and takes longer than an intensity.
// An array's `map` goes through memory, which takes longer than an intensity.
#[inline(always)]
pub fn vector<T: Number>(v: DVec3) -> Vector<T> {
    [T::of(v.x), T::of(v.y), T::of(v.z)]
}

/// a·b: three multiplications and two additions.
#[inline(always)]
pub fn dot<T: Number>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// s v.
#[inline(always)]
pub fn scaled<T: Number>(s: T, v: Vector<T>) -> Vector<T> {
    [s * v[0], s * v[1], s * v[2]]
}

/// a + b.
#[inline(always)]
pub fn sum<T: Number>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// a - b.
#[inline(always)]
pub fn difference<T: Number>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// A vector that grows by three additions a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Walk<T> {
    value: Vector<T>,
    step: Vector<T>,
}

impl<T: Number> Walk<T> {
    /// The vector that is `value` at first and grows by `step`.
    pub fn new(value: DVec3, step: DVec3) -> Self {
        Walk { value: vector(value), step: vector(step) }
    }

    /// The vector at this pixel; then advances to the next.
    #[inline(always)]
    pub fn pixel(&mut self) -> Vector<T> {
        let here = self.value;
        self.value = sum(self.value, self.step);
        here
    }
}

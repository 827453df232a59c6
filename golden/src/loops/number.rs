//! The numbers of a recurrence: f32 for speed, f64 for exactness, [`Counted`](super::Counted) for
//! counting.
use std::ops::{Add, Div, Mul, Sub};

/// Arithmetic as the papers count it. They do not count comparisons, doublings and halvings
/// (shifts), which have names of their own here; functions that occur in none of their tables are
/// not counted either.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The least value of a squared length: it keeps quotients finite where a normal vanishes.
    const LEAST: f64;

    /// A constant, rounded to the type.
    fn of(value: f64) -> Self;

    /// √x.
    fn square_root(self) -> Self;

    /// x/2.
    fn halved(self) -> Self;

    /// x, or [`LEAST`](Self::LEAST) if that is more.
    fn floored(self) -> Self;

    /// x, or 0 if that is more.
    fn positive(self) -> Self;

    /// x, or 1 if that is less.
    fn at_most_one(self) -> Self;

    /// x, or 0 where `sign` is not above 0.
    fn where_positive(self, sign: Self) -> Self;

    /// sin x.
    fn sine(self) -> Self;

    /// The angle from 0 to π whose cosine is x.
    fn arc_cosine(self) -> Self;

    /// e^x.
    fn exponential(self) -> Self;
}

macro_rules! float {
    ($float:ident) => {
        impl Number for $float {
            const LEAST: f64 = $float::EPSILON as f64;

            #[inline(always)]
            fn of(value: f64) -> Self {
                value as $float
            }

            #[inline(always)]
            fn square_root(self) -> Self {
                self.sqrt()
            }

            #[inline(always)]
            fn halved(self) -> Self {
                self * 0.5
            }

            #[inline(always)]
            fn floored(self) -> Self {
                self.max(Self::LEAST as $float)
            }

            #[inline(always)]
            fn positive(self) -> Self {
                self.max(0.0)
            }

            #[inline(always)]
            fn at_most_one(self) -> Self {
                self.min(1.0)
            }

            #[inline(always)]
            fn where_positive(self, sign: Self) -> Self {
                if sign > 0.0 { self } else { 0.0 }
            }

            #[inline(always)]
            fn sine(self) -> Self {
                self.sin()
            }

            #[inline(always)]
            fn arc_cosine(self) -> Self {
                self.acos()
            }

            #[inline(always)]
            fn exponential(self) -> Self {
                self.exp()
            }
        }
    };
}

float!(f32);
float!(f64);

/// x^n by squaring; 1 for n = 0.
#[inline(always)]
pub fn power<T: Number>(mut x: T, mut n: u32) -> T {
    let mut result = T::of(1.0);
    while n > 0 {
        if n & 1 == 1 {
            result = result * x;
        }
        x = x * x;
        n >>= 1;
    }
    result
}

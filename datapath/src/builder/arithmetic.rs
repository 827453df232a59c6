//! Sums, differences and products: exact, as wide as their range needs.
use std::ops::{Add, Mul, Neg, Sub};

use super::Sig;
use crate::design::Op;

impl Sig {
    /// The two values with the binary point in the same place.
    fn same_point(&self, other: &Sig) -> (Sig, Sig) {
        let fraction_bits = self.fraction_bits().max(other.fraction_bits());
        (self.with_fraction_bits(fraction_bits), other.with_fraction_bits(fraction_bits))
    }

    fn plus(&self, other: &Sig) -> Sig {
        let (a, b) = self.same_point(other);
        let facts = (a.range().plus(b.range()), a.fraction_bits(), a.error() + b.error());
        Sig::operator([&a, &b], |[a, b]| Op::Add(a, b), facts, "sum")
    }

    fn minus(&self, other: &Sig) -> Sig {
        let (a, b) = self.same_point(other);
        let facts = (a.range().minus(b.range()), a.fraction_bits(), a.error() + b.error());
        Sig::operator([&a, &b], |[a, b]| Op::Sub(a, b), facts, "difference")
    }

    /// |ab - a'b'| ≤ |a| e_b + |b| e_a + e_a e_b.
    fn times(&self, other: &Sig) -> Sig {
        let (ea, eb) = (self.error(), other.error());
        let error = self.range().magnitude() * eb + other.range().magnitude() * ea + ea * eb;
        let facts = (
            self.range().times(other.range()),
            self.fraction_bits() + other.fraction_bits(),
            error,
        );
        Sig::operator([self, other], |[a, b]| Op::Mul(a, b), facts, "product")
    }

    /// The value times itself, which is never negative.
    pub fn squared(&self) -> Sig {
        let error = (2.0 * self.range().magnitude() + self.error()) * self.error();
        let facts = (self.range().squared(), 2 * self.fraction_bits(), error);
        Sig::operator([self], |[a]| Op::Mul(a, a), facts, "product")
    }
}

macro_rules! operator_on_values_and_references {
    ($($trait:ident, $method:ident, $does:ident;)*) => { $(
        impl $trait for &Sig {
            type Output = Sig;
            fn $method(self, other: &Sig) -> Sig { Sig::$does(self, other) }
        }
        impl $trait<Sig> for &Sig {
            type Output = Sig;
            fn $method(self, other: Sig) -> Sig { Sig::$does(self, &other) }
        }
        impl $trait<&Sig> for Sig {
            type Output = Sig;
            fn $method(self, other: &Sig) -> Sig { Sig::$does(&self, other) }
        }
        impl $trait for Sig {
            type Output = Sig;
            fn $method(self, other: Sig) -> Sig { Sig::$does(&self, &other) }
        }
    )* };
}

operator_on_values_and_references! {
    Add, add, plus;
    Sub, sub, minus;
    Mul, mul, times;
}

impl Neg for &Sig {
    type Output = Sig;
    fn neg(self) -> Sig {
        self.builder.integer(0) - self
    }
}

impl Neg for Sig {
    type Output = Sig;
    fn neg(self) -> Sig {
        -&self
    }
}

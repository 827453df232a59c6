//! Sums, differences and products: exact, as wide as their range needs.
use std::ops::{Add, Mul, Neg, Sub};

use super::Sig;
use crate::design::Op;
use crate::graph::Rule;

impl Sig {
    /// The two values with the binary point in the same place.
    fn same_point(&self, other: &Sig) -> (Sig, Sig) {
        let fraction_bits = self.fraction_bits().max(other.fraction_bits());
        (self.with_fraction_bits(fraction_bits), other.with_fraction_bits(fraction_bits))
    }

    fn plus(&self, other: &Sig) -> Sig {
        let (a, b) = self.same_point(other);
        let shape = (a.range().plus(b.range()), a.fraction_bits());
        let rule = Rule::Sum(self.real(), other.real());
        Sig::operator([&a, &b], |[a, b]| Op::Add(a, b), shape, ("sum", rule))
    }

    fn minus(&self, other: &Sig) -> Sig {
        let (a, b) = self.same_point(other);
        let shape = (a.range().minus(b.range()), a.fraction_bits());
        let rule = Rule::Difference(self.real(), other.real());
        Sig::operator([&a, &b], |[a, b]| Op::Sub(a, b), shape, ("difference", rule))
    }

    fn times(&self, other: &Sig) -> Sig {
        let shape =
            (self.range().times(other.range()), self.fraction_bits() + other.fraction_bits());
        let rule = Rule::Product(self.real(), other.real());
        Sig::operator([self, other], |[a, b]| Op::Mul(a, b), shape, ("product", rule))
    }

    /// The value times itself, which is never negative.
    pub fn squared(&self) -> Sig {
        let shape = (self.range().squared(), 2 * self.fraction_bits());
        let rule = Rule::Square(self.real());
        Sig::operator([self], |[a]| Op::Mul(a, a), shape, ("product", rule))
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

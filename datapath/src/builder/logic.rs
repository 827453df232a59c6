//! Comparisons, bits and choices.
use super::Sig;
use crate::design::{Op, Range, WideRange};
use crate::graph::Rule;

const BIT: Range = Range::new(0, 1);

fn bit() -> (WideRange, u32) {
    (BIT.into(), 0)
}

impl Sig {
    /// The bit `self < other`.
    pub fn less_than(&self, other: &Sig) -> Sig {
        let fraction_bits = self.fraction_bits().max(other.fraction_bits());
        let (a, b) =
            (self.with_fraction_bits(fraction_bits), other.with_fraction_bits(fraction_bits));
        match (a.range(), b.range()) {
            (x, y) if x.high < y.low => self.builder.integer(1),
            (x, y) if y.high <= x.low => self.builder.integer(0),
            _ => Sig::operator([&a, &b], |[a, b]| Op::LessThan(a, b), bit(), ("less", Rule::Exact)),
        }
    }

    /// The bit `self ≥ other`.
    pub fn at_least(&self, other: &Sig) -> Sig {
        self.less_than(other).not()
    }

    /// The opposite of a bit.
    pub fn not(&self) -> Sig {
        Sig::operator([self], |[a]| Op::Not(a), bit(), ("not", Rule::Exact))
    }

    /// Both bits.
    pub fn and(&self, other: &Sig) -> Sig {
        Sig::operator([self, other], |[a, b]| Op::And(a, b), bit(), ("both", Rule::Exact))
    }

    /// Either bit.
    pub fn or(&self, other: &Sig) -> Sig {
        Sig::operator([self, other], |[a, b]| Op::Or(a, b), bit(), ("either", Rule::Exact))
    }

    /// This number of bits with `bit` put behind it on the right: twice the number and the bit,
    /// without an adder.
    pub fn with_bit(&self, bit: &Sig) -> Sig {
        let doubled = self.times_power_of_two(1);
        let range = doubled.range().plus(BIT);
        Sig::operator([&doubled, bit], |[a, b]| Op::Or(a, b), (range, 0), ("appended", Rule::Exact))
    }

    /// `yes` where this bit is 1, else `no`.
    ///
    /// The bound is the larger of the two, also where this bit is always the same: it holds where
    /// the real value takes the same branch, or the branches meet.
    pub fn choose(&self, yes: &Sig, no: &Sig) -> Sig {
        let fraction_bits = yes.fraction_bits().max(no.fraction_bits());
        let (a, b) = (yes.with_fraction_bits(fraction_bits), no.with_fraction_bits(fraction_bits));
        let range = a.range().hull(b.range()).into();
        let rule = Rule::Choice(yes.real(), no.real());
        let select = |[c, a, b]: [_; 3]| Op::Select(c, a, b);
        Sig::operator([self, &a, &b], select, (range, fraction_bits), ("chosen", rule))
    }
}

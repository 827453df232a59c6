//! Comparisons, bits and choices.
use super::Sig;
use crate::bound::ErrorModel;
use crate::design::{Op, Range, WideRange};

const BIT: Range = Range::new(0, 1);

fn bit() -> (WideRange, u32, f64) {
    (BIT.into(), 0, 0.0)
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
            _ => Sig::operator([&a, &b], |[a, b]| Op::LessThan(a, b), bit(), "less"),
        }
    }

    /// The bit `self ≥ other`.
    pub fn at_least(&self, other: &Sig) -> Sig {
        self.less_than(other).not()
    }

    /// The opposite of a bit.
    pub fn not(&self) -> Sig {
        Sig::operator([self], |[a]| Op::Not(a), bit(), "not")
    }

    /// Both bits.
    pub fn and(&self, other: &Sig) -> Sig {
        Sig::operator([self, other], |[a, b]| Op::And(a, b), bit(), "both")
    }

    /// Either bit.
    pub fn or(&self, other: &Sig) -> Sig {
        Sig::operator([self, other], |[a, b]| Op::Or(a, b), bit(), "either")
    }

    /// This number of bits with `bit` put behind it on the right: twice the number and the bit,
    /// without an adder.
    pub fn with_bit(&self, bit: &Sig) -> Sig {
        let doubled = self.times_power_of_two(1);
        let range = doubled.range().plus(BIT);
        Sig::operator([&doubled, bit], |[a, b]| Op::Or(a, b), (range, 0, 0.0), "appended")
    }

    /// `yes` where this bit is 1, else `no`.
    ///
    /// The bound is the larger of the two, also where this bit is always the same: it holds where
    /// the real value takes the same branch, or the branches meet. What is known of an error beside
    /// that is still true where the other branch is 0 exactly.
    pub fn choose(&self, yes: &Sig, no: &Sig) -> Sig {
        let fraction_bits = yes.fraction_bits().max(no.fraction_bits());
        let (a, b) = (yes.with_fraction_bits(fraction_bits), no.with_fraction_bits(fraction_bits));
        let range = a.range().hull(b.range()).into();
        let facts = (range, fraction_bits, a.error().max(b.error()));
        let zero = |sig: &Sig| sig.range().only() == Some(0) && sig.error() == 0.0;
        let form = match (zero(&a), zero(&b)) {
            (false, true) => yes.error_model(),
            (true, false) => no.error_model(),
            _ => ErrorModel::Bounded,
        };
        let chosen =
            Sig::operator([self, &a, &b], |[c, a, b]| Op::Select(c, a, b), facts, "chosen");
        chosen.of_error_model(form).with_real(a.real().or(b.real()))
    }
}

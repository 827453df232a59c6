//! Narrowing: always explicit, always named in the spec.
use super::Sig;
use super::state::SignalInfo;
use crate::design::{Assumption, Op, Range};
use crate::graph::{Pace, Rule};

impl Sig {
    /// Nearest value with `fraction_bits` bits right of the point, ties up; off by half a unit of
    /// the new last place at most.
    pub fn rounded(&self, fraction_bits: u32) -> Sig {
        match self.fraction_bits().saturating_sub(fraction_bits) {
            0 => self.clone(),
            // floor((x + 2^(d-1)) / 2^d) = floor((floor(x / 2^(d-1)) + 1) / 2): the adder need not
            // see the bits that go.
            _ => {
                let rounded = self
                    .shortened(fraction_bits + 1, "kept")
                    .plus_one_ulp()
                    .shortened(fraction_bits, "rounded");
                rounded.standing_for(rounded.id(), Rule::Rounded(self.real()))
            }
        }
    }

    /// Largest value not above it with `fraction_bits` bits right of the point; off by less than a
    /// unit of the new last place.
    pub fn truncated(&self, fraction_bits: u32) -> Sig {
        self.shortened(fraction_bits, "truncated")
    }

    /// The last `bits` bits, read as an unsigned number: what is left of it modulo 2^`bits` units
    /// of the last place.
    pub fn low_bits(&self, bits: u32) -> Sig {
        if bits == 0 {
            return self.builder.constant(0, self.fraction_bits(), Rule::Remainder(self.real()));
        }
        let range = Range::whole(bits, false);
        if self.range().hull(range) == range {
            return self.clone();
        }
        self.wired(Op::Wrap(self.id()), range, "low", Rule::Remainder(self.real()))
    }

    /// The raw value as an integer: the binary point moves behind the last place.
    pub fn raw(&self) -> Sig {
        self.times_power_of_two(self.fraction_bits() as i32)
    }

    /// One unit in the last place more.
    fn plus_one_ulp(&self) -> Sig {
        let one = self.builder.integer(1).times_power_of_two(-(self.fraction_bits() as i32));
        let shape = (self.range().plus(one.range()), self.fraction_bits());
        let rule = Rule::Sum(self.real(), one.real());
        Sig::operator([self, &one], |[a, b]| Op::Add(a, b), shape, ("rounding", rule))
    }

    fn shortened(&self, fraction_bits: u32, kind: &'static str) -> Sig {
        let dropped = self.fraction_bits().saturating_sub(fraction_bits);
        if dropped == 0 {
            return self.clone();
        }
        let constant = self.builder.state.borrow().is_constant(self.id());
        let range = self.range().shifted_right(dropped);
        let rule = Rule::Truncated(self.real());
        if let Some(value) = constant {
            return self.builder.constant(value >> dropped, fraction_bits, rule);
        }
        let info = SignalInfo { range: range.into(), fraction_bits, kind };
        self.builder.emit(Op::ShiftRight(self.id(), dropped), Pace::Wire, info, rule)
    }

    /// The value, or 0 where it is negative.
    pub fn at_least_zero(&self) -> Sig {
        self.clamped_below(0)
    }

    /// The value, or the integer `low` where it is smaller. Clamping brings fixed and real no
    /// further apart.
    pub fn clamped_below(&self, low: i64) -> Sig {
        let (limit, rule) = (self.limit(low), Rule::ClampedBelow(self.real(), low as f64));
        if limit <= self.range().low {
            return self.standing_for(self.id(), rule);
        }
        let low = self.builder.integer(low);
        let range = Range::new(limit, self.range().high.max(limit));
        self.less_than(&low).choose(&low, self).known_within(range, rule)
    }

    /// The value, or the integer `high` where it is larger. Clamping brings fixed and real no
    /// further apart.
    pub fn clamped_above(&self, high: i64) -> Sig {
        let (limit, rule) = (self.limit(high), Rule::ClampedAbove(self.real(), high as f64));
        if self.range().high <= limit {
            return self.standing_for(self.id(), rule);
        }
        let high = self.builder.integer(high);
        let range = Range::new(self.range().low.min(limit), limit);
        high.less_than(self).choose(&high, self).known_within(range, rule)
    }

    /// The value without its sign. Fixed and real come no further apart.
    pub fn absolute(&self) -> Sig {
        let (range, rule) = (self.range(), Rule::Absolute(self.real()));
        if range.low >= 0 {
            return self.standing_for(self.id(), rule);
        }
        let negative = self.less_than(&self.builder.integer(0));
        let largest = range.high.max(-range.low);
        negative.choose(&-self, self).known_within(Range::new(0, largest), rule)
    }

    fn limit(&self, integer: i64) -> i64 {
        integer << self.fraction_bits()
    }

    /// After a clamp: the range that the clamp leaves, which the hull of its branches does not
    /// show.
    fn known_within(self, range: Range, rule: Rule) -> Sig {
        if self.range() == range {
            self.standing_for(self.id(), rule)
        } else {
            self.wired(Op::Wrap(self.id()), range, "clamped", rule)
        }
    }

    /// States a fact that intervals cannot see: the value lies from `low` to `high`. The testbench
    /// checks it on every clock.
    ///
    /// The bits that the fact makes superfluous are dropped. The fact is about the fixed value, so
    /// it says nothing of the error.
    pub fn assumed(&self, low: f64, high: f64, fact: &str) -> Sig {
        let raw = |value: f64| value / self.ulp();
        let stated = Range::new(raw(low).floor() as i64, raw(high).ceil() as i64);
        let range = self.range().clamped_to(stated);
        if range == self.range() {
            return self.clone();
        }
        self.builder.state.borrow_mut().graph.assumptions.push(Assumption {
            fact: fact.into(),
            node: self.id(),
            range,
        });
        self.wired(Op::Wrap(self.id()), range, "assumed", Rule::Same(self.real()))
    }
}

//! Narrowing: always explicit, always named in the spec.
use crate::format::power_of_two;

use super::Sig;
use super::real::Real;
use super::state::SignalInfo;
use crate::bound::{Angular, ErrorModel, RelativeBound};
use crate::design::{Assumption, Op, Range};
use crate::graph::Pace;

impl Sig {
    /// Nearest value with `fraction_bits` bits right of the point, ties up; off by half a unit of
    /// the new last place at most.
    pub fn rounded(&self, fraction_bits: u32) -> Sig {
        match self.fraction_bits().saturating_sub(fraction_bits) {
            0 => self.clone(),
            // floor((x + 2^(d-1)) / 2^d) = floor((floor(x / 2^(d-1)) + 1) / 2): the adder need not
            // see the bits that go.
            dropped => {
                let error = self.error() * power_of_two(-i64::from(dropped)) + 0.5;
                let rounded = self
                    .shortened(fraction_bits + 1, "kept")
                    .plus_one_ulp()
                    .shortened(fraction_bits, "rounded");
                rounded
                    .with_error(error)
                    .with_real(self.real().scaled(power_of_two(-i64::from(dropped))))
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
            return self.builder.constant(0, self.fraction_bits(), self.error());
        }
        let range = Range::whole(bits, false);
        if self.range().hull(range) == range {
            return self.clone();
        }
        let facts = SignalInfo {
            range: range.into(),
            fraction_bits: self.fraction_bits(),
            error: self.error(),
            kind: "low",
        };
        self.builder.emit(Op::Wrap(self.id()), Pace::Wire, facts)
    }

    /// The raw value as an integer: the binary point moves behind the last place.
    pub fn raw(&self) -> Sig {
        self.times_power_of_two(self.fraction_bits() as i32)
    }

    /// One unit in the last place more.
    fn plus_one_ulp(&self) -> Sig {
        let one = self.builder.integer(1).times_power_of_two(-(self.fraction_bits() as i32));
        let facts = (self.range().plus(one.range()), self.fraction_bits(), self.error());
        Sig::operator([self, &one], |[a, b]| Op::Add(a, b), facts, "rounding")
    }

    fn shortened(&self, fraction_bits: u32, kind: &'static str) -> Sig {
        let dropped = self.fraction_bits().saturating_sub(fraction_bits);
        if dropped == 0 {
            return self.clone();
        }
        let constant = self.builder.state.borrow().is_constant(self.id());
        let range = self.range().shifted_right(dropped);
        let error = self.error() * power_of_two(-i64::from(dropped)) + 1.0;
        if let Some(value) = constant {
            return self.builder.constant(value >> dropped, fraction_bits, error);
        }
        let facts = SignalInfo { range: range.into(), fraction_bits, error, kind };
        self.builder.emit(Op::ShiftRight(self.id(), dropped), Pace::Wire, facts)
    }

    /// The value, or 0 where it is negative.
    pub fn at_least_zero(&self) -> Sig {
        self.clamped_below(0)
    }

    /// The value, or the integer `low` where it is smaller. Clamping brings fixed and real no
    /// further apart.
    pub fn clamped_below(&self, low: i64) -> Sig {
        let limit = self.limit(low);
        let real = self.real().clamped_below(limit as f64);
        if limit <= self.range().low {
            return self.clone().known_real(real);
        }
        let low = self.builder.integer(low);
        let range = Range::new(limit, self.range().high.max(limit));
        self.less_than(&low).choose(&low, self).known_within(range, self.error()).known_real(real)
    }

    /// The value, or the integer `high` where it is larger. Clamping brings fixed and real no
    /// further apart.
    pub fn clamped_above(&self, high: i64) -> Sig {
        let limit = self.limit(high);
        let real = self.real().clamped_above(limit as f64);
        if self.range().high <= limit {
            return self.clone().known_real(real);
        }
        let high = self.builder.integer(high);
        let range = Range::new(self.range().low.min(limit), limit);
        high.less_than(self).choose(&high, self).known_within(range, self.error()).known_real(real)
    }

    /// The value without its sign. Fixed and real come no further apart.
    pub fn absolute(&self) -> Sig {
        let (range, real) = (self.range(), self.real().absolute());
        if range.low >= 0 {
            return self.clone().with_real(real);
        }
        let negative = self.less_than(&self.builder.integer(0));
        let largest = range.high.max(-range.low);
        negative.choose(&-self, self).known_within(Range::new(0, largest), self.error())
    }

    fn limit(&self, integer: i64) -> i64 {
        integer << self.fraction_bits()
    }

    /// After a clamp: the range that the clamp leaves, which the hull of its branches does not
    /// show.
    fn known_within(self, range: Range, error: f64) -> Sig {
        let facts = SignalInfo {
            range: range.into(),
            fraction_bits: self.fraction_bits(),
            error,
            kind: "clamped",
        };
        if self.range() == range {
            self.with_error(error)
        } else {
            self.builder.emit(Op::Wrap(self.id()), Pace::Wire, facts)
        }
    }

    /// After a clamp of fixed and real value alike: where the real one lies, and so how far both
    /// are apart at most.
    fn known_real(self, real: Real) -> Sig {
        let error = self.error().min(real.furthest_from(self.range()));
        self.with_error(error).with_real(real)
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
        let facts = SignalInfo {
            range: range.into(),
            fraction_bits: self.fraction_bits(),
            error: self.error(),
            kind: "assumed",
        };
        self.builder.emit(Op::Wrap(self.id()), Pace::Wire, facts).with_real(self.real())
    }

    /// States a bound on |fixed - real| that propagation cannot see, in units of the last place.
    /// The unit gives the proof above it.
    pub fn proven_error(self, error: f64) -> Sig {
        let error = error.min(self.error());
        self.with_error(error)
    }

    /// As [`Sig::proven_error`], the bound given as a value.
    pub fn proven_error_value(self, error: f64) -> Sig {
        let in_ulps = error / self.ulp();
        self.proven_error(in_ulps)
    }

    /// States the bound on |fixed - real| of what propagation sees nothing of, such as a number put
    /// together from bits, or a bit that may come out otherwise than the real one. The unit gives
    /// the proof above it.
    pub fn stated_error_value(self, error: f64) -> Sig {
        let in_ulps = error / self.ulp();
        self.with_error(in_ulps).with_real(Real::ANY)
    }

    /// States that in cases which everything known so far leaves out, such as a choice that comes
    /// out otherwise than the real one, it is off by `error` at most. The unit gives the proof.
    pub fn or_off_by(self, error: f64) -> Sig {
        if error == 0.0 {
            return self;
        }
        let form = match self.error_model() {
            ErrorModel::Relative(shares) => ErrorModel::Relative(
                shares.map(|share| RelativeBound { rest: share.rest.max(error), ..share }),
            ),
            ErrorModel::Bounded | ErrorModel::Angular(_) | ErrorModel::Exclusive { .. } => {
                ErrorModel::Bounded
            }
        };
        let most = self.error_value().max(error);
        self.stated_error_value(most).of_error_model(form)
    }

    /// States that it is the cosine of an angle off by `angle`, and off by `rest` beside that; see
    /// [`ErrorModel::Angular`].
    pub fn known_cosine(self, angle: f64, rest: f64) -> Sig {
        if !(angle + rest).is_finite() {
            return self;
        }
        self.proven_error_value(angle + rest)
            .of_error_model(ErrorModel::Angular(Angular { angle, rest }))
    }
}

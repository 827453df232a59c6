//! A value being described.
use crate::Format;
use crate::bound::{Bound, ErrorBound, Interval};
use crate::format::power_of_two;

use super::Builder;
use super::state::SignalInfo;
use crate::design::{NodeId, Op, Range, WideRange, format_of};
use crate::graph::{GroupId, Pace, RealId, Rule};

/// A value being described: its format, its proven range, and what is known of the real value that
/// it stands for.
#[derive(Clone)]
#[must_use = "a value that nothing reads is left out of the design"]
pub struct Sig {
    pub(super) builder: Builder,
    id: NodeId,
    /// Where this reader sees the binary point; doubling and halving move it and cost nothing.
    fraction_bits: u32,
    real: RealId,
}

impl Sig {
    /// The value `id` with the binary point where it counts `fraction_bits`, which stands for a
    /// real value by this rule.
    pub(super) fn new(builder: &Builder, (id, fraction_bits): (NodeId, u32), rule: Rule) -> Sig {
        let real = builder.state.borrow_mut().real(id, fraction_bits, rule);
        Sig { builder: builder.clone(), id, fraction_bits, real }
    }

    /// The same real value, for which another value stands: later, or in another unit.
    pub(super) fn at(&self, id: NodeId) -> Sig {
        self.standing_for(id, Rule::Same(self.real))
    }

    /// A value with this one's binary point.
    pub(super) fn standing_for(&self, id: NodeId, rule: Rule) -> Sig {
        Sig::new(&self.builder, (id, self.fraction_bits), rule)
    }

    /// This value, which stands for a real value by another rule.
    fn by_rule(self, rule: Rule) -> Sig {
        self.standing_for(self.id, rule)
    }

    /// The value in the graph.
    pub fn id(&self) -> NodeId {
        self.id
    }

    /// What it stands for.
    pub fn real(&self) -> RealId {
        self.real
    }

    /// Proven range of its raw values.
    pub fn range(&self) -> Range {
        self.builder.state.borrow().graph.value(self.id).range
    }

    /// Bits right of the binary point.
    pub fn fraction_bits(&self) -> u32 {
        self.fraction_bits
    }

    /// Its format.
    pub fn format(&self) -> Format {
        format_of(self.range(), self.fraction_bits)
    }

    /// Weight of its last place.
    pub fn ulp(&self) -> f64 {
        power_of_two(-i64::from(self.fraction_bits))
    }

    /// What is known of it and of the real value: what a proof is about.
    pub fn bound(&self) -> Bound {
        self.builder.state.borrow().bounds.of(self.real)
    }

    /// Bound on |fixed - real|, in units of the last place.
    pub fn error(&self) -> f64 {
        self.error_value() / self.ulp()
    }

    /// Bound on |fixed - real|, as a value.
    pub fn error_value(&self) -> f64 {
        self.bound().error
    }

    /// States a bound on |fixed - real| that is smaller than what rules say; the smaller one counts.
    /// `proof` is where it stands.
    pub fn tighten_error(self, proof: &'static str, bound: impl Into<ErrorBound>) -> Sig {
        let rule = Rule::Tightened { of: self.real, bound: bound.into(), proof };
        self.by_rule(rule)
    }

    /// States the bound on |fixed - real| where rules see nothing of it, such as in a number that is
    /// put together from bits, or where a bit may come out otherwise than the real one. `proof` is
    /// where it stands.
    pub fn override_error(self, proof: &'static str, bound: impl Into<ErrorBound>) -> Sig {
        let rule = Rule::Overridden { of: self.real, bound: bound.into(), proof };
        self.by_rule(rule)
    }

    /// States that the real value lies in an interval, by a fact that rules cannot see. The fixed
    /// one may leave it by what it is off.
    pub fn real_within(self, real: Interval, fact: &str) -> Sig {
        let rule = Rule::Within { of: self.real, real, fact: fact.to_owned() };
        self.by_rule(rule)
    }

    /// The same value where it stands for the real value of any of `others` as well, which have its
    /// raw values.
    pub(super) fn off_as_any_of(self, others: &[Sig]) -> Sig {
        let all = [self.real].into_iter().chain(others.iter().map(Sig::real)).collect();
        self.by_rule(Rule::AnyOf(all))
    }

    /// Whether it always has the other's value: it is the same signal, or the same constant.
    pub fn is(&self, other: &Sig) -> bool {
        let constant = |sig: &Sig| self.builder.state.borrow().is_constant(sig.id);
        let same = self.id == other.id
            || constant(self).is_some_and(|value| constant(other) == Some(value));
        same && self.fraction_bits == other.fraction_bits
    }

    /// Gives it a name, unless it has one.
    pub fn named(self, name: &str) -> Sig {
        self.builder.state.borrow_mut().name(self.id, name);
        self
    }

    /// Twice the value: the binary point moves.
    pub fn doubled(&self) -> Sig {
        self.times_power_of_two(1)
    }

    /// Half the value: the binary point moves.
    pub fn halved(&self) -> Sig {
        self.times_power_of_two(-1)
    }

    /// The value times 2^`exponent`: the binary point moves, and wires are added only where it
    /// would leave the bits on the right.
    pub fn times_power_of_two(&self, exponent: i32) -> Sig {
        if exponent == 0 {
            return self.clone();
        }
        let fraction_bits = self.fraction_bits as i32 - exponent;
        let id = match u32::try_from(-fraction_bits) {
            Ok(beyond) if beyond > 0 => self.shifted_left(beyond, beyond),
            _ => self.id,
        };
        let point = (id, fraction_bits.max(0) as u32);
        Sig::new(&self.builder, point, Rule::Scaled(self.real, exponent))
    }

    /// The same value with `fraction_bits` or more bits right of the point.
    pub(super) fn with_fraction_bits(&self, fraction_bits: u32) -> Sig {
        match fraction_bits.saturating_sub(self.fraction_bits) {
            0 => self.clone(),
            more => {
                let id = self.shifted_left(more, fraction_bits);
                Sig::new(&self.builder, (id, fraction_bits), Rule::Same(self.real))
            }
        }
    }

    /// Zeros put in at the right, with the binary point where that counts `fraction_bits`.
    fn shifted_left(&self, bits: u32, fraction_bits: u32) -> NodeId {
        let mut state = self.builder.state.borrow_mut();
        if let Some(value) = state.is_constant(self.id) {
            return state.constant(value << bits, fraction_bits);
        }
        let range = state.graph.value(self.id).range.shifted_left(bits);
        let info = SignalInfo { range, fraction_bits, kind: "shifted" };
        state.emit(Op::ShiftLeft(self.id, bits), Pace::Wire, info)
    }

    /// The value as it is where all of a group are there.
    pub(super) fn taken_with(&self, group: GroupId) -> Sig {
        let id = self.builder.state.borrow_mut().meet(self.id, group);
        self.at(id)
    }

    /// An operator on these operands, clocked as operators are at this place.
    pub(super) fn operator<const N: usize>(
        operands: [&Sig; N],
        op: impl Fn([NodeId; N]) -> Op,
        (range, fraction_bits): (WideRange, u32),
        (kind, rule): (&'static str, Rule),
    ) -> Sig {
        let builder = &operands[0].builder;
        let pace = builder.state.borrow().pace;
        let op = op(operands.map(Sig::id));
        builder.emit(op, pace, SignalInfo { range, fraction_bits, kind }, rule)
    }

    /// An operator without a register, the result of which has this value's binary point.
    pub(super) fn wired(
        &self,
        op: Op,
        range: impl Into<WideRange>,
        kind: &'static str,
        rule: Rule,
    ) -> Sig {
        let info = SignalInfo { range: range.into(), fraction_bits: self.fraction_bits, kind };
        self.builder.emit(op, Pace::Wire, info, rule)
    }

    /// This value behind a register.
    pub(super) fn registered(&self, kind: &'static str, rule: Rule) -> Sig {
        let info =
            SignalInfo { range: self.range().into(), fraction_bits: self.fraction_bits, kind };
        self.builder.emit(Op::Copy(self.id), Pace::Register, info, rule)
    }
}

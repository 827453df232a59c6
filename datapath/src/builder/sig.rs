//! A value being described.
use crate::Format;
use crate::format::power_of_two;

use super::Builder;
use super::real::Real;
use super::state::SignalInfo;
use crate::bound::ErrorModel;
use crate::design::{NodeId, Op, Range, WideRange, format_of};
use crate::graph::{GroupId, Pace};

/// A value being described: its format, its proven range and its error bound.
#[derive(Clone)]
#[must_use = "a value that nothing reads is left out of the design"]
pub struct Sig {
    pub(super) builder: Builder,
    id: NodeId,
    /// Where this reader sees the binary point; doubling and halving move it and cost nothing.
    fraction_bits: u32,
    /// Bound on |fixed - real|, in units of the last place.
    error: f64,
    /// What is known of the error beside that, about values.
    error_model: ErrorModel,
    /// What is known of the real value beside that it is near the fixed one.
    real: Real,
}

impl Sig {
    /// The signal `id` with the binary point where it counts `fraction_bits`, off by `error` units
    /// of the last place at most.
    pub(super) fn new(builder: Builder, (id, fraction_bits): (NodeId, u32), error: f64) -> Sig {
        Sig { builder, id, fraction_bits, error, error_model: ErrorModel::Bounded, real: Real::ANY }
    }

    /// The same value as another signal has it: later, or in another unit.
    pub(super) fn at(&self, id: NodeId) -> Sig {
        Sig { id, ..self.clone() }
    }

    /// The value in the graph.
    pub fn id(&self) -> NodeId {
        self.id
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

    /// Bound on |fixed - real|, in units of the last place.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Bound on |fixed - real|, as a value.
    pub fn error_value(&self) -> f64 {
        self.error() * self.ulp()
    }

    /// What is known of its error beside the bound.
    pub fn error_model(&self) -> ErrorModel {
        self.error_model
    }

    /// Where the real value lies, in units of the last place.
    pub(super) fn real(&self) -> Real {
        self.real.and(Real::near(self.range(), self.error))
    }

    /// The same value, off by `error` units of the last place at most; what else is known stays.
    /// No number is no bound.
    pub(super) fn with_error(self, error: f64) -> Sig {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        Sig { error, ..self }
    }

    /// States what is known of its error beside the bound. The unit gives the proof above it.
    pub fn of_error_model(self, error_model: ErrorModel) -> Sig {
        Sig { error_model, ..self }
    }

    /// The same value, the real one of which lies in an interval.
    pub(super) fn with_real(self, real: Real) -> Sig {
        Sig { real, ..self }
    }

    /// The same signal where it stands for the real value of any of `others` as well, which have
    /// its raw values.
    pub(super) fn off_as_any_of(self, others: &[Sig]) -> Sig {
        let error = others.iter().map(Sig::error).fold(self.error, f64::max);
        let real = others.iter().fold(self.real, |real, other| real.or(other.real));
        let alike = others.iter().all(|other| other.error_model == self.error_model);
        let error_model = if alike { self.error_model } else { ErrorModel::Bounded };
        Sig { error, error_model, real, ..self }
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
        if fraction_bits >= 0 {
            // Errors and ranges count in units of the last place, but their form is about values.
            let moved = self.clone().of_error_model(ErrorModel::Bounded);
            return Sig { fraction_bits: fraction_bits as u32, ..moved };
        }
        let whole = Sig { fraction_bits: 0, ..self.clone() };
        let raised = whole.raised_by(fraction_bits.unsigned_abs());
        Sig { fraction_bits: 0, ..raised }
    }

    /// The same value with `fraction_bits` or more bits right of the point.
    pub(super) fn with_fraction_bits(&self, fraction_bits: u32) -> Sig {
        match fraction_bits.saturating_sub(self.fraction_bits) {
            0 => self.clone(),
            more => self.raised_by(more),
        }
    }

    /// Zeros put in at the right: the same value, more fraction bits.
    fn raised_by(&self, bits: u32) -> Sig {
        let facts = SignalInfo {
            range: self.range().shifted_left(bits),
            fraction_bits: self.fraction_bits + bits,
            error: self.error() * power_of_two(bits.into()),
            kind: "shifted",
        };
        let op = Op::ShiftLeft(self.id, bits);
        let constant = self.builder.state.borrow().is_constant(self.id);
        let raised = match constant {
            Some(value) => self.builder.constant(value << bits, facts.fraction_bits, facts.error),
            None => self.builder.emit(op, Pace::Wire, facts),
        };
        raised.with_real(self.real.scaled(power_of_two(bits.into())))
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
        (range, fraction_bits, error): (WideRange, u32, f64),
        kind: &'static str,
    ) -> Sig {
        let builder = &operands[0].builder;
        let pace = builder.state.borrow().pace;
        let op = op(operands.map(Sig::id));
        builder.emit(op, pace, SignalInfo { range, fraction_bits, error, kind })
    }
}

//! Feedback of any kind: values that each pixel makes of those of the pixel before.
use super::state::Facts;
use super::{Builder, Sig};
use crate::design::{Op, Range, Register};

/// What a unit knows of the values of a recurrence.
pub struct Known<'a> {
    /// Where they stay while the span lasts, by a fact that the unit gives a name; behind its last pixel they may wrap.
    pub limits: (f64, f64),
    /// The fact.
    pub fact: &'a str,
    /// Bound on their errors over the whole span, as a value, proven above the unit.
    pub error: f64,
}

impl Builder {
    /// Values that are `starts` at the first pixel of a span (where `first` is 1), and from then on what `next` makes of those of the pixel
    /// before. All of `next` happens between two clocks: a pixel enters with each of them.
    ///
    /// `next` must keep `fraction_bits`.
    pub fn recurrence<const N: usize>(
        &self,
        first: &Sig,
        starts: [&Sig; N],
        fraction_bits: u32,
        known: &Known,
        next: impl FnOnce(&[Sig; N]) -> [Sig; N],
    ) -> [Sig; N] {
        let stage = starts.iter().map(|sig| sig.stage()).fold(first.stage(), u32::max);
        let first = first.aligned(stage);
        let starts = starts.map(|sig| sig.with_fraction_bits(fraction_bits).aligned(stage));
        let raw = |value: f64| value * specula_scene::format::power_of_two(fraction_bits.into());
        let stays = Range::new(raw(known.limits.0).floor() as i64, raw(known.limits.1).ceil() as i64);
        let whole = Range::whole(stays.width(), stays.signed());
        let error = raw(known.error);
        let facts = |range: Range, kind| Facts { range: range.into(), fraction_bits, error, kind };

        let states = starts.each_ref().map(|_| self.feedback_register(whole, fraction_bits, stage));
        let values: [Sig; N] = std::array::from_fn(|k| {
            let select = Op::Select(first.id(), starts[k].id(), self.kept_for_a_pixel(states[k]));
            let value = self.emit(select, Register::None, facts(whole.hull(starts[k].range()), "value"));
            value.assumed(known.limits.0, known.limits.1, known.fact)
        });
        let followers = self.without_registers(|| next(&values));
        for (state, follower) in states.iter().zip(&followers) {
            assert_eq!((follower.stage(), follower.fraction_bits()), (stage, fraction_bits), "a recurrence takes one clock");
            self.state.borrow_mut().design.nodes[state.0 as usize].op = Op::Wrap(follower.id());
        }
        values.map(|value| self.emit(Op::Copy(value.id()), Register::Data, facts(value.range(), "recurrent")))
    }
}

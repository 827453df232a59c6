//! Feedback of any kind: values that each pixel makes of those of the pixel before.
use super::error::BuildError;
use super::{Builder, Sig};
use crate::design::{NodeId, Op, Range};
use crate::graph::{GroupId, Rule};

/// What a unit knows of the values of a recurrence.
pub struct LoopInvariant<'a> {
    /// Where they stay while the span lasts, by a fact that the unit gives a name; behind its last
    /// pixel they may wrap.
    pub limits: (f64, f64),
    /// The fact.
    pub fact: &'a str,
    /// Bound on their errors over the whole span, as a value, proven above the unit.
    pub error: f64,
}

/// What goes round from pixel to pixel: registers that wait for what is to be kept in them.
struct Round<const N: usize> {
    /// The registers.
    states: [NodeId; N],
    /// Their values, or the starts at the first pixel of a span.
    values: [Sig; N],
    fraction_bits: u32,
    /// What is known of the values.
    rule: Rule,
}

impl Builder {
    /// Values that are `starts` at the first pixel of a span (where `first` is 1), and from then on
    /// what `next` makes of those of the pixel before. All of `next` happens between two clocks: a
    /// pixel may enter with each of them. Where none does, the values wait.
    ///
    /// `next` must keep `fraction_bits`.
    pub fn recurrence<const N: usize>(
        &self,
        first: &Sig,
        starts: [&Sig; N],
        fraction_bits: u32,
        invariant: &LoopInvariant,
        next: impl FnOnce(&[Sig; N]) -> [Sig; N],
    ) -> [Sig; N] {
        let together = self.group(starts.into_iter().chain([first]));
        let round = self.round(first, starts, together, fraction_bits, invariant);
        let followers = self.without_registers(|| next(&round.values));
        self.close_round(&round, &followers);
        round.values.each_ref().map(|value| value.registered("recurrent", round.rule.clone()))
    }

    /// Values that `next` makes, at every pixel, of its `operands` and of what it made at the pixel
    /// before; of `starts` where `first` is 1. So what comes out is a pixel ahead of a
    /// [`Builder::recurrence`]. All of `next` happens between two clocks.
    ///
    /// `next` must keep `fraction_bits`.
    pub fn carried<const N: usize, const M: usize>(
        &self,
        first: &Sig,
        (starts, operands): ([&Sig; N], [&Sig; M]),
        fraction_bits: u32,
        invariant: &LoopInvariant,
        next: impl FnOnce(&[Sig; N], &[Sig; M]) -> [Sig; N],
    ) -> [Sig; N] {
        let together = self.group(starts.into_iter().chain(operands).chain([first]));
        let round = self.round(first, starts, together, fraction_bits, invariant);
        let operands = operands.map(|sig| sig.taken_with(together));
        let followers = self.without_registers(|| next(&round.values, &operands));
        let followers = followers.map(|follower| {
            follower.assumed(invariant.limits.0, invariant.limits.1, invariant.fact)
        });
        self.close_round(&round, &followers);
        followers.map(|follower| follower.registered("recurrent", round.rule.clone()))
    }

    fn round<const N: usize>(
        &self,
        first: &Sig,
        starts: [&Sig; N],
        together: GroupId,
        fraction_bits: u32,
        invariant: &LoopInvariant,
    ) -> Round<N> {
        let first = first.taken_with(together);
        let starts = starts.map(|sig| sig.with_fraction_bits(fraction_bits).taken_with(together));
        let raw = |value: f64| value * crate::format::power_of_two(fraction_bits.into());
        let stays = Range::new(
            raw(invariant.limits.0).floor() as i64,
            raw(invariant.limits.1).ceil() as i64,
        );
        let whole = Range::whole(stays.width(), stays.signed());
        let rule = Rule::LoopInvariant { error: invariant.error };

        let states =
            starts.each_ref().map(|_| self.feedback_register(whole, fraction_bits, together));
        let values: [Sig; N] = std::array::from_fn(|k| {
            let select = Op::Select(first.id(), starts[k].id(), self.kept_for_a_pixel(states[k]));
            let range = whole.hull(starts[k].range());
            let value = starts[k].wired(select, range, "value", rule.clone());
            value.assumed(invariant.limits.0, invariant.limits.1, invariant.fact)
        });
        Round { states, values, fraction_bits, rule }
    }

    fn close_round<const N: usize>(&self, round: &Round<N>, followers: &[Sig; N]) {
        for (&state, follower) in round.states.iter().zip(followers) {
            if follower.fraction_bits() != round.fraction_bits {
                let mut state_of = self.state.borrow_mut();
                let signal = state_of.full_name(state);
                state_of.fail(BuildError::LoopMovesPoint {
                    signal,
                    loaded: round.fraction_bits,
                    followed: follower.fraction_bits(),
                });
            }
            self.close_loop(state, follower);
        }
    }
}

//! Disagreements of a run: everything that differs from what is expected.
use specula_testbench::{
    Bench, Mismatch, MovedInput, Outcome, Violation, WorstQuantisation, WrongDirection,
};

use crate::stream_top::{StreamFault, StreamOutcome};

/// All disagreements of a run, with the first of each kind in full.
#[derive(Clone, Debug, PartialEq)]
pub struct Disagreement {
    /// Pixels whose code is not the model's.
    pub mismatches: u64,
    /// The first such pixel, and the clock in which it leaves the core.
    pub first_mismatch: Option<(Mismatch, u64)>,
    /// The first component of a direction that is not the model's, and the clock in which it leaves.
    pub wrong_direction: Option<(WrongDirection, u64)>,
    /// Number of clocks in which a pixel left that was not due, or was due and did not leave.
    pub wrong_clocks: usize,
    /// The first such clock.
    pub first_wrong_clock: Option<u64>,
    /// The first stated fact that did not hold.
    pub violation: Option<Violation>,
    /// The first input that holds for a frame and did not stand still.
    pub moved_input: Option<MovedInput>,
    /// The largest quantisation error that is above its bound.
    pub beyond_bound: Option<BeyondBound>,
    /// The first thing that is wrong in the streams around the core.
    pub stream: Option<StreamFault>,
}

/// A quantisation error above its proven bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeyondBound {
    /// The largest such error.
    pub worst: WorstQuantisation,
    /// The clock in which its pixel leaves the core.
    pub clock: u64,
    /// The bound, in LSBs.
    pub bound_lsb: f64,
    /// Pixels with such an error.
    pub pixels: u64,
}

impl Disagreement {
    /// The disagreements in the `outcome` of a bench, and in that of the core's streams if they were
    /// simulated; `None` if there are none.
    pub fn of(
        outcome: &Outcome,
        bench: &Bench,
        stream: Option<&StreamOutcome>,
    ) -> Option<Disagreement> {
        let with_clock = |mismatch: &Mismatch| {
            (mismatch.clone(), bench.leaving_clock(mismatch.span, mismatch.pixel))
        };
        let disagreement = Disagreement {
            mismatches: outcome.comparison.mismatches,
            first_mismatch: outcome.comparison.first_mismatch.as_ref().map(with_clock),
            wrong_direction: outcome.wrong_direction.clone().map(|wrong| {
                let clock = bench.leaving_clock(wrong.span, wrong.pixel);
                (wrong, clock)
            }),
            wrong_clocks: outcome.wrong_clocks.len(),
            first_wrong_clock: outcome.wrong_clocks.first().copied(),
            violation: outcome.violation.clone(),
            moved_input: outcome.moved_input.clone(),
            beyond_bound: outcome.beyond_bound().map(|&worst| BeyondBound {
                worst,
                clock: bench.leaving_clock(worst.span, worst.pixel),
                bound_lsb: outcome.bound_lsb,
                pixels: outcome.comparison.beyond_bound,
            }),
            stream: stream.and_then(|stream| stream.fault.clone()),
        };
        (!outcome.agrees() || disagreement.stream.is_some()).then_some(disagreement)
    }

    /// The first clock in which a disagreement is visible.
    pub fn first_clock(&self) -> u64 {
        let mismatch = self.first_mismatch.as_ref().map(|(_, clock)| *clock);
        let violation = self.violation.as_ref().map(|violation| violation.clock);
        let beyond = self.beyond_bound.map(|beyond| beyond.clock);
        // A core with an error above its bound still agrees with its model, so that clock counts
        // only if nothing else disagrees.
        let moved = self.moved_input.as_ref().map(|moved| moved.clock);
        let stream = self.stream.as_ref().and_then(|fault| fault.cycle);
        let direction = self.wrong_direction.as_ref().map(|(_, clock)| *clock);
        let first = [mismatch, direction, self.first_wrong_clock, violation, moved, stream];
        let first = first.into_iter().flatten().min();
        first.or(beyond).unwrap_or(0)
    }

    /// The disagreement as text, a line for each kind.
    pub fn lines(&self) -> Vec<String> {
        let pixel = self.first_mismatch.as_ref().map(|(m, clock)| {
            let (simulated, expected) = (codes(m.simulated), codes(m.expected));
            format!(
                "{} pixels differ, first ({}, {}) in cycle {clock}: simulated {simulated}, expected {expected} (span {}, pixel {})",
                self.mismatches, m.x, m.y, m.span, m.pixel
            )
        });
        let direction = self
            .wrong_direction
            .as_ref()
            .map(|(wrong, clock)| format!("in cycle {clock} {}", wrong.in_words()));
        let clocks = self.first_wrong_clock.map(|clock| {
            format!(
                "{} cycles in which a pixel left that was not due, or was due and did not leave, first {clock}",
                self.wrong_clocks
            )
        });
        let fact = self.violation.as_ref().map(Violation::in_words);
        let beyond = self.beyond_bound.as_ref().map(BeyondBound::in_words);
        let moved = self.moved_input.as_ref().map(MovedInput::in_words);
        let stream = self.stream.as_ref().map(|fault| fault.in_words.clone());
        [pixel, direction, clocks, fact, moved, beyond, stream].into_iter().flatten().collect()
    }

    /// Whether an error above its bound is the only disagreement: every pixel is the model's and
    /// leaves in its clock, every fact holds, and every input stands still.
    pub fn is_bound_only(&self) -> bool {
        let holds = self.violation.is_none() && self.moved_input.is_none() && self.stream.is_none();
        let is_the_model = self.mismatches == 0 && self.wrong_direction.is_none();
        is_the_model && self.wrong_clocks == 0 && holds
    }
}

impl BeyondBound {
    /// The broken bound as text, with an explanation.
    fn in_words(&self) -> String {
        let BeyondBound { worst: w, clock, bound_lsb, pixels } = self;
        let several =
            if *pixels == 1 { "1 pixel has".to_owned() } else { format!("{pixels} pixels have") };
        let meaning = if w.simulated == w.expected {
            "the bit-true model has the same code from the same inputs, so the set-up of spans or the bound is wrong".to_owned()
        } else {
            format!("the bit-true model has {}", w.expected)
        };
        format!(
            "{several} a quantisation error above the proven bound of {bound_lsb:.3} LSB, the largest {:.3} LSB: {} of ({}, {}) is {} in cycle {clock}, and \
             {:.3} by the method in exact arithmetic (span {}, pixel {}); {meaning}",
            w.error_lsb, CHANNELS[w.channel], w.x, w.y, w.simulated, w.method, w.span, w.pixel
        )
    }
}

/// Names of the channels.
pub const CHANNELS: [&str; 3] = ["red", "green", "blue"];

fn codes([r, g, b]: [u8; 3]) -> String {
    format!("({r}, {g}, {b})")
}

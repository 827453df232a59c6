//! What of a run is not as it must be.
use specula_testbench::{Bench, Mismatch, Outcome, Violation};

/// Everything that disagrees, first occurrences in full.
#[derive(Clone, Debug, PartialEq)]
pub struct Disagreement {
    /// Pixels whose code is not the model's.
    pub mismatches: u64,
    /// The first of them, and the clock in which it leaves the core.
    pub first_mismatch: Option<(Mismatch, u64)>,
    /// Number of clocks in which a pixel left that was not due, or was due and did not leave.
    pub wrong_clocks: usize,
    /// The first of them.
    pub first_wrong_clock: Option<u64>,
    /// The first stated fact that did not hold.
    pub violation: Option<Violation>,
}

impl Disagreement {
    /// What disagrees in the `outcome` of a bench, if anything does.
    pub fn of(outcome: &Outcome, bench: &Bench) -> Option<Disagreement> {
        let with_clock = |mismatch: &Mismatch| (mismatch.clone(), bench.leaving_clock(mismatch.span, mismatch.pixel));
        let disagreement = Disagreement {
            mismatches: outcome.comparison.mismatches,
            first_mismatch: outcome.comparison.first_mismatch.as_ref().map(with_clock),
            wrong_clocks: outcome.wrong_clocks.len(),
            first_wrong_clock: outcome.wrong_clocks.first().copied(),
            violation: outcome.violation.clone(),
        };
        (!outcome.agrees()).then_some(disagreement)
    }

    /// The clock in which it can be seen first.
    pub fn first_clock(&self) -> u64 {
        let mismatch = self.first_mismatch.as_ref().map(|(_, clock)| *clock);
        let violation = self.violation.as_ref().map(|violation| violation.clock);
        // A pixel that disagrees, a clock that is wrong or a fact that is violated: there is one of them.
        [mismatch, self.first_wrong_clock, violation].into_iter().flatten().min().unwrap_or(0)
    }

    /// In words, a line for each kind.
    pub fn lines(&self) -> Vec<String> {
        let pixel = self.first_mismatch.as_ref().map(|(m, clock)| {
            let (simulated, expected) = (codes(m.simulated), codes(m.expected));
            format!(
                "{} pixels differ, first ({}, {}) in cycle {clock}: simulated {simulated}, expected {expected} (span {}, pixel {})",
                self.mismatches, m.x, m.y, m.span, m.pixel
            )
        });
        let clocks = self.first_wrong_clock.map(|clock| {
            format!(
                "{} cycles in which a pixel left that was not due, or was due and did not leave, first {clock}",
                self.wrong_clocks
            )
        });
        let fact = self
            .violation
            .as_ref()
            .map(|v| format!("`{}` does not hold: signal {} is {} in cycle {}", v.fact, v.signal, v.value, v.clock));
        [pixel, clocks, fact].into_iter().flatten().collect()
    }
}

fn codes([r, g, b]: [u8; 3]) -> String {
    format!("({r}, {g}, {b})")
}

//! Which clocks of a run are traced.
use std::ops::Range;

use specula_datapath::Design;
use specula_sim::Stimulus;

use crate::WorstPixel;

/// What the user wants to see.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Choice {
    /// 200 clocks round the pixel with the largest total error.
    Worst,
    /// Nothing.
    None,
    /// The clocks in which this span goes through the core.
    Span(usize),
    /// These clocks.
    Cycles(Range<u64>),
    /// The whole run.
    All,
}

/// Clocks of the window round the worst pixel.
pub const WORST_WINDOW: u64 = 200;

impl Choice {
    /// The clocks to be traced of a run of a design with this stimulus; `None` for none.
    pub fn window(
        &self,
        stimulus: &Stimulus,
        design: &Design,
        worst: Option<&WorstPixel>,
    ) -> Option<Range<u64>> {
        let all = stimulus.clocks();
        let window = match self {
            Choice::None => return None,
            Choice::All => all.clone(),
            Choice::Cycles(clocks) => clocks.clone(),
            Choice::Span(index) => {
                stimulus.begin_of(*index)
                    ..stimulus.begin_of(index.saturating_add(1)) + u64::from(design.latency()) + 1
            }
            Choice::Worst => {
                let worst = worst?;
                let leaves = leaving_clock(stimulus, design, worst.span, worst.pixel);
                // Round the pixel's way through the core: its exit stands three quarters into the
                // window.
                let first = (leaves + WORST_WINDOW / 4).saturating_sub(WORST_WINDOW);
                first..first + WORST_WINDOW
            }
        };
        let clipped = window.start.max(all.start)..window.end.min(all.end);
        (!clipped.is_empty()).then_some(clipped)
    }
}

/// The clock in which pixel number `pixel` of span number `span` leaves the core.
pub fn leaving_clock(stimulus: &Stimulus, design: &Design, span: usize, pixel: u32) -> u64 {
    stimulus.completion_of(span, pixel) + u64::from(design.depth())
}

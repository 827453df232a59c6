//! What is wrong in a run, as text.
use crate::{MovedInput, Outcome, WrongDirection};

impl Outcome {
    /// What keeps the run from [agreeing](Outcome::agrees), if anything does: the first pixel that
    /// is not the model's, the first direction that is not, the clocks in which pixels left or did not, the first fact that did not
    /// hold, the first input that did not stand still, or the largest error above its bound.
    pub fn fault(&self) -> Option<String> {
        let pixel = || self.comparison.first_mismatch.as_ref().map(|first| format!("{first:?}"));
        let clocks = || {
            let wrong = &self.wrong_clocks;
            (!wrong.is_empty()).then(|| format!("pixels leave or are missing in clocks {wrong:?}"))
        };
        let fact = || self.violation.as_ref().map(|violation| format!("{violation:?}"));
        let error = || {
            let worst = self.beyond_bound()?;
            Some(format!("an error above the bound of {} LSB: {worst:?}", self.bound_lsb))
        };
        let input = || self.moved_input.as_ref().map(MovedInput::in_words);
        let direction = || self.wrong_direction.as_ref().map(WrongDirection::in_words);
        pixel().or_else(direction).or_else(clocks).or_else(fact).or_else(input).or_else(error)
    }
}

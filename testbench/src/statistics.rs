//! Error figures over all channels of all shaded pixels.
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use specula_scene::{Frame, Span};
use specula_spec::FULL_SCALE;

/// One kind of error, in LSBs of the 8-bit output.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ErrorFigures {
    /// Largest magnitude.
    pub max_lsb: f64,
    /// Root of the mean square.
    pub rms_lsb: f64,
    /// Mean magnitude.
    pub mean_lsb: f64,
    /// Peak signal to noise ratio, 20 log10(255 / rms), in dB; `None` where there is no error at
    /// all.
    pub psnr_db: Option<f64>,
}

/// Where the error comes from. All are taken before rounding on the exact side; the core's side is
/// its 8-bit codes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// The core's codes against exact shading.
    pub total: ErrorFigures,
    /// The core's method in exact arithmetic against exact shading.
    pub method: ErrorFigures,
    /// The core's codes against its method in exact arithmetic; up to half an LSB of it is the
    /// rounding to 8 bits.
    pub quantisation: ErrorFigures,
}

/// Sums from which figures are made.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums {
    count: u64,
    largest: f64,
    magnitudes: f64,
    squares: f64,
}

impl Sums {
    /// Adds an error, in LSBs of the 8-bit output.
    pub fn add(&mut self, error: f64) {
        let magnitude = error.abs();
        self.count += 1;
        self.largest = self.largest.max(magnitude);
        self.magnitudes += magnitude;
        self.squares += magnitude * magnitude;
    }

    /// Adds the sums of other errors.
    pub fn merge(&mut self, other: &Sums) {
        self.count += other.count;
        self.largest = self.largest.max(other.largest);
        self.magnitudes += other.magnitudes;
        self.squares += other.squares;
    }

    /// Those of all spans of a frame, which are worked on in parallel and put together in their
    /// order, so that nothing depends on threads.
    pub fn of_spans(frame: &Frame, of_span: impl Fn(&Span) -> Sums + Sync) -> Sums {
        let of_spans: Vec<Sums> = frame.spans.par_iter().map(&of_span).collect();
        let mut sums = Sums::default();
        of_spans.iter().for_each(|span| sums.merge(span));
        sums
    }

    /// The figures of the errors added so far; all 0 where there are none.
    pub fn figures(&self) -> ErrorFigures {
        let count = self.count.max(1) as f64;
        let rms = (self.squares / count).sqrt();
        let psnr_db = (rms > 0.0).then(|| 20.0 * (FULL_SCALE / rms).log10());
        ErrorFigures {
            max_lsb: self.largest,
            rms_lsb: rms,
            mean_lsb: self.magnitudes / count,
            psnr_db,
        }
    }
}

/// The middle one, or the mean of the two in the middle; 0 of nothing.
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    match (sorted.get(sorted.len() / 2), sorted.len() % 2) {
        (None, _) => 0.0,
        (Some(&middle), 1) => middle,
        (Some(&upper), _) => (sorted[sorted.len() / 2 - 1] + upper) / 2.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_follow_their_definitions() {
        let mut sums = Sums::default();
        [3.0, -4.0, 0.0, 0.0].into_iter().for_each(|e| sums.add(e));
        let figures = sums.figures();
        assert_eq!((figures.max_lsb, figures.rms_lsb, figures.mean_lsb), (4.0, 2.5, 1.75));
        let psnr = figures.psnr_db.map(|db| (db * 1000.0).round());
        assert_eq!(psnr, Some((20.0 * 102f64.log10() * 1000.0).round()));
    }

    #[test]
    fn no_error_has_no_ratio() {
        assert_eq!(Sums::default().figures().psnr_db, None);
    }

    #[test]
    fn medians_stand_in_the_middle() {
        assert_eq!(
            [&[][..], &[3.0], &[5.0, 1.0], &[9.0, 1.0, 2.0]].map(median),
            [0.0, 3.0, 3.0, 2.0]
        );
    }
}

//! How far a colour is off before it is rounded.
use specula_datapath::bound::{Bound, ErrorModel, RELATIVE_BOUNDS, RelativeBound};
use specula_spec::FULL_SCALE;

/// A value that is not to be negative.
#[derive(Clone, Copy, Debug)]
pub struct Factor {
    /// The smallest there is.
    pub smallest: f64,
    /// The largest there is.
    pub largest: f64,
    /// Bound on its error.
    pub off: f64,
}

/// A product k f of a coefficient and an intensity.
#[derive(Clone, Copy, Debug)]
pub struct Term {
    /// k, in LSBs of the output.
    pub coefficient: Factor,
    /// f.
    pub intensity: Factor,
    /// What is known of f's error beside its bound.
    pub form: ErrorModel,
}

impl Term {
    /// Of a coefficient and an intensity as they come.
    pub fn new(coefficient: Bound, intensity: Bound) -> Term {
        let factor = |bound: Bound| Factor {
            smallest: bound.fixed.low,
            largest: bound.magnitude(),
            off: bound.error,
        };
        let form = intensity.model;
        Term { coefficient: factor(coefficient), intensity: factor(intensity), form }
    }
}

/// Bound on the error of a code: of the sum over a pixel's time slots below full scale, and half an LSB
/// for rounding. Nothing is known where a value may be negative.
pub fn code(ambient: Bound, terms: &[Term], slots: u32) -> f64 {
    let smallest = |term: &Term| term.coefficient.smallest.min(term.intensity.smallest);
    if terms.iter().map(smallest).fold(ambient.fixed.low, f64::min) < 0.0 {
        return f64::INFINITY;
    }
    below_full_scale(ambient.error, terms, slots) + 0.5
}

/// Bound on the error of the sum over a pixel's time slots where it is below full scale.
///
/// Nothing is negative. Where fixed and real sum are both 255 or more, so are both codes. Else the
/// smaller sum, and of each product k f the smaller one in it, adds up to less than 255. With
/// intensities off by ρ f + r and coefficients by e
///
/// ```text
/// |Σ' - Σ| ≤ Σ k ρ f + Σ (k r + f e)
/// Σ k ρ f  ≤ 255 max ρ                  since Σ k f < 255
/// Σ k ρ f  ≤ Σ k ρ max f
/// ```
///
/// with the largest k and f. Of the pairs of ρ and r that hold, those count that make the least of
/// it. Intensities of which one alone is off by r, or else all by less, count with r once in a
/// time slot, or with the less all of them.
fn below_full_scale(ambient: f64, terms: &[Term], slots: u32) -> f64 {
    let with = |share: usize| of_slots(terms, slots, share);
    ambient + (0..RELATIVE_BOUNDS).map(with).fold(f64::INFINITY, f64::min)
}

/// What the terms of all time slots add, of the pairs of ρ and r the one with this number.
fn of_slots(terms: &[Term], slots: u32, share: usize) -> f64 {
    let (mut largest_ratio, mut of_values, mut beside) = (0.0_f64, 0.0, 0.0);
    let (mut of_one, mut of_all) = (0.0_f64, 0.0);
    for Term { coefficient, intensity, form } in terms {
        let most = coefficient.largest + coefficient.off;
        beside += (intensity.largest + intensity.off) * coefficient.off;
        let RelativeBound { ratio, rest } = match form {
            ErrorModel::Relative(shares) => shares[share],
            ErrorModel::Exclusive { together } => {
                of_one = of_one.max(most * intensity.off);
                of_all += most * together.min(intensity.off);
                continue;
            }
            _ => RelativeBound { ratio: 0.0, rest: intensity.off },
        };
        largest_ratio = largest_ratio.max(ratio);
        of_values += most * intensity.largest * ratio;
        beside += most * rest.min(intensity.off);
    }
    beside += of_one.max(of_all);
    (FULL_SCALE * largest_ratio).min(f64::from(slots) * of_values) + f64::from(slots) * beside
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;

    use super::*;

    /// A term with its real and its fixed coefficient and intensity.
    fn draw_term(draw: &mut Draw, form: ErrorModel, off: f64) -> (Term, [f64; 2], [f64; 2]) {
        let Term { coefficient, intensity, .. } = Term {
            coefficient: Factor { smallest: 0.0, largest: draw.within(0.0, 150.0), off: 1e-3 },
            intensity: Factor { smallest: 0.0, largest: 1.0, off },
            form,
        };
        let k = (coefficient.largest - draw.one_of(&[0.0, 0.1])).max(0.0);
        let f = draw.within(0.0, 1.0);
        let within = match form {
            ErrorModel::Relative([RelativeBound { ratio, rest }, ..]) => {
                // The fixed one may be the smaller.
                (ratio * f / (1.0 + ratio) + rest / (1.0 + ratio)).min(off)
            }
            _ => off,
        };
        let fixed = [
            (k + draw.error(coefficient.off)).clamp(0.0, coefficient.largest),
            (f + draw.error(within)).clamp(0.0, 1.0),
        ];
        (Term { coefficient, intensity, form }, [k, f], fixed)
    }

    fn sum(terms: &[[f64; 2]]) -> f64 {
        terms.iter().map(|[k, f]| k * f).sum()
    }

    /// Sums below full scale: 90 % of the bound is reached.
    #[test]
    fn sums_below_full_scale_stay_within_the_bound_and_come_near() {
        let proportional =
            |ratio, rest| ErrorModel::Relative([RelativeBound { ratio, rest }; RELATIVE_BOUNDS]);
        let mut draw = Draw::new(1);
        for (form, off) in [
            (ErrorModel::Bounded, 0.01),
            (proportional(0.05, 1e-4), 0.06),
            (proportional(1e-3, 0.01), 0.02),
        ] {
            let mut reached = 0.0_f64;
            for _ in 0..40_000 {
                let [a, b] = [0; 2].map(|_| draw_term(&mut draw, form, off));
                let (real, fixed) = (sum(&[a.1, b.1]), sum(&[a.2, b.2]));
                let bound = below_full_scale(0.0, &[a.0, b.0], 1);
                let error = (fixed.min(FULL_SCALE) - real.min(FULL_SCALE)).abs();
                reached = reached.max(error / bound);
            }
            assert!(reached <= 1.0 && reached > 0.9, "{form:?}: {reached}");
        }
    }

    /// Of two intensities, either one alone is off by much or both by little: 90 % of the bound is
    /// reached.
    #[test]
    fn one_of_several_counts_once() {
        let (together, off) = (0.01, 0.1);
        let form = ErrorModel::Exclusive { together };
        let mut draw = Draw::new(1);
        let mut reached = 0.0_f64;
        for _ in 0..10_000 {
            let terms = [0; 2].map(|_| Term {
                coefficient: Factor { smallest: 0.0, largest: draw.within(0.0, 100.0), off: 0.0 },
                intensity: Factor { smallest: 0.0, largest: 1.0, off },
                form,
            });
            let most = draw.one_of(&[[off, 0.0], [0.0, off], [together; 2]]);
            let error: f64 = terms
                .iter()
                .zip(most)
                .map(|(term, most)| term.coefficient.largest * draw.error(most))
                .sum();
            reached = reached.max(error.abs() / below_full_scale(0.0, &terms, 1));
        }
        assert!(reached <= 1.0 && reached > 0.9, "{reached}");
    }
}

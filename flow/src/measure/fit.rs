//! Straight lines through measured points.

/// The line y = base + slope x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// y where x is 0.
    pub base: f64,
    /// What y grows by for each 1 of x.
    pub slope: f64,
}

impl Line {
    /// The line for which the sum of (y − base − slope x)² is least:
    /// slope = Σ (x − x̄)(y − ȳ) / Σ (x − x̄)², base = ȳ − slope x̄.
    ///
    /// The points have two different x at least.
    pub fn through(points: &[(f64, f64)]) -> Line {
        let mean = |value: fn(&(f64, f64)) -> f64| {
            points.iter().map(value).sum::<f64>() / points.len() as f64
        };
        let (mean_x, mean_y) = (mean(|point| point.0), mean(|point| point.1));
        let sum = |value: &dyn Fn(f64, f64) -> f64| {
            points.iter().map(|(x, y)| value(x - mean_x, y - mean_y)).sum::<f64>()
        };
        let slope = sum(&|x, y| x * y) / sum(&|x, _| x * x);
        Line { base: mean_y - slope * mean_x, slope }
    }

    /// y at `x`.
    #[cfg(test)]
    fn at(&self, x: f64) -> f64 {
        self.base + self.slope * x
    }
}

/// The median; the lower one of the two in the middle. Nothing of nothing.
pub fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    values.get(values.len().saturating_sub(1) / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_goes_through_points_of_a_line() {
        let line = Line { base: 1.25, slope: 0.5 };
        let points = [1.0, 2.0, 5.0, 9.0].map(|x| (x, line.at(x)));
        assert_eq!(Line::through(&points), line);
    }

    #[test]
    fn points_off_the_line_weigh_alike() {
        // Through (0, 0), (1, 3), (2, 0): the mean, and no slope.
        let line = Line::through(&[(0.0, 0.0), (1.0, 3.0), (2.0, 0.0)]);
        assert_eq!(line, Line { base: 1.0, slope: 0.0 });
    }

    #[test]
    fn of_an_even_number_the_lower_one_in_the_middle_counts() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), Some(2.0));
        assert_eq!(median(vec![]), None);
    }
}

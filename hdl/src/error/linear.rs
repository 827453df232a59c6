//! How far what is linear along a span is off.
use super::host::HOST_ERROR;

/// Bound on the error of x(i) = x0 + i d over a span of `steps` + 1 pixels.
///
/// Start and step are each rounded to half a unit u of the last place:
///
/// ```text
/// |x'(i) - x(i)| ≤ u/2 + i u/2
///                ≤ (1 + S) u/2   with i ≤ S
/// ```
///
/// In formats finer than f64 the host's own error is the larger.
pub fn bound(steps: u32, ulp: f64) -> f64 {
    0.5 * f64::from(steps + 1) * ulp + HOST_ERROR
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;
    use specula_spec::Format;

    /// Starts and steps as the host rounds them: 90 % of the bound is reached.
    #[test]
    fn rounded_starts_and_steps_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (steps, bits) in [(0, 8), (1, 12), (7, 10), (100, 20)] {
            let format = Format::signed(1, bits);
            let rounded = |value: f64| format.value(format.quantise(value));
            let bound = super::bound(steps, format.ulp());
            let mut reached = 0.0_f64;
            for _ in 0..5000 {
                let [x0, end] = [0; 2].map(|_| draw.within(-1.0, 1.0));
                let d = (end - x0) / f64::from(steps.max(1));
                let fixed = rounded(x0) + f64::from(steps) * rounded(d);
                let real = x0 + f64::from(steps) * d;
                reached = reached.max((fixed - real).abs() / bound);
            }
            assert!(reached <= 1.0 && reached > 0.9, "{steps} steps: {reached}");
        }
    }
}

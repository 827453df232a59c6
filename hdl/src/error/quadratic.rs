//! How far a quadratic by forward differences is off.
use super::host::HOST_ERROR;

/// Bound on the error of x(i) over a span of `steps` + 1 pixels.
///
/// Start and both differences are each rounded to half a unit u of the last place:
///
/// ```text
/// x(i)           = x0 + i d0 + i(i-1)/2 d2
/// |x'(i) - x(i)| ≤ (1 + i + i(i-1)/2) u/2
///                ≤ (1 + S + S(S-1)/2) u/2   with i ≤ S (numerics N3b)
/// ```
///
/// In formats finer than f64 the host's own error is the larger.
pub fn bound(steps: u32, ulp: f64) -> f64 {
    let s = f64::from(steps);
    0.5 * (1.0 + s + s * (s - 1.0).max(0.0) / 2.0) * ulp + HOST_ERROR
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;
    use specula_spec::Format;

    /// Parabolas through three values from -1 to 1, as the host rounds them: 80 % of the bound is
    /// reached.
    #[test]
    fn rounded_differences_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (steps, bits) in [(2, 10), (9, 14), (50, 24), (1000, 34)] {
            let format = Format::signed(3, bits);
            let rounded = |value: f64| format.value(format.quantise(value));
            let s = f64::from(steps);
            let at = |[x0, d0, d2]: [f64; 3]| x0 + s * d0 + s * (s - 1.0) / 2.0 * d2;
            let bound = super::bound(steps, format.ulp());
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let [start, middle, end] = [0; 3].map(|_| draw.within(-1.0, 1.0));
                let curvature = 2.0 * (start + end - 2.0 * middle) / (s * s);
                let slope = (end - start) / s - s * curvature;
                let real = [start, slope + curvature, 2.0 * curvature];
                reached = reached.max((at(real.map(rounded)) - at(real)).abs() / bound);
            }
            assert!(reached <= 1.0 && reached > 0.8, "{steps} steps: {reached}");
        }
    }
}

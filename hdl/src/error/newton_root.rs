//! How far a square root is off that follows the pixel before.
use specula_datapath::bound::Bound;
use specula_spec::direct::DirectFormats;
use specula_spec::format::power_of_two;

use super::vector::shortest;

/// Bound on the error of d after `steps` steps d ← (d + q/d)/2 at each pixel, from the d of the
/// pixel before on and from 1 at the first; nothing where steps may lead away from the root. Real q
/// is no smaller than s², s = `shortest`, and off by e_q.
///
/// Real d is √q ≥ s or more, and D = d + e. As long as e ≤ s/16 both lie above l = 15/16 s. A step
/// has the derivatives
///
/// ```text
/// ∂/∂d = (1 - q/d²)/2, from (1 - (1 + e_q)/l²)/2 to 1/2   for q ≤ 1 + e_q
/// ∂/∂q = 1/(2d)        ≤ 1/(2l)
/// ```
///
/// and rounds its quotient, which counts half, and its d to half a unit u/2 each. So a step makes
/// of e no more than
///
/// ```text
/// λ e + ρ,   λ = max(1, (1 + e_q)/l² - 1)/2,   ρ = e_q/(2l) + 3/4 u
/// ```
///
/// A second step begins at √q or above: it makes e/2 + ρ of e. Where all steps of a pixel shrink it,
///
/// ```text
/// e ≤ ρ/(1 - λ)               one step:  spans of up to 103 degrees
/// e ≤ (ρ/2 + ρ)/(1 - λ/2)     two steps: spans of up to 123 degrees
/// ```
///
/// That q counts as 4^-m at least brings it no further from the real one as long as s ≥ 2^-m.
fn root_within(steps: u32, shortest: f64, e_q: f64, formats: &DirectFormats) -> Option<f64> {
    if shortest < power_of_two(-i64::from(formats.reciprocal.integer_bits)) {
        return None;
    }
    let lowest = 0.9375 * shortest;
    let once = 0.5 * ((1.0 + e_q) / (lowest * lowest) - 1.0).max(1.0);
    let added = e_q / (2.0 * lowest) + 0.75 * formats.length.ulp();
    let halved = |(shrunk, added_so_far): (f64, f64)| (0.5 * shrunk, 0.5 * added_so_far + added);
    let (shrunk, added) = (1..steps).fold((once, added), |so_far, _| halved(so_far));
    let error = added / (1.0 - shrunk);
    (shrunk < 1.0 && error <= shortest / 16.0).then_some(error)
}

/// What is proven of d.
#[derive(Clone, Copy, Debug)]
pub struct Length {
    /// Real d, which is √q, is no smaller.
    pub shortest: f64,
    /// Fixed d is no larger.
    pub largest: f64,
    /// Bound on the error of d.
    pub error: f64,
}

/// What is proven of d, of q as it comes and of q as it is `limited` to 4^-m or more: where steps
/// may lead away from the root, both are no further apart than d is large.
pub fn length(steps: u32, q: Bound, limited: Bound, formats: &DirectFormats) -> Length {
    let least = power_of_two(-i64::from(formats.reciprocal.integer_bits));
    let largest = largest(least, limited.fixed.high, formats.length.ulp());
    let error = followed_root(steps, q, formats).unwrap_or(largest);
    Length { shortest: shortest(q), largest, error }
}

/// Bound on the error of d, of q as it comes; see `root_within`.
pub fn followed_root(steps: u32, q: Bound, formats: &DirectFormats) -> Option<f64> {
    root_within(steps, shortest(q), q.error, formats)
}

/// d is no larger, begun at 1, with d no smaller than l = `least` and q no larger than Q =
/// `largest_q`, or 1; each step rounds d to half a unit of `ulp`.
///
/// (d + q/d)/2 is convex in d, and so no larger for d from l to D than at one of its ends:
///
/// ```text
/// d = l:  (l + q/l)/2 ≤ (l + Q/l)/2
/// d = D:  (D + q/D)/2 ≤ D             where D² ≥ Q, as D ≥ Q ≥ 1 makes it
/// ```
fn largest(least: f64, largest_q: f64, ulp: f64) -> f64 {
    let most = largest_q.max(1.0);
    most.max((least + most / least) / 2.0) + ulp
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;
    use specula_fixtures::formats::direct_formats;
    use specula_spec::Format;

    use super::*;

    fn formats(length: u32) -> DirectFormats {
        DirectFormats {
            length: Format::unsigned(1, length),
            reciprocal: Format::unsigned(3, 10),
            ..direct_formats(Format::unsigned(1, 10))
        }
    }

    /// Largest error of d over the bound, for q that jumps between its ends.
    fn reached(steps: u32, shortest: f64, e_q: f64, length: u32) -> f64 {
        let formats = formats(length);
        let bound = root_within(steps, shortest, e_q, &formats).expect("such steps shrink it");
        let half_unit = 0.5 * formats.length.ulp();
        let mut draw = Draw::new(1);
        let mut reached = 0.0_f64;
        for _ in 0..5000 {
            let (mut real, mut fixed) = (1.0_f64, 1.0_f64);
            for _ in 0..8 {
                let between = draw.within(shortest * shortest, 1.0);
                let q = draw.one_of(&[shortest * shortest, 1.0, between]);
                let q_fixed = q + draw.error(e_q);
                for _ in 0..steps {
                    real = (real + q / real) / 2.0;
                    let quotient = q_fixed / fixed + draw.error(half_unit);
                    fixed = (fixed + quotient) / 2.0 + draw.error(half_unit);
                }
                reached = reached.max((fixed - real).abs() / bound);
            }
        }
        reached
    }

    /// Of the bound 45 % is reached in narrow spans, a quarter with one step and a fifteenth with two
    /// in the widest: q cannot lead away from the root in every step.
    #[test]
    fn roots_stay_within_the_bound_and_reach_it() {
        for (steps, shortest, least) in
            [(1, 0.65, 0.2), (1, 0.9, 0.5), (2, 0.5, 0.06), (2, 0.9, 0.45)]
        {
            for (e_q, length) in [(1e-4, 20), (1e-7, 12)] {
                let reached = reached(steps, shortest, e_q, length);
                println!("{steps} steps, {shortest}, {e_q}: {reached}");
                assert!(reached <= 1.0 && reached > least, "{steps}, {shortest}: {reached}");
            }
        }
    }

    /// Steps from any d on that comes within the limit stay within it.
    #[test]
    fn roots_are_no_larger_than_stated() {
        let ulp = 1.0 / 256.0;
        for (least, largest_q) in [(0.5, 1.0), (0.125, 1.25), (0.9, 2.0)] {
            let most = largest(least, largest_q, ulp);
            let mut reached = 0.0_f64;
            for i in 0..=1000 {
                let d = least + (most - least) * f64::from(i) / 1000.0;
                reached = reached.max((d + largest_q / d) / 2.0 + 0.5 * ulp);
            }
            println!("{least}, {largest_q}: {reached} of {most}");
            assert!(reached <= most && reached > 0.75 * most, "{least}: {reached} of {most}");
        }
    }

    /// In wider spans steps may lead away from the root.
    #[test]
    fn nothing_is_known_of_wide_spans() {
        let wide = |degrees: f64| (degrees / 2.0).to_radians().cos();
        let known = |steps, degrees| root_within(steps, wide(degrees), 1e-6, &formats(20));
        assert!(known(1, 103.0).is_some() && known(1, 105.0).is_none());
        assert!(known(2, 123.0).is_some() && known(2, 125.0).is_none());
        assert!(known(2, 179.0).is_none());
    }
}

//! The effect of an angle or a length on a cosine and on a highlight.
use std::f64::consts::PI;

use specula_golden::exact::formula::shape::lobe;

/// |u - v| of unit vectors that are `angle` radians apart: no cosine with a unit vector differs by
/// more.
pub fn chord(angle: f64) -> f64 {
    2.0 * (angle.abs().min(PI) / 2.0).sin()
}

/// The largest change of cos^n a if a changes by `angle`: the angle times the steepest slope, at
/// cos² a = 1 - 1/n.
pub fn power_turn_change(angle: f64, n: u32) -> f64 {
    let n = f64::from(n);
    (n.sqrt() * (1.0 - 1.0 / n).powf((n - 1.0) / 2.0) * angle.abs()).min(1.0)
}

/// The largest change of a base to the power n if the base, 0 to 1, changes by `base`.
pub fn power_change(base: f64, n: u32) -> f64 {
    (f64::from(n) * base.abs()).min(1.0)
}

/// The largest change of f_k(n/2 D·D) if |D| changes by `length`: f_0 = 1 - n/2 D·D is the
/// steepest, with slope n |D| at its foot, n/2 D·D = 1.
/// |D| at its foot, n/2 D·D = 1.
pub fn shape_change(length: f64, n: u32) -> f64 {
    ((2.0 * f64::from(n)).sqrt() * length.abs()).min(1.0)
}

/// Number of positions at which [`shape_error`] evaluates both curves, in addition to the foot of
/// f_k; between them neither curve changes by as much as a thousandth.
const PLACES: u32 = 512;

/// The largest |(1 - x/K)^K - max(cos a, 0)^n|, x = n (1 - cos a), over all angles, of K = `factors`
/// [numerics N2a].
pub fn shape_error(n: u32, factors: u32) -> f64 {
    // Both curves are nearly 0 at eight times the lobe's own width.
    let widest = (8.0 / f64::from(n).sqrt()).min(PI);
    let places = (0..=PLACES).map(|place| (widest * f64::from(place) / f64::from(PLACES)).cos());
    let foot = 1.0 - f64::from(factors) / f64::from(n);
    let off = |cosine: f64| {
        (lobe(f64::from(n) * (1.0 - cosine), factors) - cosine.max(0.0).powf(f64::from(n))).abs()
    };
    places.chain([foot.max(-1.0)]).map(off).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares with numerics N2a, to three digits.
    #[test]
    fn shapes_are_off_as_measured() {
        for (n, k, off) in [
            (1, 0, 0.0),
            (1, 1, 0.25),
            (1, 3, 0.344),
            (4, 2, 0.0),
            (16, 1, 0.145),
            (256, 2, 0.0728),
            (8000, 0, 0.3679),
        ] {
            assert!(
                (shape_error(n, 1 << k) - off).abs() < 0.001,
                "n = {n}, k = {k}: {}",
                shape_error(n, 1 << k)
            );
        }
    }

    #[test]
    fn no_power_is_steeper() {
        for n in [1, 2, 16, 256, 8191] {
            let cosine = |a: f64| a.cos().max(0.0).powf(f64::from(n));
            for place in 0..1000 {
                let (a, step) = (f64::from(place) * PI / 2000.0, 1e-4);
                let off = (cosine(a) - cosine(a + step)).abs();
                assert!(off <= power_turn_change(step, n) + 1e-12, "n = {n}, a = {a}: {off}");
            }
        }
    }
}

//! How far highlights are off.
use specula_scene::spec::lyon::LyonSpec;

use super::LengthOff;
use specula_datapath::builder::Vector;

/// Steps from the middle of a highlight to its edge in which bounds are looked for; what grows
/// counts at a step's end, what falls at its begin.
const STEPS: u32 = 2048;

/// How far f_k of D is off for exponents up to `shininess`; 1 at most.
///
/// As a function of d = |D| and with K = 2^k, f = (1 - y²)^K for y = d √(n/2K), 0 from y = 1 on.
/// Its slope in d is √(2Kn) y (1 - y²)^(K-1), times d it is 2K y² (1 - y²)^(K-1), and over d it is
/// n (1 - y²)^(K-1). Each counts as often as [`LengthOff`] says, or the first as often as D is off
/// as a whole. Smaller exponents have no more of any at the same y.
///
/// Then f of the fixed D, with y', is rounded. Half a unit of x/2^k is raised to K and that of the
/// i-th square to 2^(k-i), so they come out times K b^(K-1) and 2^(k-i) b^(K-2^i), where b stands
/// for the real and the rounded 1 - y'². The powers b^(2^i) are off by 2^i units, and the mean of
/// real and rounded one is no more than the power of 1 - y'² + K units, as long as that is 1/2 or
/// more, which is put for less. And y' is no further from any y on the way to it than √(n/2K) times
/// what D is off.
pub fn shape_error(d: &Vector, length_off: LengthOff, shininess: f64, lyon: &LyonSpec) -> f64 {
    let n = shininess * f64::from(1u32 << lyon.difference.log2_exponent_factor());
    let highlight =
        Highlight { n, squarings: lyon.squarings as i32, ulp: lyon.formats.shape.ulp() };
    let whole = LengthOff::whole(d.off().length);
    let moved = (n / (2.0 * highlight.terms())).sqrt() * whole.level;
    let worst = |length_off| {
        let at = |i| highlight.error(f64::from(i) / f64::from(STEPS), length_off, moved);
        (0..STEPS).map(at).fold(0.0, f64::max)
    };
    // Of most D nothing more is known than of the whole.
    let of_length = if length_off == whole { 1.0 } else { worst(length_off) };
    of_length.min(worst(whole)).min(1.0)
}

/// f_k for one exponent.
struct Highlight {
    n: f64,
    squarings: i32,
    ulp: f64,
}

impl Highlight {
    /// K.
    fn terms(&self) -> f64 {
        2f64.powi(self.squarings)
    }

    /// Bound on the error for y from `begin` on, a step long.
    fn error(
        &self,
        begin: f64,
        LengthOff { level, growing, falling }: LengthOff,
        moved: f64,
    ) -> f64 {
        let (terms, end) = (self.terms(), begin + f64::from(STEPS).recip());
        let base = (1.0 - begin * begin).powi((1 << self.squarings) - 1);
        let of_length = (level * (2.0 * terms * self.n).sqrt() * end
            + growing * 2.0 * terms * end * end
            + falling * self.n)
            * base;
        of_length + self.rounding((begin - moved).max(0.0))
    }

    /// What rounding adds for y from `begin` on.
    fn rounding(&self, begin: f64) -> f64 {
        let base = ((1.0 - begin * begin).max(0.5) + self.terms() * self.ulp).min(1.0);
        let (k, terms) = (self.squarings, 1 << self.squarings);
        let of_square = |i: i32| 2f64.powi(k - i) * base.powi(terms - (1 << i));
        let of_x = self.terms() * base.powi(terms - 1);
        0.5 * self.ulp * (of_x + (1..=k).map(of_square).sum::<f64>())
    }
}

/// Largest |df_k/d|D|| for exponents up to `n`.
pub(super) fn steepest_slope(squarings: u32, n: f64) -> f64 {
    let k = f64::from(1u32 << squarings);
    let t = 1.0 / (2.0 * k - 1.0);
    (n * 2.0 * k * t).sqrt() * (1.0 - t).powf(k - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_bound_is_met_and_not_exceeded() {
        for squarings in 0..=3 {
            let k = f64::from(1u32 << squarings);
            for n in [1.0, 16.0, 300.0, 8191.0] {
                let f = |d: f64| (1.0 - n * d * d / (2.0 * k)).max(0.0).powf(k);
                let step = 1e-5 / f64::sqrt(n);
                let slope = |i: i32| {
                    let d = f64::from(i) * 1e-3 / n.sqrt();
                    ((f(d + step) - f(d)) / step).abs()
                };
                let steepest = (0..4000).map(slope).fold(0.0, f64::max);
                let bound = steepest_slope(squarings, n);
                assert!(
                    steepest <= bound * 1.0001 && steepest > bound * 0.99,
                    "k {squarings} n {n}: {steepest} against {bound}"
                );
            }
        }
    }
    #[test]
    fn rounded_highlights_of_longer_and_shorter_vectors_stay_within_the_bound() {
        for (squarings, n, ulp, off) in [
            (0, 16.0, 1.0 / 1024.0, 1e-3),
            (2, 256.0, 1.0 / 4096.0, 2e-4),
            (3, 8191.0, 1.0 / 512.0, 2e-5),
        ] {
            let of = Highlight { n, squarings, ulp };
            let level = LengthOff { level: off, growing: 0.0, falling: 0.0 };
            let moved = (n / (2.0 * of.terms())).sqrt() * off;
            let bound = (0..STEPS)
                .map(|i| of.error(f64::from(i) / f64::from(STEPS), level, moved))
                .fold(0.0, f64::max);
            let exact = |d: f64| (1.0 - n * d * d / (2.0 * of.terms())).max(0.0).powf(of.terms());
            let fixed = |d: f64, nudge: f64| {
                let rounded = |x: f64| ((x / ulp + nudge).floor() * ulp).clamp(0.0, 1.0);
                let base = 1.0 - rounded(n * d * d / (2.0 * of.terms()));
                (0..squarings).fold(base, |b, _| rounded(b * b))
            };
            let edge = (2.0 * of.terms() / n).sqrt();
            let error = |i: u32, way: f64| {
                let d = edge * f64::from(i) / 40_000.0;
                // Rounded to nearest, ties either way.
                [0.5, 0.499]
                    .map(|nudge| (fixed((d + way * off).abs(), nudge) - exact(d)).abs())
                    .into_iter()
                    .fold(0.0, f64::max)
            };
            let worst =
                (0..42_000).flat_map(|i| [-1.0, 1.0].map(|way| error(i, way))).fold(0.0, f64::max);
            assert!(
                worst <= bound && worst > 0.7 * bound,
                "k {squarings} n {n}: {worst} against {bound}"
            );
        }
    }
}

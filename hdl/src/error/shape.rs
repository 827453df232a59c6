//! How far highlights are off.
use specula_datapath::bound::{Bound, ErrorModel, VectorBound};
use specula_spec::lyon::LyonSpec;

use super::length_error::LengthError;

/// Steps from the middle of a highlight to its edge in which bounds are looked for; what grows
/// counts at a step's end, what falls at its begin.
const STEPS: u32 = 2048;

/// Bound on the error of f of D, 1 at most. `shininess` is n over the odd power of K. The length of D
/// is off by `length_error`.
///
/// Where the odd power is above 1, the host has rounded n over it, by δ, half a step, at most: x/K is
/// off by as much as its share of n, and f by
///
/// ```text
/// K x/K (1 - x/K)^(K-1) δ/m ≤ (1 - 1/K)^(K-1) δ/m    m the least that n over the odd power may be
/// ```
pub fn bound(d: VectorBound, length_error: LengthError, shininess: Bound, lyon: &LyonSpec) -> f64 {
    let (by_host, n) = (rounded_by_host(shininess, lyon), largest_exponent(shininess, lyon));
    (of_exponent(d, length_error, n, lyon) + by_host).min(1.0)
}

/// What the host's rounding adds to the error of f.
fn rounded_by_host(shininess: Bound, lyon: &LyonSpec) -> f64 {
    let (half_step, terms) = (0.5 * shininess.ulp, f64::from(lyon.terms()));
    match (lyon.odd_power, shininess.fixed.low - half_step) {
        (1, _) => 0.0,
        (_, least) if least > 0.0 => (1.0 - 1.0 / terms).powf(terms - 1.0) * half_step / least,
        _ => 1.0,
    }
}

/// The largest n that a share of it, as the host rounds it, may be of.
fn largest_exponent(shininess: Bound, lyon: &LyonSpec) -> f64 {
    match lyon.odd_power {
        1 => shininess.magnitude(),
        odd => f64::from(odd) * (shininess.magnitude() + 0.5 * shininess.ulp),
    }
}

/// Bound on the error of f of D for exponents up to `shininess`; 1 at most. The length of D is off by
/// `length_error`.
///
/// As a function of d = |D|, with y = d √(n/2K)
///
/// ```text
/// f          = (1 - y²)^K                 0 from y = 1 on
/// |df/dd|    = √(2Kn) y (1 - y²)^(K-1)
/// |df/dd| d  = 2K y² (1 - y²)^(K-1)
/// |df/dd|/d  = n (1 - y²)^(K-1)
/// ```
///
/// Each counts as often as [`LengthError`] says, or the first as often as D is off as a whole.
/// Smaller exponents have no more of any at the same y.
///
/// Then f of the fixed D, with y', is rounded, and its squares truncated: see `Highlight::rounding`.
/// y' is no further from any y on the way to it than √(n/2K) times what D is off.
fn of_exponent(d: VectorBound, length_error: LengthError, shininess: f64, lyon: &LyonSpec) -> f64 {
    let n = shininess * f64::from(1u32 << lyon.difference.log2_exponent_factor());
    let powers = Powers { odd: lyon.odd_power, squarings: lyon.squarings };
    let highlight = Highlight {
        n,
        powers,
        ulp: lyon.formats.shape.ulp(),
        truncated: lyon.formats.truncated(lyon.formats.difference),
    };
    let whole = LengthError::whole(d.error.length);
    let moved = (n / (2.0 * highlight.terms())).sqrt() * whole.level;
    // Of most D nothing more is known than of the whole.
    let of_length = if length_error == whole { 1.0 } else { highlight.worst(length_error, moved) };
    of_length.min(highlight.worst(whole, moved)).min(1.0)
}

/// How the base comes to the power K.
#[derive(Clone, Copy, Debug)]
struct Powers {
    odd: u32,
    squarings: u32,
}

impl Powers {
    /// K.
    fn terms(self) -> u32 {
        self.odd << self.squarings
    }

    /// The powers e that are rounded after the base, in their order, each with the number of times
    /// that it is a factor of the result.
    fn rounded(self) -> Vec<(u32, u32)> {
        let mut steps = vec![];
        for digit in (0..self.odd.ilog2()).rev() {
            // The leading digits of the odd power, and how often the rest squares them.
            let (leading, times) = (self.odd >> digit, 1 << (digit + self.squarings));
            if leading % 2 == 1 {
                steps.push((leading - 1, times));
            }
            steps.push((leading, times));
        }
        let squares = (1..=self.squarings).map(|i| (self.odd << i, 1 << (self.squarings - i)));
        steps.into_iter().chain(squares).collect()
    }

    /// What the base counts as at least in the share that a rounding has of the result: with it every
    /// power e but the last has c^(e-1) K ≥ 1/2.
    fn floor(self) -> f64 {
        let rounded = self.rounded();
        let largest = rounded.iter().rev().nth(1).map_or(1, |(power, _)| *power);
        let twice = 2.0 * f64::from(self.terms());
        let least = match largest {
            1 => 0.0,
            power => twice.powf(-1.0 / f64::from(power - 1)),
        };
        least.max(0.5)
    }
}

/// f for one exponent.
struct Highlight {
    n: f64,
    powers: Powers,
    /// Unit of the last place of x/K and of powers.
    ulp: f64,
    /// What each square in D·D is less, at most.
    truncated: f64,
}

impl Highlight {
    /// K.
    fn terms(&self) -> f64 {
        f64::from(self.powers.terms())
    }

    /// Largest bound on the error for any y.
    fn worst(&self, length_error: LengthError, moved: f64) -> f64 {
        let at = |i| self.error(f64::from(i) / f64::from(STEPS), length_error, moved);
        // What is no number is no bound, and `f64::max` would pass it over.
        let known = |error: f64| if error.is_nan() { f64::INFINITY } else { error };
        (0..STEPS).map(at).map(known).fold(0.0, f64::max)
    }

    /// Bound on the error for y from `begin` on, a step long.
    fn error(
        &self,
        begin: f64,
        LengthError { level, growing, falling }: LengthError,
        moved: f64,
    ) -> f64 {
        let (terms, end) = (self.terms(), begin + f64::from(STEPS).recip());
        let base = (1.0 - begin * begin).powi(self.powers.terms() as i32 - 1);
        let of_length = (level * (2.0 * terms * self.n).sqrt() * end
            + growing * 2.0 * terms * end * end
            + falling * self.n)
            * base;
        of_length + self.rounding((begin - moved).max(0.0))
    }

    /// What rounding adds for y from `begin` on, with b for the real and the rounded 1 - y'².
    ///
    /// ```text
    /// K b^(K-1)     half a unit of x/K, raised to K, and what that lost before
    /// s b^(K-e)     half a unit of b^e, which is a factor of the result s times
    /// ```
    ///
    /// Of a product of two that are off, one's error counts times the mean of the other's real and
    /// rounded value. The powers b^e are off by e - 1/2 units: a square by twice as much as its root
    /// and a half, and a product with b by a unit more. So the mean is no more than the power of 1 -
    /// y'² + K units, b^e + e/2 units ≤ (b + K units)^e, as long as b^(e-1) K is 1/2 or more:
    /// [`Powers::floor`] is put for less.
    /// Three squares of D that are t less each make x/K = (n/2K) D·D less by 3t n/2K.
    fn rounding(&self, begin: f64) -> f64 {
        let lost = 3.0 * self.truncated * self.n / (2.0 * self.terms());
        let floor = self.powers.floor();
        let units = self.terms() * (self.ulp + lost);
        let base = ((1.0 - begin * begin).max(floor) + units).min(1.0);
        let terms = self.powers.terms() as i32;
        let of_power =
            |(power, times): (u32, u32)| f64::from(times) * base.powi(terms - power as i32);
        let of_x = self.terms() * base.powi(terms - 1);
        let of_powers: f64 = self.powers.rounded().into_iter().map(of_power).sum();
        lost * of_x + 0.5 * self.ulp * (of_x + of_powers)
    }
}

/// Where f_k made of u_c = m|D_c| 2^-h rounds.
#[derive(Clone, Copy, Debug)]
pub struct RootShape {
    /// K.
    terms: f64,
    /// 2^h.
    shift: f64,
    /// Unit of the last place of u_c.
    scaled: f64,
    /// Unit of the last place of x and of squares.
    shape: f64,
}

impl RootShape {
    /// The formats of a spec.
    pub fn of(lyon: &LyonSpec) -> RootShape {
        RootShape {
            terms: f64::from(lyon.terms()),
            shift: f64::from(1u32 << lyon.root_shift()),
            scaled: lyon.formats.scaled_difference.ulp(),
            shape: lyon.formats.shape.ulp(),
        }
    }

    /// Bound on the error of f, 1 at most. m counts as exact where it is an integer
    /// port, but is a rounded root: it is off by δ, half a step.
    ///
    /// As a function of |u|
    ///
    /// ```text
    /// f        = (1 - u²)^K         whose slope is [`steepest_slope`] for n = 2K
    /// |u' - u| ≤ m 2^-h |D' - D| + √3/2 u_u
    /// |f' - f| ≤ slope |u' - u|
    /// ```
    ///
    /// A step δ of m itself changes f by
    ///
    /// ```text
    /// 2K u² (1 - u²)^(K-1) δ/m ≤ 2 ((K-1)/K)^(K-1) δ/m
    /// ```
    ///
    /// at the smallest m. Rounding x and each power adds K - 1/2 units of the last place.
    pub fn error(self, d: VectorBound, m: Bound) -> f64 {
        let (off, half_step) = (d.error.length, 0.5 * m.ulp);
        let terms = self.terms;
        let (smallest, largest) = (m.fixed.low - half_step, m.fixed.high + half_step);
        if smallest <= 0.0 {
            // A root of a share of n that may be 0 is off by any part of itself.
            return 1.0;
        }
        let e_u = largest / self.shift * off + 0.75f64.sqrt() * self.scaled;
        let of_m = 2.0 * ((terms - 1.0) / terms).powf(terms - 1.0) * half_step / smallest;
        let error = steepest_slope(terms, 2.0 * terms) * e_u + of_m + (terms - 0.5) * self.shape;
        error.min(1.0)
    }
}

/// What is known of the highlights f of several lights that are `apart` or more: that no two of them
/// are near their middle at once.
///
/// Of R - L for two lights the difference is that of the lights, whatever R is: so of all D all but
/// one are at least half as long as lights are apart. With exponents from `least_dark_exponent`
/// on, f is 0 there; with others every f is off by what it is off for those. Nothing is known where
/// no exponent is as large, or f may be anything.
pub fn alone(
    f: Bound,
    (d, length_error): (VectorBound, LengthError),
    shininess: Bound,
    apart: f64,
    lyon: &LyonSpec,
) -> Option<ErrorModel> {
    let dark = least_dark_exponent(apart / 2.0 - d.error.length, lyon);
    let known = dark < largest_exponent(shininess, lyon) && f.error < 1.0;
    let together = of_exponent(d, length_error, dark, lyon) + rounded_by_host(shininess, lyon);
    known.then(|| ErrorModel::Exclusive { together: together.min(1.0) })
}

/// The least exponent from which on f is 0 wherever D is no shorter than `shortest`: n d² ≥ 2K.
fn least_dark_exponent(shortest: f64, lyon: &LyonSpec) -> f64 {
    if shortest > 0.0 {
        2.0 * f64::from(lyon.terms()) / (shortest * shortest)
    } else {
        f64::INFINITY
    }
}

/// Largest |df/d|D|| for exponents up to `n`, k being K.
///
/// ```text
/// √(2Kn) y (1 - y²)^(K-1)   is largest at y² = 1/(2K - 1)
/// ```
fn steepest_slope(k: f64, n: f64) -> f64 {
    let t = 1.0 / (2.0 * k - 1.0);
    (n * 2.0 * k * t).sqrt() * (1.0 - t).powf(k - 1.0)
}

#[cfg(test)]
mod tests {
    use specula_datapath::bound::Interval;
    use specula_fixtures::Draw;

    use super::*;

    /// 99 % of the bound is reached.
    #[test]
    fn the_slope_bound_is_met_and_not_exceeded() {
        for k in [1.0, 2.0, 3.0, 4.0, 8.0, 13.0, 16.0] {
            for n in [1.0, 16.0, 300.0, 8191.0] {
                let f = |d: f64| (1.0 - n * d * d / (2.0 * k)).max(0.0).powf(k);
                let step = 1e-5 / f64::sqrt(n);
                let slope = |i: i32| {
                    let d = f64::from(i) * 1e-3 / n.sqrt();
                    ((f(d + step) - f(d)) / step).abs()
                };
                let steepest = (0..4000).map(slope).fold(0.0, f64::max);
                let bound = steepest_slope(k, n);
                assert!(
                    steepest <= bound * 1.0001 && steepest > bound * 0.99,
                    "K {k} n {n}: {steepest} against {bound}"
                );
            }
        }
    }

    /// 70 % of the bound is reached.
    #[test]
    fn rounded_highlights_of_longer_and_shorter_vectors_stay_within_the_bound() {
        for ([odd, squarings], n, ulp, off, truncated) in [
            ([1, 0], 16.0, 1.0 / 1024.0, 1e-3, 0.0),
            ([1, 2], 256.0, 1.0 / 4096.0, 2e-4, 0.0),
            ([1, 3], 8191.0, 1.0 / 512.0, 2e-5, 0.0),
            ([1, 0], 16.0, 1.0 / 65536.0, 1e-5, 1e-3),
            ([1, 2], 256.0, 1.0 / 65536.0, 2e-4, 1e-5),
            ([3, 0], 64.0, 1.0 / 4096.0, 2e-4, 0.0),
            ([5, 1], 256.0, 1.0 / 4096.0, 2e-4, 0.0),
            ([1, 4], 256.0, 1.0 / 4096.0, 2e-4, 0.0),
            ([15, 0], 256.0, 1.0 / 4096.0, 2e-4, 0.0),
        ] {
            let of = Highlight { n, powers: Powers { odd, squarings }, ulp, truncated };
            let lost = 3.0 * truncated * n / (2.0 * of.terms());
            let level = LengthError { level: off, growing: 0.0, falling: 0.0 };
            let moved = (n / (2.0 * of.terms())).sqrt() * off;
            let bound = of.worst(level, moved);
            let exact = |d: f64| (1.0 - n * d * d / (2.0 * of.terms())).max(0.0).powf(of.terms());
            let fixed = |d: f64, nudge: f64| {
                let rounded = |x: f64| ((x / ulp + nudge).floor() * ulp).clamp(0.0, 1.0);
                // What rounds x down has truncated its squares besides.
                let lost = if nudge < 0.5 { lost } else { 0.0 };
                let base = 1.0 - rounded(n * d * d / (2.0 * of.terms()) - lost);
                let digits = (0..odd.ilog2()).rev();
                let to_odd = digits.fold(base, |f, digit| {
                    let square = rounded(f * f);
                    if odd >> digit & 1 == 1 { rounded(square * base) } else { square }
                });
                (0..squarings).fold(to_odd, |b, _| rounded(b * b))
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
                "K {} n {n}: {worst} against {bound}",
                of.terms()
            );
        }
    }

    /// Every power that is computed on the way to K is listed, and the last is K itself.
    #[test]
    fn powers_lead_to_the_result() {
        for (odd, squarings, wanted) in [
            (1, 0, vec![]),
            (1, 2, vec![(2, 2), (4, 1)]),
            (3, 1, vec![(2, 2), (3, 2), (6, 1)]),
            (5, 0, vec![(2, 2), (4, 1), (5, 1)]),
            (7, 0, vec![(2, 2), (3, 2), (6, 1), (7, 1)]),
        ] {
            assert_eq!(Powers { odd, squarings }.rounded(), wanted, "{odd} {squarings}");
        }
    }

    /// D of any length up to the edge: 95 % of the bound is reached.
    #[test]
    fn shapes_of_roots_stay_within_the_bound_and_come_near() {
        let mut draw = Draw::new(1);
        for (squarings, m, off) in [(0, 5.0, 1e-3), (1, 9.0, 1e-3), (3, 60.0, 2e-4)] {
            let terms = 2f64.powi(squarings);
            let of = RootShape { terms, shift: 4.0, scaled: 1.0 / 4096.0, shape: 1.0 / 65536.0 };
            let (half_step, edge) = (0.01 * m / terms, of.shift / m);
            let root = Bound { ulp: 2.0 * half_step, ..Bound::near(Interval::new(m, m), 0.0) };
            let bound = of.error(VectorBound::ball(0.0, 2.0, off), root);
            let mut reached = 0.0_f64;
            for _ in 0..40_000 {
                let direction = draw.direction().abs();
                let d = edge * draw.within(0.0, 1.0) * direction;
                let exact = (d / edge).length_squared();
                let real = (1.0 - exact).max(0.0).powf(terms);
                let d = d + draw.error(off) * direction;
                let error = draw.error(1.0);
                let u = (d * (m + error.signum() * half_step) / of.shift)
                    .map(|u| u.abs() + (0.5 * of.scaled).copysign(error));
                let half_unit = (0.5 * of.shape).copysign(error);
                let base = (1.0 - u.length_squared() - half_unit).clamp(0.0, 1.0);
                let fixed = (0..squarings).fold(base, |b, _| b * b - half_unit);
                reached = reached.max((fixed - real).abs() / bound);
            }
            assert!(reached <= 1.0 && reached > 0.95, "k {squarings}, m {m}: {reached}");
        }
    }
}

//! How long the differences are that highlights depend on, and how far they are off.
use specula_datapath::bound::{VectorBound, VectorError};
use specula_spec::Format;

use super::length_error::{LengthError, Reflected};

/// What is proven of a difference D before it is rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// D is no longer.
    pub longest: f64,
    /// How far D is off as a whole.
    pub error: f64,
    /// Where that is proven.
    pub proof: &'static str,
}

/// H × N with H = L + V.
///
/// ```text
/// |H × N|           ≤ |H||N|,   |H| ≤ 2 but for rounding and for what L and V are longer than 1
/// |H' × N' - H × N| ≤ |H| e_N + |N| e_H + e_H e_N + √3 t
/// ```
///
/// for products that truncation makes smaller by less than t, `truncated`: a component is off by less.
pub fn cross_product([h, n]: [VectorBound; 2], vector: Format, truncated: f64) -> Difference {
    let longest_h = h.longest.max(2.0 + 2.0 * vector.ulp());
    let (e_h, e_n) = (h.error.length, n.error.length);
    let truncated = 3f64.sqrt() * truncated;
    Difference {
        longest: longest_h * n.longest + truncated,
        error: longest_h * e_n + n.longest * e_h + e_h * e_n + truncated,
        proof: "error::difference::cross_product",
    }
}

/// 2(n·v)n - v - l: the unit vector v reflected about n, less the unit vector l.
///
/// It is no longer than the reflection and l as they come, and what rounding each component adds.
///
/// ```text
/// 2(n·v)n     = |n|² (R + v)   for the reflection R about n's direction
/// |2(n·v)n-v| ≤ |v| max(1, 2|n|² - 1)
/// ```
///
/// With n' off by a across and λ along n:
///
/// ```text
/// |R' - R|       ≤ 2a/|n'|               R turns by twice the angle that n does
/// ||n'|² - |n|²| ≤ 2|n| λ + λ² + a²
/// |of n|         ≤ 2|n'| a + 2(2|n| λ + λ² + a²)
/// |of v|         ≤ e_v max(1, 2|n|² - 1)  reflecting about n stretches by no more
/// |of l|         ≤ e_l
/// |rounding|     ≤ |n| u/2               of 2(n·v)
/// ```
pub fn reflection(
    [n, v, l]: [VectorBound; 3],
    (vector, difference): (Format, Format),
) -> Difference {
    let ulp = difference.ulp();
    let VectorError { transverse: across, radial: along, .. } = n.error;
    let square = 2.0 * n.longest * along + along * along + across * across;
    let of_n = 2.0 * (n.longest + along + across) * across + 2.0 * square;
    let of_vectors =
        v.error.length * (2.0 * (n.longest + along).powi(2) - 1.0).max(1.0) + l.error.length;
    Difference {
        longest: v.longest * (2.0 * n.longest * n.longest - 1.0).max(1.0)
            + l.longest
            + 7.0 * vector.ulp()
            + 8.0 * ulp,
        error: of_n + of_vectors + 0.5 * n.longest * ulp,
        proof: "error::difference::reflection",
    }
}

/// How far the length of the same D is off once it is rounded.
pub fn reflection_length([n, v, l]: [VectorBound; 3], difference: Format) -> LengthError {
    let ulp = difference.ulp();
    LengthError::of_reflection(&Reflected {
        n: n.error,
        lengths: (n.surely().max(0.0), n.longest + n.error.length),
        of: v.error.length,
        from: l.error.length,
        rounding_along: 0.5 * ulp,
        rounding: 0.75f64.sqrt() * ulp,
    })
}

/// (H·N)N - H.
///
/// With r = |N|, the part along N is (r² - 1) times that of H and the part across is that of H, and
/// rounding H·N to half a unit lengthens it by |N| u/2:
///
/// ```text
/// |D|      ≤ |H| max(1, r² - 1) + |N| u
/// |D' - D| ≤ 2|H||N| e_N + (|N|² + 1) e_H + |N| u/2
/// ```
///
/// where lengths are those of real vectors, longer than the fixed ones by their errors at most.
pub fn projection([h, n]: [VectorBound; 2], difference: Format) -> Difference {
    let ulp = difference.ulp();
    let (e_h, e_n) = (h.error.length, n.error.length);
    let (h_reach, n_reach) = (h.longest + e_h, n.longest + e_n);
    Difference {
        longest: h.longest * (n.longest * n.longest - 1.0).max(1.0) + n.longest * ulp,
        error: h_reach * (2.0 * n_reach * e_n)
            + (n_reach * n_reach + 1.0) * e_h
            + 0.5 * n_reach * ulp,
        proof: "error::difference::projection",
    }
}

/// h - N.
///
/// ```text
/// |h - N|         ≤ |h| + |N|
/// |h' - N' - D|   ≤ e_h + e_N
/// ```
pub fn minus([h, n]: [VectorBound; 2]) -> Difference {
    Difference {
        longest: h.longest + n.longest,
        error: h.error.length + n.error.length,
        proof: "error::difference::minus",
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_fixtures::Draw;

    use super::*;

    const VECTOR: Format = Format::signed(1, 14);

    /// The format of D: fine, or so coarse that products show what they are rounded by.
    const fn format(rounds: bool) -> Format {
        Format::signed(2, if rounds { 12 } else { 40 })
    }

    /// How far H is off, and n across and along itself, and whether products are rounded.
    const CASES: [(f64, f64, f64, bool); 5] = [
        (1e-4, 0.0, 0.0, false),
        (0.0, 1e-3, 0.0, false),
        (0.0, 0.0, 1e-3, false),
        (0.0, 0.0, 0.0, true),
        (3e-4, 2e-4, 1e-4, true),
    ];

    /// The largest error of a difference over its bound, for vectors of which the first is moved by
    /// any error of a size, and the last across and along itself.
    fn reached(
        (e_h, across, along, rounds): (f64, f64, f64, bool),
        length: f64,
        bound: impl Fn([VectorBound; 2], Format) -> Difference,
        difference: impl Fn(DVec3, DVec3, f64) -> DVec3,
    ) -> f64 {
        let half_unit = 0.5 * format(rounds).ulp();
        let h = VectorBound::ball(length, length + e_h, e_h);
        let n = VectorBound {
            error: VectorError::components(across, along),
            ..VectorBound::ball(1.0, 1.0 + along + across, 0.0)
        };
        let proven = bound([h, n], format(rounds));
        let mut draw = Draw::new(1);
        let mut reached = 0.0_f64;
        for _ in 0..20_000 {
            let (real_h, real_n) = (length * draw.direction(), draw.direction());
            let fixed_h = real_h + e_h * draw.direction();
            let fixed_n =
                real_n + draw.error(along) * real_n + draw.error(across) * draw.across(real_n);
            let fixed = difference(fixed_h, fixed_n, draw.error(half_unit));
            assert!(fixed.length() <= proven.longest, "{fixed} is longer than {proven:?}");
            let error = (fixed - difference(real_h, real_n, 0.0)).length();
            reached = reached.max(error / proven.error);
        }
        reached
    }

    /// Rounding of differences themselves comes later: those without a product have none.
    fn check(
        cases: &[(f64, f64, f64, bool)],
        least: f64,
        reached: impl Fn((f64, f64, f64, bool)) -> f64,
    ) {
        for &case in cases {
            let reached = reached(case);
            println!("{case:?}: {reached}");
            assert!(reached <= 1.0 + 1e-9 && reached > least, "{case:?}: {reached}");
        }
    }

    /// 99 % of the bound is reached.
    #[test]
    fn cross_products_stay_within_the_bound_and_reach_it() {
        let bound = |of, difference: Format| cross_product(of, VECTOR, 0.5 * difference.ulp());
        let d = |h: DVec3, n: DVec3, truncated: f64| h.cross(n) + DVec3::splat(truncated);
        check(&CASES[..4], 0.99, |case| reached(case, 2.0, bound, d));
    }

    #[test]
    fn reflections_stay_within_the_bound_and_reach_it() {
        let light = VectorBound::ball(1.0, 1.0, 0.0);
        let bound =
            |[v, n]: [VectorBound; 2], difference| reflection([n, v, light], (VECTOR, difference));
        let l = DVec3::Z;
        let difference =
            |v: DVec3, n: DVec3, rounding: f64| (2.0 * n.dot(v) + rounding) * n - v - l;
        check(&CASES, 0.5, |case| reached(case, 1.0, bound, difference));
    }

    #[test]
    fn projections_stay_within_the_bound_and_reach_it() {
        let difference = |h: DVec3, n: DVec3, rounding: f64| (h.dot(n) + rounding) * n - h;
        check(&CASES, 0.49, |case| reached(case, 2.0, projection, difference));
    }

    /// 99 % of the bound is reached.
    #[test]
    fn plain_differences_stay_within_the_bound_and_reach_it() {
        check(&CASES[..3], 0.99, |case| reached(case, 1.0, |of, _| minus(of), |h, n, _| h - n));
    }
}

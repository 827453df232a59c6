//! How far the length of a vector D is off: a highlight depends on that alone.
use specula_datapath::bound::{Sensitivity, VectorError};

/// On a way from the real D to the fixed one, |D| = d changes by no more than `level` + `growing` ·
/// d + `falling`/d in all, if it were d all the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthError {
    /// Whatever d is.
    pub level: f64,
    /// What grows with d.
    pub growing: f64,
    /// What falls with it.
    pub falling: f64,
}

/// What D = 2(n·v)n - v - l is made of.
pub struct Reflected {
    /// How far n is off.
    pub n: VectorError,
    /// From which length to which n goes at most on its way.
    pub lengths: (f64, f64),
    /// How far the real unit vector v is off.
    pub of: f64,
    /// How far the real unit vector l is off.
    pub from: f64,
    /// What is added in the direction of n, before D is rounded.
    pub rounding_along: f64,
    /// What is added in any direction.
    pub rounding: f64,
}

impl LengthError {
    /// Of a vector that is off by no more than `error` as a whole.
    pub const fn whole(error: f64) -> LengthError {
        LengthError { level: error, growing: 0.0, falling: 0.0 }
    }

    /// Of D = 2(n·v)n - v - l for about unit vectors, where n may be longer and shorter. [Lyon, TR
    /// 43, fig. 7; methods B1, B2]
    ///
    /// Let all errors grow from nothing at the same rate, and let n̂ and v̂ be directions, ρ = |n| and
    /// ν = |v| on the way, and
    ///
    /// ```text
    /// R = 2(n̂·v̂)n̂ - v̂,   c = n̂·v̂ = n̂·R,   s = n̂·D̂,   p = D̂·R
    /// ```
    ///
    /// 1. |D| changes by D̂ times what D does:
    ///
    ///    ```text
    ///    w·(change of n)   for w = 2ρν(c D̂ + s v̂)
    ///    that of v         times max(1, 2ρ² - 1), as reflecting stretches by no more
    ///    that of l, and what rounding adds
    ///    ```
    ///
    /// 2. D̂ is p R and √(1 - p²) across R. Where D̂ lies across R, |s| ≤ √(1 - c²) and v̂·D̂ = 2cs;
    ///    for D̂ = R, c D̂ + s v̂ is 2c² long:
    ///
    ///    ```text
    ///    |c D̂ + s v̂|² = c² + s² + 4c²s² ≤ 2
    ///    |w|          ≤ 2ρν(√2 + 2|p|)
    ///    ```
    ///
    /// 3. Along n̂, with |s| ≤ |p||c| + √(1 - c²):
    ///
    ///    ```text
    ///    |w·n̂| = 4ρν|cs|
    ///          ≤ 2ρν(1 + 2|p|)
    ///    ```
    ///
    /// 4. Across n̂:
    ///
    ///    ```text
    ///    |w × n̂| ≤ 2ρν(|c|√(1 - s²) + |s|√(1 - c²))
    ///            ≤ 2ρν
    ///    ```
    ///
    /// 5. The real n is turned from the one on the way by φ at most, which mixes 3 and 4 by |w| φ ≤
    ///    4ρν φ.
    ///
    /// 6. D = R - m with ||m| - 1| ≤ μ: what l is off, what ρ²ν and ρ² differ from 1 and what
    ///    rounding adds. So
    ///
    ///    ```text
    ///    |D·R| = |d² + 1 - |m|²|/2
    ///    |p|   ≤ d/2 + (μ + μ²/2)/d
    ///    ```
    pub fn of_reflection(of: &Reflected) -> LengthError {
        let (shortest, longest) = of.lengths;
        let turned = if shortest > 0.0 { of.n.transverse / shortest } else { f64::INFINITY };
        let rounding = of.rounding_along * longest + of.rounding;
        let stretch = (longest * longest - 1.0).max(1.0 - shortest * shortest).max(0.0);
        let reach = longest * (1.0 + of.of);
        let m = of.from + stretch * (2.0 + of.of) + longest * longest * of.of + rounding;
        let mixed = 4.0 * turned;
        let level = of.n.propagated(Sensitivity {
            transverse: 2.0 + mixed,
            radial: 2.0 + mixed,
            isotropic: 8f64.sqrt(),
        });
        let with_p =
            reach * of.n.propagated(Sensitivity { transverse: 0.0, radial: 4.0, isotropic: 4.0 });
        LengthError {
            level: reach * level
                + of.of * (2.0 * longest * longest - 1.0).max(1.0)
                + of.from
                + rounding,
            growing: with_p / 2.0,
            falling: with_p * (m + m * m / 2.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_fixtures::Draw;

    use super::*;

    fn difference(n: DVec3, v: DVec3, l: DVec3) -> DVec3 {
        2.0 * n.dot(v) * n - v - l
    }

    /// Errors of n in any direction, along n and across it: 90 % of the bound is reached by each.
    #[test]
    fn lengths_of_reflections_stay_within_the_bound_and_reach_it() {
        const SIZE: f64 = 1e-5;
        let mut draw = Draw::new(5);
        let mut reached = [0.0_f64; 3];
        for round in 0..400_000 {
            let (n, v) = (draw.direction(), draw.direction());
            let r = 2.0 * n.dot(v) * n - v;
            let apart = [0.003, 0.03, 0.3][round % 3];
            let l = (r + apart * draw.direction()).normalize();
            let (kind, error, off) = match round / 3 % 3 {
                0 => (0, draw.direction(), VectorError::ball(SIZE)),
                1 => (1, n, VectorError::components(0.0, SIZE)),
                _ => (2, draw.across(n), VectorError::components(SIZE, 0.0)),
            };
            let from = difference(n, v, l).length();
            let to = difference(n + SIZE * error, v, l).length();
            let stated = LengthError::of_reflection(&Reflected {
                n: off,
                lengths: (1.0 - SIZE, 1.0 + SIZE),
                of: 0.0,
                from: 0.0,
                rounding_along: 0.0,
                rounding: 0.0,
            });
            let allowed =
                stated.level + stated.growing * from.max(to) + stated.falling / from.min(to);
            let share = (from - to).abs() / allowed;
            assert!(share <= 1.0, "n {n} v {v} l {l}, off by {error}: {from} and {to}");
            reached[kind] = reached[kind].max(share);
        }
        println!("{reached:?}");
        assert!(reached.iter().all(|&share| share > 0.9), "{reached:?}");
    }

    /// n may be anywhere: how far it turns has no limit, and none of it is across or along n alone.
    #[test]
    fn of_a_normal_that_may_be_anywhere_nothing_is_known() {
        let of = Reflected {
            n: VectorError::ball(2.0),
            lengths: (-1.0, 3.0),
            of: 0.0,
            from: 0.0,
            rounding_along: 0.0,
            rounding: 0.0,
        };
        let LengthError { level, growing, falling } = LengthError::of_reflection(&of);
        assert_eq!([level, growing, falling].map(f64::is_nan), [false; 3]);
        assert!(level > 2.0, "{level}");
    }
}

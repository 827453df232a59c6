//! How far the length of a vector D is off: a highlight depends on that alone.
use crate::builder::{Gains, Off, Vector};

/// On a way from the real D to the fixed one, |D| = d changes by no more than `level` + `growing` ·
/// d + `falling`/d in all, if it were d all the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LengthOff {
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
    pub n: Off,
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

impl LengthOff {
    /// Of a vector that is off by no more than is known of it as a whole.
    pub fn of(d: &Vector) -> LengthOff {
        LengthOff { level: d.off().length, growing: 0.0, falling: 0.0 }
    }

    /// Of D = 2(n·v)n - v - l for about unit vectors, where n may be longer and shorter. [Lyon, TR
    /// 43, fig. 7; methods B1, B2]
    ///
    /// Let all errors grow from nothing at the same rate, and let n̂ and v̂ be directions, R =
    /// 2(n̂·v̂)n̂ - v̂, c = n̂·v̂ = n̂·R, s = n̂·D̂, p = D̂·R, ρ = |n| and ν = |v| on the way.
    ///
    /// - |D| changes by D̂ times what D does: w·(change of n) for w = 2ρν(c D̂ + s v̂), that of v
    ///   times max(1, 2ρ² - 1), since reflecting stretches by no more, that of l, and what rounding
    ///   adds.
    /// - D̂ is p R and √(1 - p²) across R. Where D̂ lies across R, |s| ≤ √(1 - c²) and v̂·D̂ = 2cs,
    ///   so |c D̂ + s v̂|² = c² + s² + 4c²s² ≤ 2; for D̂ = R it is 2c² long. So |w| ≤ 2ρν(√2 +
    ///   2|p|).
    /// - w·n̂ = 4ρν cs, and |s| ≤ |p||c| + √(1 - c²): along n̂ it is 2ρν(1 + 2|p|) at most.
    /// - Across n̂ it is |c|√(1 - s²) + |s|√(1 - c²) ≤ 1 times 2ρν. The real n is turned from the
    ///   one on the way by φ at most, which mixes both by
    ///   |w| φ ≤ 4ρν φ.
    /// - D = R - m with | |m| - 1 | ≤ μ, what l is off, what ρ²ν and ρ² differ from 1 and what
    ///   rounding adds; so |D·R| = |d² + 1 - |m|²|/2 and |p| ≤ d/2 + (μ + μ²/2)/d.
    pub fn of_reflection(of: &Reflected) -> LengthOff {
        let (shortest, longest) = of.lengths;
        let turned = if shortest > 0.0 { of.n.across / shortest } else { f64::INFINITY };
        let rounding = of.rounding_along * longest + of.rounding;
        let stretch = (longest * longest - 1.0).max(1.0 - shortest * shortest).max(0.0);
        let reach = longest * (1.0 + of.of);
        let m = of.from + stretch * (2.0 + of.of) + longest * longest * of.of + rounding;
        let mixed = 4.0 * turned;
        let level =
            of.n.times(Gains { across: 2.0 + mixed, along: 2.0 + mixed, free: 8f64.sqrt() });
        let with_p = reach * of.n.times(Gains { across: 0.0, along: 4.0, free: 4.0 });
        LengthOff {
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
    use super::*;

    type V = [f64; 3];

    fn dot(a: V, b: V) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    fn plus(a: V, b: V, times: f64) -> V {
        std::array::from_fn(|i| a[i] + times * b[i])
    }

    fn unit(a: V) -> V {
        a.map(|x| x / dot(a, a).sqrt())
    }

    /// Numbers from -1 to 1.
    fn noise(seed: &mut u64) -> f64 {
        *seed =
            seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    #[test]
    fn lengths_of_reflections_stay_within_what_is_stated() {
        let mut seed = 5;
        let mut used = [0.0_f64; 3];
        let difference =
            |n: V, v: V, l: V| plus(plus(n.map(|x| 2.0 * dot(n, v) * x), v, -1.0), l, -1.0);
        for round in 0..400_000 {
            let mut random = || unit([0; 3].map(|_| noise(&mut seed)));
            let (n, v) = (random(), random());
            let r = plus(n.map(|x| 2.0 * dot(n, v) * x), v, -1.0);
            let d = [0.003, 0.03, 0.3][round % 3];
            let l = unit(plus(r, random(), d));
            let size = 1e-5;
            let (error, kind) = match round / 3 % 3 {
                0 => (random().map(|x| x * size), Off::within(size)),
                1 => (n.map(|x| x * size), Off::parts(0.0, size)),
                _ => {
                    let across = random();
                    (
                        unit(plus(across, n, -dot(across, n))).map(|x| x * size),
                        Off::parts(size, 0.0),
                    )
                }
            };
            let exact = difference(n, v, l);
            let fixed = difference(plus(n, error, 1.0), v, l);
            let (from, to) = (dot(exact, exact).sqrt(), dot(fixed, fixed).sqrt());
            let stated = LengthOff::of_reflection(&Reflected {
                n: kind,
                lengths: (1.0 - size, 1.0 + size),
                of: 0.0,
                from: 0.0,
                rounding_along: 0.0,
                rounding: 0.0,
            });
            let shorter = from.min(to);
            let allowed = stated.level + stated.growing * from.max(to) + stated.falling / shorter;
            let share = (from - to).abs() / allowed;
            assert!(
                share <= 1.0,
                "n {n:?} v {v:?} l {l:?}, off by {error:?}: {from} and {to}, {allowed} allowed"
            );
            used[round / 3 % 3] = used[round / 3 % 3].max(share);
        }
        assert!(used.iter().all(|&share| share > 0.9), "{used:?}");
    }
}

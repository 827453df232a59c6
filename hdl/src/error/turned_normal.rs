//! How far normals are off that are put together along an arc and brought to unit length.
//!
//! N = u P + v Q, and n = N (3 - N·N)/2. [lecture, eq. 4.7; methods A8, A9, A11]
use specula_datapath::bound::{VectorBound, VectorError};
use specula_spec::slerp::SlerpFormats;

use super::rotation::{drift, scaled_drift};

/// What is known of the weights that a normal is put together with.
#[derive(Clone, Copy, Debug)]
pub struct Weighing {
    /// By how much both are off, as a length in the plane where their vectors are orthonormal, and
    /// as a sum where they are the ends.
    off: f64,
    /// What both add up to at most.
    sum: f64,
    /// Length of the shortest normal that is put together.
    shortest: f64,
}

impl Weighing {
    /// Of cosine and sine, after `steps` turns at most: |cos t| + |sin t| ≤ √2.
    pub fn orthonormal(formats: &SlerpFormats, steps: u32) -> Weighing {
        let off = drift(formats, steps) + 0.5f64.sqrt() * formats.weight.ulp();
        Weighing { off, sum: 2f64.sqrt(), shortest: 1.0 }
    }

    /// Between the ends:
    ///
    /// ```text
    /// sin((1 - t) f)/sin f + sin(t f)/sin f = cos((1/2 - t) f)/cos(f/2)
    ///                                       ≤ 1/cos(f/2)
    /// ```
    ///
    /// where cos(f/2) is the length of the chord's middle, `shortest_chord` or more, and f is 170
    /// degrees at most. Below 10 degrees chords do, no shorter than cos 5°.
    pub fn between_ends(formats: &SlerpFormats, steps: u32, shortest_chord: f64) -> Weighing {
        let narrowest = 85f64.to_radians().cos();
        let off = 2.0 * (scaled_drift(formats, steps) + 0.5 * formats.weight.ulp());
        Weighing {
            off,
            sum: (1.0 / shortest_chord.max(narrowest)).max(2f64.sqrt()),
            shortest: 5f64.to_radians().cos(),
        }
    }

    /// How far N is off before it is rounded, of P and Q as they come; so N is no longer than 1 and
    /// this.
    ///
    /// ```text
    /// |N' - N| ≤ |(u' - u) P' + (v' - v) Q'| + |u (P' - P) + v (Q' - Q)|
    ///          ≤ e_w max |P'|, |Q'| + (|u| + |v|) max e_P, e_Q
    /// ```
    pub fn put_together(self, [p, q]: [VectorBound; 2]) -> f64 {
        let off = p.error.length.max(q.error.length);
        self.off * p.longest.max(q.longest) + self.sum * off
    }

    /// How far n is off before it is rounded, of N off by e, with (3 - N·N)/2 off by
    /// `half_unit`. Real N is l or more long and 1 or less.
    ///
    /// ```text
    /// |n'|   ≤ 1 + half_unit (1 + e)
    /// across ≤ |n'| e/√(l (l - e))       the distance of the directions of N' and N
    /// along  ≤ max |dρ/dr| e + half_unit (1 + e) + across²/2
    /// ```
    ///
    /// with the length ρ = r (3 - r²)/2, whose slope 3/2 (1 - r²) is steepest at r = l - e or 1 + e.
    pub fn lengthened(self, turned: VectorBound, half_unit: f64) -> VectorError {
        let (e, shortest) = (turned.error.length, self.shortest);
        if e >= shortest / 2.0 {
            return VectorError::ball(2.0 + half_unit);
        }
        let longer = half_unit * (1.0 + e);
        let across = (1.0 + longer) * e / (shortest * (shortest - e)).sqrt();
        let slope = 1.5 * (1.0 - (shortest - e).powi(2)).max((1.0 + e).powi(2) - 1.0);
        VectorError::components(across, slope * e + longer + across * across / 2.0)
    }
}

/// n is no longer before it is rounded: l (3 - l²)/2 ≤ 1 for any length l, and rounding (3 - N·N)/2
/// adds |N| half a unit.
pub fn longest(longest: f64, half_unit: f64) -> f64 {
    1.0 + half_unit * longest
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;

    use super::*;

    /// 99 % of the bound across N is reached, and 55 % along it.
    #[test]
    fn normals_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (shortest, error, half_unit) in
            [(1.0, 1e-3, 1e-6), (5f64.to_radians().cos(), 1e-3, 1e-6), (1.0, 1e-5, 1e-3)]
        {
            let weighing = Weighing { off: 0.0, sum: 1.0, shortest };
            let proven = weighing.lengthened(VectorBound::ball(shortest, 1.0, error), half_unit);
            let most = longest(1.0 + error, half_unit);
            let mut reached = [0.0_f64; 2];
            for _ in 0..20_000 {
                let direction = draw.direction();
                let real =
                    direction * (shortest + (1.0 - shortest) * draw.within(0.0, 1.0).powi(4));
                let moved = [direction, draw.across(direction), draw.direction()];
                let fixed = real + draw.one_of(&moved) * draw.error(error);
                let real = real * (3.0 - real.length_squared()) / 2.0;
                let fixed = fixed * ((3.0 - fixed.length_squared()) / 2.0 + draw.error(half_unit));
                assert!(fixed.length() <= most);
                let along = (fixed - real).dot(direction);
                let across = (fixed - real - along * direction).length();
                reached[0] = reached[0].max(across / proven.transverse);
                reached[1] = reached[1].max(along.abs() / proven.radial);
            }
            println!("{shortest}, {error}, {half_unit}: {reached:?}");
            assert!(reached.iter().all(|&share| share <= 1.0), "{shortest}: {reached:?}");
            assert!(reached[0] > 0.99 && reached[1] > 0.55, "{shortest}: {reached:?}");
        }
    }

    /// Weights off in any direction of the plane, and axes off in any: 99 % of the bound is reached.
    #[test]
    fn sums_stay_within_the_bound_and_reach_it() {
        let mut draw = Draw::new(1);
        for (off, of_axes) in [(1e-3, 0.0), (0.0, 1e-3), (1e-3, 1e-3)] {
            let weighing = Weighing { off, sum: 2f64.sqrt(), shortest: 1.0 };
            let proven = weighing.put_together([VectorBound::ball(1.0, 1.0 + of_axes, of_axes); 2]);
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let p = draw.direction();
                let q = draw.across(p);
                let (v, u) = draw.within(0.0, 6.3).sin_cos();
                let (v_off, u_off) = draw.within(0.0, 6.3).sin_cos();
                let moved = draw.direction();
                let [of_p, of_q] = [0; 2].map(|_| draw.one_of(&[1.0, -1.0]) * of_axes * moved);
                let fixed = (u + off * u_off) * (p + of_p) + (v + off * v_off) * (q + of_q);
                reached = reached.max((fixed - u * p - v * q).length() / proven);
            }
            println!("{off}, {of_axes}: {reached}");
            assert!(reached <= 1.0 + 1e-9 && reached > 0.99, "{off}, {of_axes}: {reached}");
        }
    }
}

//! How long approximately normalised vectors are, and how far they are off. [methods B8, B9]
//!
//! N' is r long, z = r² and y = 1 - z. A polynomial in y is the first gain g, and Newton steps
//! make g (3 - z g²)/2 of it; n = g N'. Both ends of a span lie in the unit ball, so r ≤ 1 up to
//! rounding.
use specula_datapath::bound::{Bound, VectorBound, VectorError};
use specula_spec::Format;
use specula_spec::lyon::{LyonFormats, LyonSpec};

/// The polynomial that Newton steps begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FirstGain {
    /// 1 + y/2.
    G1,
    /// 1 + (y + y²)/2.
    G2,
}

/// An approximate normalisation, and where it rounds.
#[derive(Clone, Copy, Debug)]
pub struct Approximation {
    /// The first gain.
    pub first: FirstGain,
    /// Newton steps after it.
    pub newton_steps: u32,
    /// Of N' and n.
    pub vector: Format,
    /// Of z.
    pub length_squared: Format,
    /// Of g, g² and 3 - z g².
    pub gain: Format,
    /// What a square in z is less after it was truncated, at most.
    pub truncated: f64,
    /// Unit of the last place of z, which may have fewer bits than its format.
    pub z_ulp: f64,
}

/// What is proven of n, and of what is computed on the way to it.
#[derive(Clone, Copy, Debug)]
pub struct Normalised {
    /// z g² is no larger in any Newton step.
    pub largest_product: f64,
    /// n is no longer once it is rounded.
    pub longest: f64,
    /// Real n is no shorter, up to 1.
    pub shortest: f64,
    /// How far n is off before it is rounded.
    pub error: VectorError,
    /// Error of the bit z > 0.
    pub direction_error: f64,
}

/// What is proven of n = g N' for a spec's formats and Newton steps, of N' and of its squared length
/// z.
pub fn normalised(first: FirstGain, lyon: &LyonSpec, normal: VectorBound, z: Bound) -> Normalised {
    Approximation::new(first, lyon, z.ulp).normalised(normal)
}

impl Approximation {
    /// That of a spec, with z to `z_ulp`.
    pub fn new(first: FirstGain, lyon: &LyonSpec, z_ulp: f64) -> Approximation {
        let LyonFormats { vector, length_squared, gain, .. } = lyon.formats;
        Approximation {
            first,
            newton_steps: lyon.newton_steps,
            vector,
            length_squared,
            gain,
            truncated: lyon.formats.truncated(vector),
            z_ulp,
        }
    }

    /// What is proven for vectors within `bounds`.
    ///
    /// Roundings on the way to n add some units of the coarsest format's last place, and those of z
    /// and g² move z g² by less than the margin.
    pub fn normalised(&self, bounds: VectorBound) -> Normalised {
        let reach = longest_scaled(bounds.longest);
        let margin = 0.01 + 16.0 * self.coarsest_ulp();
        Normalised {
            largest_product: reach * reach + margin,
            longest: reach + 8.0 * self.coarsest_ulp(),
            shortest: shortest_scaled(self.first, self.newton_steps, bounds.shortest),
            error: self.off(bounds, reach),
            direction_error: self.direction_error(bounds),
        }
    }

    /// How far n is off before it is rounded, where no real n is longer than `reach`.
    ///
    /// Gains turn nothing, so with t as [`VectorBound::turn`] has it
    ///
    /// ```text
    /// across ≤ |n'| t
    /// along  ≤ |ρ' - ρ| + (|n'| t)²/2
    /// ```
    ///
    /// for the real length ρ = r g(r²) and the fixed one ρ' = r' g', where |r' - r| ≤ e and |g' -
    /// g(r'²)| ≤ e_g ([`Gain`]):
    ///
    /// ```text
    /// |ρ' - ρ| ≤ |r' g(r'²) - r g(r²)| + r' |g' - g(r'²)|
    ///          ≤ max |dρ/dr| e + (longest + e) e_g
    /// |n'|     ≤ max ρ + (longest + e) e_g
    /// ```
    fn off(&self, bounds: VectorBound, reach: f64) -> VectorError {
        let (longest, e) = (bounds.longest, bounds.error.length);
        let gain = self.gain_within(bounds);
        let of_gain = (longest + e) * gain.error;
        if bounds.surely() <= 0.0 {
            return VectorError::ball(2.0 * reach + of_gain);
        }
        // `reach` leaves room for small roundings.
        let longest_fixed = reach.max(longest_real(longest) + of_gain);
        let across = longest_fixed * bounds.turn();
        VectorError::components(across, gain.steepest_length * e + of_gain + across * across / 2.0)
    }

    /// 1 where rounding may decide whether z > 0.
    fn direction_error(&self, bounds: VectorBound) -> f64 {
        let surely = bounds.surely();
        let rounds_to_one =
            surely * surely >= 0.5 * self.length_squared.ulp() + 3.0 * self.truncated;
        if surely > 0.0 && rounds_to_one { 0.0 } else { 1.0 }
    }

    fn gain_within(&self, bounds: VectorBound) -> Gain {
        let ends = (bounds.surely(), bounds.longest + bounds.error.length);
        let first = Gain::first(self.first, ends, self.error_of_z(), self.gain.ulp());
        first.after_newton_steps(self.newton_steps)
    }

    /// What z is off by besides N': half a unit, and what three squares lost.
    fn error_of_z(&self) -> f64 {
        0.5 * self.z_ulp + 3.0 * self.truncated
    }

    fn coarsest_ulp(&self) -> f64 {
        let formats = [self.vector, self.length_squared, self.gain];
        formats.map(Format::ulp).into_iter().fold(self.truncated, f64::max)
    }
}

/// How long n = g N' can be with small roundings of g, for N' no longer than `longest`.
fn longest_scaled(longest: f64) -> f64 {
    longest_real(longest).max(1.002)
}

/// How long n = g N' can be for the exact g, for N' no longer than `longest`.
///
/// ```text
/// g1:          ρ = 3/2 r - 1/2 r³             ≤ 1
/// g2:          ρ = 2r - 3/2 r³ + 1/2 r⁵       ≤ 1.00176 up to r = 1, at r = 0.894
/// Newton step: ρ ← 3/2 ρ - 1/2 ρ³             ≤ 1
/// ```
///
/// Beyond r = 1 that of g2 grows.
fn longest_real(longest: f64) -> f64 {
    let beyond = 2.0 * longest - 1.5 * longest.powi(3) + 0.5 * longest.powi(5);
    if longest > 1.0 { beyond.max(1.00177) } else { 1.00177 }
}

/// How short n can be in exact arithmetic, up to 1: √(1 - residue), for the largest residue |1 - z g²| = |1 - ρ²|.
fn shortest_scaled(first: FirstGain, newton_steps: u32, shortest: f64) -> f64 {
    let gain = Gain::first(first, (shortest, 1.0), 0.0, 0.0).after_newton_steps(newton_steps);
    (1.0 - gain.residue).max(0.0).sqrt()
}

impl FirstGain {
    fn of(self, y: f64) -> f64 {
        match self {
            FirstGain::G1 => 1.0 + y / 2.0,
            FirstGain::G2 => 1.0 + (y + y * y) / 2.0,
        }
    }

    /// dg/dy.
    fn slope(self, y: f64) -> f64 {
        match self {
            FirstGain::G1 => 0.5,
            FirstGain::G2 => 0.5 + y,
        }
    }

    /// Largest |dρ/dr| of ρ = r g(r²) for r from `shortest` to `longest`, which is about 1.
    ///
    /// ```text
    /// g1: dρ/dr = 3/2 (1 - r²)
    /// g2: dρ/dr = 1/2 (1 - r²)(4 - 5r²), least at r² = 9/10: -1/40
    /// ```
    fn steepest_length(self, shortest: f64, longest: f64) -> f64 {
        let slope = |r: f64| {
            let y = 1.0 - r * r;
            match self {
                FirstGain::G1 => 1.5 * y,
                FirstGain::G2 => 0.5 * y * (5.0 * y - 1.0),
            }
        };
        slope(shortest).abs().max(slope(longest).abs()).max(0.025)
    }
}

/// What is known of g for N' from s to about 1 long, that is for y ≤ 1 - s².
#[derive(Clone, Copy)]
struct Gain {
    /// Largest g.
    largest: f64,
    /// e_g, bound on the error of g for this N'.
    error: f64,
    /// Largest |1 - z g²|.
    residue: f64,
    /// Largest slope of the length r g(r²) in r.
    steepest_length: f64,
    /// s.
    shortest: f64,
    /// e_z, what z is off by besides N'.
    error_of_z: f64,
    /// u, unit of the last place of g.
    ulp: f64,
}

impl Gain {
    /// The first gain is largest for the shortest N', and so is its slope, up to e_z beyond:
    ///
    /// ```text
    /// e_g ≤ (|dg/dy| + e_z) e_z + u/2
    /// ```
    ///
    /// 1 - z g² is largest at one of the ends, or 0.0036 where g2 overshoots.
    fn first(first: FirstGain, (shortest, longest): (f64, f64), error_of_z: f64, ulp: f64) -> Gain {
        let shortest = shortest.max(0.0);
        let y = 1.0 - shortest * shortest;
        let residue_at = |r: f64| (1.0 - (r * first.of(1.0 - r * r)).powi(2)).abs();
        Gain {
            largest: first.of(y),
            error: (first.slope(y) + error_of_z) * error_of_z + 0.5 * ulp,
            residue: residue_at(shortest).max(residue_at(longest)).max(0.0036),
            steepest_length: first.steepest_length(shortest, longest),
            shortest,
            error_of_z,
            ulp,
        }
    }

    fn after_newton_steps(self, steps: u32) -> Gain {
        (0..steps).fold(self, |gain, _| gain.after_newton_step())
    }

    /// g₊ = g (3 - z g²)/2.
    ///
    /// ```text
    /// ∂g₊/∂g = 3/2 (1 - z g²)      |·| ≤ 3/2 (residue + g² e_z + 2 g e_g)
    /// ∂g₊/∂z = -g³/2
    /// ```
    ///
    /// Rounding g² and 3 - z g² to u/2 each adds (z g + g) u/4 ≤ g u/2, and rounding g₊ u/2.
    ///
    /// With q = 1 - z g² the new residue and length are
    ///
    /// ```text
    /// 1 - z g₊² = 1 - (1 - q)(1 + q/2)² = 3/4 q² + 1/4 q³
    /// ρ₊ = ρ (3 - ρ²)/2,  dρ₊/dρ = 3/2 (1 - ρ²) = 3/2 q
    /// ```
    fn after_newton_step(self) -> Gain {
        let exact = if self.shortest > 0.0 { self.shortest.recip() } else { f64::INFINITY };
        let g = self.largest + self.error;
        let steepest_in_g = 1.5 * (self.residue + g * g * self.error_of_z + 2.0 * g * self.error);
        Gain {
            largest: exact.min(1.5 * self.largest),
            error: steepest_in_g * self.error
                + g.powi(3) / 2.0 * self.error_of_z
                + (g / 2.0 + 0.5) * self.ulp,
            residue: 0.75 * self.residue.powi(2) + 0.25 * self.residue.powi(3),
            steepest_length: 1.5 * self.residue * self.steepest_length,
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use specula_fixtures::Draw;

    use super::*;

    /// First gain, Newton steps, and how short the shortest N' is.
    const CASES: [(FirstGain, u32, f64); 6] = [
        (FirstGain::G1, 0, 0.9),
        (FirstGain::G2, 0, 0.7),
        (FirstGain::G1, 1, 0.9),
        (FirstGain::G2, 1, 0.7),
        (FirstGain::G2, 2, 0.5),
        (FirstGain::G2, 0, 0.894),
    ];

    /// n with every rounding off by what `within` says of half a unit.
    fn scaled(of: &Approximation, normal: DVec3, mut within: impl FnMut(f64) -> f64) -> DVec3 {
        let half_unit = 0.5 * of.gain.ulp();
        let z = normal.length_squared() + within(of.error_of_z());
        let mut g = of.first.of(1.0 - z) + within(half_unit);
        for _ in 0..of.newton_steps {
            let square = g * g + within(half_unit);
            let correction = 3.0 - z * square + within(half_unit);
            g = g * correction / 2.0 + within(half_unit);
        }
        g * normal
    }

    /// How much of the bounds across and along the normal is reached. Normals are mostly about as
    /// short as they come, and off across or along themselves.
    fn reached(of: &Approximation, bounds: VectorBound) -> [f64; 2] {
        let proven = of.normalised(bounds);
        let mut draw = Draw::new(1);
        let mut reached = [0.0_f64; 2];
        for _ in 0..20_000 {
            let direction = draw.direction();
            let length = bounds.shortest + (1.0 - bounds.shortest) * draw.within(0.0, 1.0).powi(4);
            let moved = [direction, draw.across(direction), draw.direction()];
            let moved = draw.one_of(&moved) * draw.error(bounds.error.length);
            let real = scaled(of, length * direction, |_| 0.0);
            let fixed = scaled(of, length * direction + moved, |most| draw.error(most));
            assert!(fixed.length() <= proven.longest && real.length() <= 1.0018);

            let off = fixed - real;
            let along = off.dot(direction);
            let across = (off - along * direction).length();
            assert!(off.length() <= proven.error.length, "{of:?}: {off}");
            reached[0] = reached[0].max(across / proven.error.transverse);
            reached[1] = reached[1].max(along.abs() / proven.error.radial);
        }
        reached
    }

    /// 96 % is reached of the turn and of what N' is off along itself, 75 % of what the first gain is
    /// rounded by, 35 % after two Newton steps.
    #[test]
    fn normals_stay_within_the_bound_and_reach_it() {
        for (first, newton_steps, shortest) in CASES {
            for (error, fraction_bits) in [(1e-3, 20), (1e-6, 12), (1e-6, 7)] {
                let gain = Format::unsigned(2, fraction_bits);
                let length_squared = Format::unsigned(1, fraction_bits);
                let of = Approximation {
                    first,
                    newton_steps,
                    vector: Format::signed(1, fraction_bits),
                    length_squared,
                    gain,
                    truncated: 0.1 * length_squared.ulp(),
                    z_ulp: length_squared.ulp(),
                };
                let bounds = VectorBound::ball(shortest, 1.0 + error, error);
                let [across, along] = reached(&of, bounds);
                println!("{first:?}, {newton_steps} steps, {error}: {across} and {along}");
                assert!(across <= 1.0 && along <= 1.0);
                assert!(across > 0.96 && along > 0.35, "{of:?}: {across} and {along}");
            }
        }
    }

    /// The shortest N' makes the shortest n, to the last digits; in the last case g2 makes all of
    /// them longer than 1.
    #[test]
    fn real_normals_are_no_shorter_than_stated() {
        for &(first, newton_steps, shortest) in &CASES[..5] {
            let stated = shortest_scaled(first, newton_steps, shortest);
            let least = (0..=1000)
                .map(|i| shortest + (1.0 - shortest) * f64::from(i) / 1000.0)
                .map(|r| {
                    let first = first.of(1.0 - r * r);
                    r * (0..newton_steps).fold(first, |g, _| g * (3.0 - r * r * g * g) / 2.0)
                })
                .fold(f64::INFINITY, f64::min);
            println!("{first:?}, {newton_steps} steps: {least}, {stated} stated");
            assert!(least >= stated && 1.0 - least > 0.5 * (1.0 - stated));
        }
    }
}

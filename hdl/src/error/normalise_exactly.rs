//! How long exactly normalised vectors are, and how far they are off.
use specula_datapath::bound::{Bound, VectorBound, VectorError};

/// n = r N with r = 1/√max(z, l) and z = N·N, each rounded.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// u_z, unit of the last place of z.
    pub z_ulp: f64,
    /// l = 4^-m, what z counts as at least.
    pub least_operand: f64,
    /// u_r, unit of the last place of r.
    pub root_ulp: f64,
}

/// What is proven of n.
#[derive(Clone, Copy, Debug)]
pub struct Normalised {
    /// n is no longer before it is rounded.
    pub longest: f64,
    /// Real n is no shorter, up to 1.
    pub shortest: f64,
    /// How far n is off before it is rounded.
    pub error: VectorError,
    /// Error of the bit z > 0.
    pub direction_error: f64,
}

impl Exact {
    /// Of z, with r rounded to units of `root_ulp`.
    pub fn new(z: Bound, least_operand: f64, root_ulp: f64) -> Exact {
        Exact { z_ulp: z.ulp, least_operand, root_ulp }
    }

    /// What is proven for vectors within `bounds`.
    ///
    /// z is no more than u_z/2 below N·N, and at least l under the root:
    ///
    /// ```text
    /// |r N| ≤ √(N·N / max(z, l)) + |N| u_r/2
    ///       ≤ √(1 + u_z/(2 l)) + |N| u_r/2
    /// ```
    ///
    /// Where fixed z may be less than l, nothing is known of n but that both are no longer than it
    /// can be.
    pub fn normalised(self, bounds: VectorBound) -> Normalised {
        let of_root = 0.5 * bounds.longest * self.root_ulp;
        let of_z = 0.5 * self.z_ulp;
        let longest = (1.0 + of_z / self.least_operand).sqrt() + of_root;
        let least_z = bounds.surely().max(0.0).powi(2) - of_z;
        let reached = least_z >= self.least_operand && least_z > of_z;
        Normalised {
            longest,
            shortest: (bounds.shortest / self.least_operand.sqrt()).min(1.0),
            error: if reached {
                unit_vector(bounds, of_z / least_z, of_root)
            } else {
                VectorError::ball(1.0 + longest)
            },
            direction_error: if least_z >= self.z_ulp { 0.0 } else { 1.0 },
        }
    }
}

/// How far a normalised vector is off that was within `bounds` before, and is then scaled to a
/// length off by what a relative error x = `of_z` of its square makes, and by `of_root`.
///
/// ```text
/// N·N/z = 1 + y,            |y| ≤ x
/// 1 - √(1 - x) = x/(1 + √(1 - x)) ≤ x/(2 - x)
/// √(1 + x) - 1 ≤ x/2              ≤ x/(2 - x)
/// ```
///
/// So the length is 1 but for ρ = x/(2 - x) + `of_root`. With the turn t of
/// [`VectorBound::turn`], whose angle φ has sin φ ≤ t and cos φ ≥ 1 - t²/2, n is off by
///
/// ```text
/// across: (1 + ρ) sin φ      ≤ (1 + ρ) t
/// along:  |(1 + ρ) cos φ - 1| ≤ ρ + (1 + ρ) t²/2
/// ```
pub fn unit_vector(bounds: VectorBound, of_z: f64, of_root: f64) -> VectorError {
    let turn = bounds.turn();
    let stretched = of_z / (2.0 - of_z) + of_root;
    VectorError::components(
        (1.0 + stretched) * turn,
        stretched + (1.0 + stretched) * turn * turn / 2.0,
    )
}

#[cfg(test)]
mod tests {
    use specula_fixtures::Draw;

    use super::*;

    /// Of vectors about as short as they come, 99 % of the bound across and 80 % of that along n
    /// are reached.
    #[test]
    fn unit_vectors_stay_within_the_bound_and_reach_it() {
        for (shortest, error, bits) in [(0.25, 1e-3, 24), (0.5, 1e-6, 14), (0.9, 1e-4, 12)] {
            let ulp = f64::from(bits).exp2().recip();
            let of = Exact { z_ulp: ulp, least_operand: 1.0 / 256.0, root_ulp: ulp };
            let bounds = VectorBound::ball(shortest, 1.0 + error, error);
            let proven = of.normalised(bounds);
            let mut draw = Draw::new(1);
            let mut reached = [0.0_f64; 2];
            for _ in 0..20_000 {
                let direction = draw.direction();
                let length = shortest + (1.0 - shortest) * draw.within(0.0, 1.0).powi(4);
                let moved = [direction, draw.across(direction), draw.direction()];
                let moved = draw.one_of(&moved) * draw.error(error);
                let fixed = length * direction + moved;
                let z = fixed.length_squared() + draw.error(0.5 * of.z_ulp);
                let fixed = fixed * (1.0 / z.sqrt() + draw.error(0.5 * of.root_ulp));
                assert!(fixed.length() <= proven.longest);

                let off = fixed - direction;
                let along = off.dot(direction);
                let across = (off - along * direction).length();
                reached[0] = reached[0].max(across / proven.error.transverse);
                reached[1] = reached[1].max(along.abs() / proven.error.radial);
            }
            println!("{shortest}: {reached:?}");
            assert!(reached.iter().all(|&share| share <= 1.0), "{shortest}: {reached:?}");
            assert!(reached[0] > 0.99 && reached[1] > 0.8, "{shortest}: {reached:?}");
        }
    }

    /// Nothing is known of vectors that may be shorter than the root reaches.
    #[test]
    fn vectors_that_may_vanish_may_come_out_as_anything() {
        let of = Exact { z_ulp: 1e-6, least_operand: 1.0 / 256.0, root_ulp: 1e-4 };
        let proven = of.normalised(VectorBound::ball(0.0, 1.0, 1e-3));
        assert!(proven.error.length > 2.0 && proven.direction_error == 1.0);
    }
}

//! Exact normalisation.
use specula_scene::format::power_of_two;

use super::reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
use specula_datapath::builder::{Builder, Off, Sig, Vector};

/// The narrowing points of an exact normalisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactNormalisation {
    /// Fraction bits of z.
    pub length_squared_fraction_bits: u32,
    /// Where 1/√z is rounded and ends: vectors shorter than 2^-m get factors of 2^m and come out
    /// short.
    pub reciprocal: ReciprocalRoot,
    /// Fraction bits of n.
    pub vector_fraction_bits: u32,
}

/// n = r N with r = 1/√max(z, 4^-m) and z = N·N, each rounded; beside n goes the bit z > 0, which
/// says whether N has a direction.
///
/// A normal no longer than |N| has |r N| ≤ √(1 + 4^m u_z/2) + |N| u_r/2, with u the units of the
/// last places: z is no more than u_z/2 below N·N, and at least 4^-m under the root.
///
/// The latency is that of the [`reciprocal_square_root`], and a clock each for squares, two sums
/// and the rounding of z, the product and the rounding of n.
///
/// # Error
/// Let N' be N as it comes, off by e as a whole, and s = `shortest`. Both have length s - e at
/// least, and their directions are no further apart than t = e/√(s (s - e)). Beside that n has the
/// length of N' √(1/z): with x = u_z/(2 (s - e)² - u_z), the relative error that rounding leaves in
/// z, it is 1 but for ρ = x/(2 - x) + |N| u_r/2. So n is off by (1 + ρ) t across and ρ + (1 + ρ)
/// t²/2 along N, and by what n is rounded by; where (s - e)² - u_z/2 is below 4^-m, nothing is
/// known of n but that both are no longer than it can be.
///
/// Of z itself no bound is asked: that it is the squared length of N', and not of N, is no error of
/// the direction.
pub fn normalise_exactly(
    b: &Builder,
    normal: &Vector,
    to: ExactNormalisation,
    shortest: f64,
) -> (Vector, Sig) {
    b.unit("normalise_exactly", "n = N/sqrt(N.N)", (("normal", normal),), |b, (normal,)| {
        let longest = normal.longest();
        let z = normal
            .length_squared_within(longest, "N.N <= |N|^2")
            .rounded(to.length_squared_fraction_bits)
            .named("length_squared");
        let smallest = shortest * shortest;
        let r = reciprocal_square_root(b, &z, to.reciprocal, smallest);

        let limit = to.reciprocal.smallest_operand();
        let of_rounding_r = 0.5 * longest * power_of_two(-i64::from(to.reciprocal.fraction_bits));
        let reach = (1.0 + 0.5 * z.ulp() / limit).sqrt() + of_rounding_r;
        let (e, of_rounding_z) = (normal.off().length, 0.5 * z.ulp());
        let least_z = (shortest - e).max(0.0).powi(2) - of_rounding_z;
        let off = match least_z >= limit && least_z > of_rounding_z {
            true => unit_vector_off(e, shortest, of_rounding_z / least_z, of_rounding_r),
            false => Off::within(1.0 + reach),
        };
        let n = normal.scaled(&r).assumed_within(reach, "|r N| <= 1").known_off(off);
        let unsure = if least_z >= z.ulp() { 0.0 } else { 1.0 };
        let has_direction =
            b.integer(0).less_than(&z).named("has_direction").stated_error_value(unsure);
        (n.rounded(to.vector_fraction_bits).named("n"), has_direction)
    })
}

/// How far a normalised vector is off that was off by `e` before and no shorter than `shortest`,
/// and is then scaled to a length off by what a relative error `of_z` of its square makes, and by
/// `of_r`.
pub(super) fn unit_vector_off(e: f64, shortest: f64, of_z: f64, of_r: f64) -> Off {
    let turned = e / (shortest * (shortest - e)).sqrt();
    let stretched = of_z / (2.0 - of_z) + of_r;
    Off::parts((1.0 + stretched) * turned, stretched + (1.0 + stretched) * turned * turned / 2.0)
}

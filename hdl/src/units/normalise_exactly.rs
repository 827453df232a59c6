//! Exact normalisation.
use specula_scene::format::power_of_two;

use super::reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
use crate::builder::{Builder, Sig, Vector};

/// The narrowing points of an exact normalisation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactNormalisation {
    /// Fraction bits of z.
    pub length_squared_fraction_bits: u32,
    /// Where 1/√z is rounded and ends: vectors shorter than 2^-m get factors of 2^m and come out short.
    pub reciprocal: ReciprocalRoot,
    /// Fraction bits of n.
    pub vector_fraction_bits: u32,
}

/// n = r N with r = 1/√max(z, 4^-m) and z = N·N, each rounded; beside n goes the bit z > 0, which says whether N has a direction.
///
/// A normal no longer than |N| has |r N| ≤ √(1 + 4^m u_z/2) + |N| u_r/2, with u the units of the last places: z is no more than u_z/2
/// below N·N, and at least 4^-m under the root.
///
/// The latency is that of the [`reciprocal_square_root`], and a clock each for squares, two sums and the rounding of z, the product and
/// the rounding of n.
///
/// # Error
/// With N off by e in each component, z by e_z and s = `shortest`² - e_z ≥ 4^-m, a component of n is off by r e + e_z/(2s) + |N| u_r/2,
/// since |√z - √z'|/√z' ≤ e_z/2s, and by u_n/2. Where s is smaller nothing is known of n but that both are no longer than it can be; and
/// rounding may decide whether N has a direction.
pub fn normalise_exactly(b: &Builder, normal: &Vector, to: ExactNormalisation, shortest: f64) -> (Vector, Sig) {
    b.unit("normalise_exactly", "n = N/sqrt(N.N)", (("normal", normal),), |b, (normal,)| {
        let longest = normal.longest();
        let z =
            normal.length_squared_within(longest, "N.N <= |N|^2").rounded(to.length_squared_fraction_bits).named("length_squared");
        let smallest = shortest * shortest;
        let r = reciprocal_square_root(b, &z, to.reciprocal, smallest);

        let limit = to.reciprocal.smallest_operand();
        let of_rounding_r = 0.5 * longest * power_of_two(-i64::from(to.reciprocal.fraction_bits));
        let reach = (1.0 + 0.5 * z.ulp() / limit).sqrt() + of_rounding_r;
        let surely = smallest - z.error_value();
        let sure = surely >= limit;
        let largest = r.format().value(r.range().high);
        let error = match sure {
            true => {
                largest.min(surely.sqrt().recip() + r.ulp()) * normal.largest_error()
                    + 0.5 * z.error_value() / surely
                    + of_rounding_r
            }
            false => 1.0 + reach,
        };
        let product = normal.scaled(&r).assumed_within(reach, "|r N| <= 1");
        let n = product.map(|component| component.clone().stated_error_value(error)).no_longer_than(reach);
        let unsure = if surely >= z.ulp() { 0.0 } else { 1.0 };
        let has_direction = b.integer(0).less_than(&z).named("has_direction").stated_error_value(unsure);
        (n.rounded(to.vector_fraction_bits).named("n"), has_direction)
    })
}

//! Exact normalisation.
use specula_spec::lyon::{LOG2_LARGEST_GAIN, LyonFormats};

use super::reciprocal_square_root::{ReciprocalRoot, reciprocal_square_root};
use crate::error::normalise_exactly::Exact;
use specula_datapath::builder::{Builder, Sig, Vector};

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

impl From<&LyonFormats> for ExactNormalisation {
    fn from(formats: &LyonFormats) -> ExactNormalisation {
        ExactNormalisation {
            length_squared_fraction_bits: formats.length_squared.fraction_bits,
            reciprocal: ReciprocalRoot {
                integer_bits: LOG2_LARGEST_GAIN,
                fraction_bits: formats.gain.fraction_bits,
            },
            vector_fraction_bits: formats.vector.fraction_bits,
        }
    }
}

/// n = r N with r = 1/√max(z, 4^-m) and z = N·N, each rounded; beside n goes the bit z > 0, which
/// says whether N has a direction.
///
/// The latency is that of the [`reciprocal_square_root`], and a clock each for squares, two sums
/// and the rounding of z, the product and the rounding of n. Length and error:
/// [`error::normalise_exactly`](crate::error::normalise_exactly).
///
/// Of z itself no bound is asked: that it is the squared length of N as it comes, and not of the
/// real one, is no error of the direction.
pub fn normalise_exactly(b: &Builder, normal: &Vector, to: ExactNormalisation) -> (Vector, Sig) {
    b.unit("normalise_exactly", "n = N/sqrt(N.N)", (("normal", normal),), |b, (normal,)| {
        let z = normal
            .length_squared_within(normal.longest(), "N.N <= |N|^2")
            .rounded(to.length_squared_fraction_bits)
            .named("length_squared");
        let r = reciprocal_square_root(b, &z, to.reciprocal); // Um.f
        let proven = Exact::new(z.bound(), to.reciprocal.least_operand(), r.ulp());
        let proven = proven.normalised(normal.bound());

        let n = normal.scaled(&r).assumed_within(proven.longest, "|r N| <= 1");
        let has_direction = b.integer(0).less_than(&z).named("has_direction");
        (
            n.override_error(PROOF, proven.error)
                .rounded(to.vector_fraction_bits)
                .no_shorter_than(proven.shortest, PROOF)
                .named("n"),
            has_direction.override_error(PROOF, proven.direction_error),
        )
    })
}

/// Where length and error are proven.
const PROOF: &str = "error::normalise_exactly::Exact::normalised";

//! Approximate normalisation.
use specula_spec::lyon::{LyonFormats, LyonSpec, Normalisation};

use super::has_direction;
use super::normalise_exactly;
use crate::error;
use crate::error::normalise::FirstGain;
use specula_datapath::builder::{Builder, Sig, Vector};

/// Brings N' near unit length: n = g N' with g about 1/|N'|. [Lyon, TR 43; methods B8, B9]
///
/// ```text
/// z = N'·N',  y = 1 - z
/// g = 1 + y/2          (g1)
///   = 1 + (y + y²)/2   (g2)
/// g ← g (3 - z g²)/2   (each Newton step)
/// n = g N'
/// ```
///
/// Beside n goes the bit z > 0, which says whether N' has a direction at all (extremes row 1).
/// Lengths and errors: [`error::normalise`].
pub fn normalise(b: &Builder, normal: &Vector, lyon: &LyonSpec) -> (Vector, Sig) {
    let f = &lyon.formats;
    let (first, formula) = match lyon.normalisation {
        Normalisation::None => return unnormalised(b, normal),
        Normalisation::Exact => return normalise_exactly(b, normal, f.into()),
        Normalisation::G1 => (FirstGain::G1, "n = g N', g = 1 + y/2, y = 1 - N'.N' [Lyon, TR 43]"),
        Normalisation::G2 => {
            (FirstGain::G2, "n = g N', g = 1 + (y + y^2)/2, y = 1 - N'.N' [Lyon, TR 43]")
        }
    };
    b.unit("normalise", formula, (("normal", normal),), |b, (normal,)| {
        let z =
            normal // U1.length_squared
                .truncated_length_squared_within(
                    f.product.fraction_bits,
                    normal.longest(),
                    "|N'| <= 1",
                )
                .rounded(f.length_squared.fraction_bits)
                .named("length_squared");
        let proven = error::normalise::normalised(first, lyon, normal.bound(), z.bound());

        let y = (b.integer(1) - &z).named("y"); // S1.length_squared
        let above_one = match first {
            FirstGain::G1 => y.halved(),
            FirstGain::G2 => (&y + y.squared()).halved(),
        };
        let first = (b.integer(1) + above_one).rounded(f.gain.fraction_bits).named("gain"); // U2.gain
        let g = (0..lyon.newton_steps)
            .fold(first, |g, _| newton_step(b, &g, &z, f, proven.largest_product));

        let n = normal.scaled(&g).override_error(PROOF, proven.error);
        let n = n.rounded(f.vector.fraction_bits); // S1.vector
        let has_direction = b.integer(0).less_than(&z).named("has_direction");
        (
            n.assumed_within(proven.longest, "|g N'| <= 1.002")
                .no_shorter_than(proven.shortest, PROOF)
                .named("n"),
            has_direction.override_error(PROOF, proven.direction_error),
        )
    })
}

/// Where lengths and errors are proven.
const PROOF: &str = "error::normalise::normalised";

/// One Newton step towards 1/√z: g ← g (3 - z g²)/2, where z g² is no larger than
/// `largest_product`, so that 3 - z g² stays near 2 or above.
fn newton_step(b: &Builder, g: &Sig, z: &Sig, f: &LyonFormats, largest_product: f64) -> Sig {
    let bits = f.gain.fraction_bits;
    b.unit(
        "newton_step",
        "g' = g (3 - z g^2)/2 [Newton, for 1/sqrt z]",
        (("g", g), ("z", z)),
        |b, (g, z)| {
            let square = g.squared().rounded(bits).named("g_squared");
            let product = (&z * square).assumed(0.0, largest_product, "z g^2 <= 1.004");
            let correction = (b.integer(3) - product).rounded(bits).named("correction");
            (&g * correction).halved().rounded(bits).named("g_next")
        },
    )
}

/// N' as it is, and whether it has a direction.
fn unnormalised(b: &Builder, normal: &Vector) -> (Vector, Sig) {
    let unsure = error::vector::has_direction(normal.bound());
    let has_direction = has_direction(b, normal);
    (normal.clone(), has_direction.override_error("error::vector::has_direction", unsure))
}

//! Torrance and Sparrow's distribution: a Gaussian of the angle between two vectors, from the
//! cosine's distance to 1.
//!
//! Widths and error are derived in docs/arithmetic/units.md.
use specula_spec::format::power_of_two;

use super::power::{exp2, tables};
use crate::error;
use specula_datapath::builder::{Builder, Sig};

/// Parts of the table from 0 to 1: 2^4.
const INDEX_BITS: u32 = 4;
/// The largest d, in eighths.
const MOST_EIGHTHS: i64 = 15;

/// exp(-2n α²) of d = 1 - cos α from 0 to 15/8 and whole n ≥ 1, to `fraction_bits`: faithful.
/// [Lyon, TR 43, appendix, formulation 11]
///
/// # Error
/// [`error::gaussian::bound`].
pub fn gaussian(b: &Builder, versine: &Sig, n: &Sig, fraction_bits: u32) -> Sig {
    b.unit(
        "gaussian",
        "f = exp(-2n a^2), d = 1 - cos a",
        (("d", versine), ("n", n)),
        |b, (d, n)| {
            let error = error::gaussian::bound(n.bound(), d.bound(), fraction_bits);
            let g = squared_angle(b, &d, fraction_bits + 4);
            // From 4 on the power vanishes whatever g is: 8g > 23.
            let t = (n * d).clamped_above(4).named("t");
            let y = (t * g).doubled().rounded(fraction_bits + 6).named("y");
            let vanishes = exp2::vanishes(b, &y, fraction_bits).named("vanishes");
            exp2::two_to_minus(b, &y, &vanishes, fraction_bits)
                .override_error("error::gaussian::bound", error)
                .named("f")
        },
    )
}

/// 1 - cos α kept within 0 to 15/8, beyond which exp(-2 α²) is less than 2^-20.
pub fn kept_versine(versine: &Sig) -> Sig {
    versine.at_least_zero().times_power_of_two(3).clamped_above(MOST_EIGHTHS).times_power_of_two(-3)
}

/// g = α² log₂ e/(1 - cos α): in each of 31 parts the parabola through its ends and its middle.
fn squared_angle(b: &Builder, d: &Sig, fraction_bits: u32) -> Sig {
    b.unit("squared_angle", "g = a^2 log2(e)/d, d = 1 - cos a", (("d", d),), |b, (d,)| {
        let part = d.truncated(INDEX_BITS);
        let index = part.times_power_of_two(INDEX_BITS as i32).named("index");
        let half = b.integer(1).times_power_of_two(-(INDEX_BITS as i32) - 1);
        let within = power_of_two(-(i64::from(INDEX_BITS) + 1));
        let delta = (d - part - half).assumed(-within, within, "|delta| <= 1/32").named("delta");
        let [value, slope, curvature] =
            entries(fraction_bits).map(|entries| index.looked_up(entries, fraction_bits, 0.5));
        let slope = (slope.named("slope")
            + (&delta * curvature.named("curvature")).rounded(fraction_bits))
        .named("chord");
        (value.named("value") + (delta * slope).rounded(fraction_bits)).named("g")
    })
}

/// A, B and C of A + δ(B + δ C) in each part.
fn entries(fraction_bits: u32) -> [Vec<i64>; 3] {
    let parts = (MOST_EIGHTHS << INDEX_BITS >> 3) + 1;
    let part = |i: i64| tables::squared_angle_parabola(i, INDEX_BITS, fraction_bits);
    let all: Vec<[i64; 3]> = (0..parts).map(part).collect();
    [0, 1, 2].map(|term| all.iter().map(|part| part[term]).collect())
}

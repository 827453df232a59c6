//! A square root that follows the pixel before.
use specula_scene::format::power_of_two;
use specula_scene::spec::direct::DirectFormats;

use super::direct::at_least;
use super::divider::{QuotientFormat, quotient};
use crate::error;
use specula_datapath::builder::{Builder, Known, Sig};

/// How Newton's method goes on from pixel to pixel.
#[derive(Clone, Copy, Debug)]
pub struct NewtonRoot {
    /// Steps at each pixel.
    pub steps: u32,
    /// No normal is shorter, as a real number.
    pub shortest: f64,
}

/// d ← (d + q/d)/2, `steps` times at each pixel from the d of the pixel before on, and from 1 at
/// the first; q counts as 4^-m at least. [lecture, §4.2; methods A6]
///
/// d + q/d ≥ 2√q, so d stays at 2^-m or more, and so q/d at 2^m or less. All steps happen within one
/// clock, divisions included: the next pixel waits for d. How large d gets and how far it is off:
/// [`error::newton_root`].
pub fn newton_root(
    b: &Builder,
    first: &Sig,
    q: &Sig,
    formats: &DirectFormats,
    newton: NewtonRoot,
) -> Sig {
    let inputs = (("start", first), ("q", q));
    b.unit(
        "newton_root",
        "d' = (d + q/d)/2 from pixel to pixel [lecture, 4.2]",
        inputs,
        |b, (first, q)| {
            let (reach, fraction_bits) =
                (formats.reciprocal.integer_bits, formats.length.fraction_bits);
            let q = at_least(b, &q, 2 * reach);
            let least = power_of_two(-i64::from(reach));
            let largest_q = q.format().value(q.range().high);
            let largest = error::newton_root::largest(least, largest_q, formats.length.ulp());
            let error = newton.bound(&q, formats).unwrap_or(largest);
            let known = Known { limits: (0.0, largest), fact: "0 <= d <= (2^-m + 2^m)/2", error };
            let to = QuotientFormat { integer_bits: reach, fraction_bits };
            let [d] = b.carried(
                &first,
                ([&b.integer(1)], [&q]),
                fraction_bits,
                &known,
                |[before], [q]| {
                    let step = |d: Sig| {
                        (&d + &quotient(b, q, &d, to, least)).halved().rounded(fraction_bits)
                    };
                    [(0..newton.steps).fold(before.clone(), |d, _| step(d)).named("root")]
                },
            );
            d.override_error("newton_root", error).named("length")
        },
    )
}

impl NewtonRoot {
    /// How far d is off; nothing where steps may lead away from the root.
    pub fn bound(self, q: &Sig, formats: &DirectFormats) -> Option<f64> {
        error::newton_root::followed_root(self.steps, self.shortest, q.error_value(), formats)
    }
}

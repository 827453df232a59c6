//! A square root that follows the pixel before.
use specula_spec::direct::DirectFormats;

use super::direct::at_least;
use super::divider::{QuotientFormat, quotient};
use crate::error;
use crate::error::newton_root::Length;
use specula_datapath::bound::Interval;
use specula_datapath::builder::{Builder, LoopInvariant, Sig};

/// d ← (d + q/d)/2, `steps` times at each pixel from the d of the pixel before on, and from 1 at
/// the first; q counts as 4^-m at least. [lecture, §4.2; methods A6]
///
/// d + q/d ≥ 2√q, so d stays at 2^-m or more, and so q/d at 2^m or less. All steps happen within one
/// clock, divisions included: the next pixel waits for d. How large d gets and how far it is off:
/// [`error::newton_root`].
pub fn newton_root(b: &Builder, first: &Sig, q: &Sig, formats: &DirectFormats, steps: u32) -> Sig {
    let inputs = (("start", first), ("q", q));
    b.unit(
        "newton_root",
        "d' = (d + q/d)/2 from pixel to pixel [lecture, 4.2]",
        inputs,
        |b, (first, q)| {
            let (reach, fraction_bits) =
                (formats.reciprocal.integer_bits, formats.length.fraction_bits);
            let limited = at_least(b, &q, 2 * reach);
            let Length { shortest, largest, error } =
                error::newton_root::length(steps, q.bound(), limited.bound(), formats);
            let known =
                LoopInvariant { limits: (0.0, largest), fact: "0 <= d <= (2^-m + 2^m)/2", error };
            let to = QuotientFormat { integer_bits: reach, fraction_bits };
            let [d] = b.carried(
                &first,
                ([&b.integer(1)], [&limited]),
                fraction_bits,
                &known,
                |[before], [q]| {
                    let step =
                        |d: Sig| (&d + &quotient(b, q, &d, to)).halved().rounded(fraction_bits);
                    [(0..steps).fold(before.clone(), |d, _| step(d)).named("root")]
                },
            );
            d.override_error("error::newton_root::length", error)
                .real_within(Interval::at_least(shortest), "d >= sqrt q")
                .named("length")
        },
    )
}

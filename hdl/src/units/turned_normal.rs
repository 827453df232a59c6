//! Normals along an arc, or so near to it that a factor brings them to unit length.
use specula_spec::slerp::SlerpFormats;

use crate::error::turned_normal::{Weighing, longest};
use specula_datapath::bound::VectorError;
use specula_datapath::builder::{Builder, Sig, Vector};

/// Where the error of N is proven.
const SUM: &str = "error::turned_normal::Weighing::put_together";

/// Where that of n is.
const PROOF: &str = "error::turned_normal::Weighing::lengthened";

/// N = u P + v Q, and n = N (3 - N·N)/2: Newton's step towards unit length from 1 on. Errors:
/// [`error::turned_normal`](crate::error::turned_normal). [lecture, eq. 4.7; methods A8, A9, A11]
pub fn turned_normal(
    b: &Builder,
    weights: [&Sig; 2],
    axes: [&Vector; 2],
    formats: &SlerpFormats,
    known: Weighing,
) -> Vector {
    let inputs = (("u", weights[0]), ("v", weights[1]), ("p", axes[0]), ("q", axes[1]));
    b.unit(
        "turned_normal",
        "n = N (3 - N.N)/2, N = u P + v Q [lecture, eq. 4.7]",
        inputs,
        |b, (u, v, p, q)| {
            let off = known.put_together([p.bound(), q.bound()]);
            let turned = (&p.scaled(&u) + &q.scaled(&v))
                .assumed_within(1.0 + off, "|N| <= 1")
                .tighten_error(SUM, VectorError::ball(off))
                .rounded(formats.vector.fraction_bits)
                .named("turned");

            let square = turned.length_squared_within(turned.longest(), "|N| <= 1");
            let gain = (b.integer(3) - square)
                .halved()
                .rounded(formats.cosine.fraction_bits)
                .named("gain");

            let half_unit = 0.5 * formats.cosine.ulp();
            turned
                .scaled(&gain)
                .assumed_within(longest(turned.longest(), half_unit), "|n| <= 1")
                .override_error(PROOF, known.lengthened(turned.bound(), half_unit))
                .rounded(formats.vector.fraction_bits)
                .named("n")
        },
    )
}

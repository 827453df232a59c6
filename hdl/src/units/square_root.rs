//! Square roots.
use specula_spec::format::power_of_two;

use crate::error;
use specula_datapath::builder::{Builder, Sig};

/// √x, or 0 where x ≤ 0, to `fraction_bits`, correctly rounded (ties up). [digit recurrence:
/// Ercegovac and Lang, Digital Arithmetic, ch. 6]
///
/// With f fraction bits and A = ⌊2^(2f+2) x⌋, rows find R = ⌊√A⌋ = ⌊2^(f+1) √x⌋, a bit and a clock
/// each, and ⌊(R + 1)/2⌋ = ⌊2^f √x + 1/2⌋. A row takes two bits of A, so there are half as many
/// rows as A has bits; one clock more rounds, and one clamps an x that may be negative.
///
/// Error: [`error::square_root`].
pub fn square_root(b: &Builder, x: &Sig, fraction_bits: u32) -> Sig {
    b.unit("square_root", "r = sqrt(max(x, 0))", (("x", x),), |b, (x,)| {
        let x = x.at_least_zero();
        let ulp = power_of_two(-i64::from(fraction_bits));
        let error = error::square_root::root(x.bound(), ulp);

        let Radicand { mut bits, further_pairs } = Radicand::of(&x, 2 * fraction_bits + 2);
        let pairs = bits.range().width().div_ceil(2);
        let (mut remainder, mut root) = (b.integer(0), b.integer(0));
        for left in (0..pairs + further_pairs).rev() {
            let pair = match left.checked_sub(further_pairs) {
                Some(below) => {
                    let pair = bits.times_power_of_two(-2 * below as i32).truncated(0).raw();
                    bits = bits.low_bits(2 * below);
                    pair
                }
                None => b.integer(0),
            };
            let (rest, bit) = row(b, &remainder, &root, &pair);
            (remainder, root) = (rest, root.with_bit(&bit).named("bits"));
        }
        root.times_power_of_two(-(fraction_bits as i32 + 1))
            .rounded(fraction_bits)
            .override_error("error::square_root::root", error)
            .named("root")
    })
}

/// The integer A, two bits a row.
struct Radicand {
    /// A without the zeros behind it.
    bits: Sig,
    /// Pairs of zeros behind those bits.
    further_pairs: u32,
}

impl Radicand {
    /// ⌊2^`exponent` x⌋ of an x that is not negative; `exponent` is even.
    fn of(x: &Sig, exponent: u32) -> Radicand {
        let behind = exponent.saturating_sub(x.fraction_bits());
        let bits = x.times_power_of_two((exponent - behind / 2 * 2) as i32).truncated(0).raw();
        Radicand { bits, further_pairs: behind / 2 }
    }
}

/// One bit of the root: with A = r + root² for the bits of A so far and r ≤ 2 root, whether (2
/// root + 1)² ≤ 4A + pair, and what then remains, both after one clock.
fn row(b: &Builder, remainder: &Sig, root: &Sig, pair: &Sig) -> (Sig, Sig) {
    // The new root is 2 root + 1 at most, and the new remainder twice that.
    let largest = 2.0 * (2.0 * root.range().high as f64 + 1.0);
    let inputs = (("r", remainder), ("root", root), ("pair", pair));
    b.unit(
        "root_row",
        "bit = 4r + pair >= 4 root + 1, r' = 4r + pair - bit (4 root + 1)",
        inputs,
        |b, (r, root, pair)| {
            let (rest, bit) = b.in_one_clock(|| {
                let grown = r.times_power_of_two(2) + pair;
                let difference = &grown - (root.times_power_of_two(2) + b.integer(1));
                let below = difference.less_than(&b.integer(0));
                let rest =
                    below.choose(&grown, &difference).assumed(0.0, largest, "0 <= r <= 2 root");
                (rest, below.not())
            });
            (rest.named("rest"), bit.named("root_bit"))
        },
    )
}

//! Reciprocal square roots.
use specula_spec::Format;
use specula_spec::format::power_of_two;

use crate::error::reciprocal_square_root::{RowLimits, reciprocal_root};
use specula_datapath::builder::{Builder, Sig};
use specula_datapath::design::Range;

/// The format and the reach of a reciprocal square root.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ReciprocalRoot {
    /// m: the result is 2^m at most, and z counts as 4^-m at least.
    pub integer_bits: u32,
    /// f: bits right of the result's binary point.
    pub fraction_bits: u32,
}

impl From<Format> for ReciprocalRoot {
    fn from(Format { integer_bits, fraction_bits, .. }: Format) -> ReciprocalRoot {
        ReciprocalRoot { integer_bits, fraction_bits }
    }
}

impl ReciprocalRoot {
    /// 4^-m.
    pub(crate) fn least_operand(self) -> f64 {
        power_of_two(-2 * i64::from(self.integer_bits))
    }
}

/// 1/√max(z, 4^-m) to f fraction bits, correctly rounded (ties up); so it is 2^m where z ≤ 4^-m, 0
/// and negative z included. [digit recurrence: Ercegovac and Lang, Digital Arithmetic, ch. 6]
///
/// Let Z be z's raw number with F ≥ 2m fraction bits, and C = 2^(2f + 2 + F). Rows find R, the
/// greatest of m + f + 1 bits with R² Z ≤ C, that is R = ⌊2^(f+1)/√z⌋ (or one less at z = 4^-m,
/// where 2^(m+f+1) has a bit more), and ⌊(R + 1)/2⌋ = ⌊2^f/√z + 1/2⌋.
///
/// With k bits still to find, a row keeps P = R Z and w = ⌊C/4^k⌋ - R² Z. C is a power of two, so
/// nothing comes in beside w, and (2R + 1)² Z ≤ 4C/4^k where 4P + Z ≤ 4w. z ≥ 4^-m means that w ≤
/// 2P + Z in the first row, and so in each. A row and a clock for each of m + f + 1 bits, a clock
/// each to limit z and to round.
///
/// Error: [`reciprocal_root`].
pub fn reciprocal_square_root(b: &Builder, z: &Sig, to: ReciprocalRoot) -> Sig {
    let ReciprocalRoot { integer_bits, fraction_bits } = to;
    let formula = format!("r = 1/sqrt(max(z, 2^-{}))", 2 * integer_bits);
    b.unit("reciprocal_square_root", &formula, (("z", z),), |b, (z,)| {
        let ulp = power_of_two(-i64::from(fraction_bits));
        let error = reciprocal_root(z.bound(), to.least_operand(), ulp);

        let limit = b.integer(1).times_power_of_two(-2 * integer_bits as i32);
        let limited = z.less_than(&limit).choose(&limit, &z);
        // Where no pixel is, registers hold anything, 0 at first. Every number of so many bits
        // counts as possible from here on, so that rows compute nothing wider than they say at any
        // clock.
        let width = Range::new(0, limited.range().high).width();
        let z = limited.raw().low_bits(width).named("limited");
        let bits = integer_bits + fraction_bits + 1;
        let before = limited.fraction_bits() - 2 * integer_bits;
        let (mut residue, mut product) = (b.integer(1 << before), b.integer(0));
        let mut root = b.integer(0);
        for found in 1..=bits {
            let bit;
            // log2 of C/4^k.
            (residue, product, bit) = row(b, &residue, &product, &z, before + 2 * found);
            root = root.with_bit(&bit).named("bits");
        }
        root.times_power_of_two(-(fraction_bits as i32 + 1))
            .rounded(fraction_bits)
            .override_error("error::reciprocal_square_root::reciprocal_root", error)
            .named("reciprocal")
    })
}

/// One bit of the result: whether 4P + Z ≤ 4w, and w and P after it, all after one clock.
/// C/4^k is 2^`log2_square`.
fn row(b: &Builder, residue: &Sig, product: &Sig, z: &Sig, log2_square: u32) -> (Sig, Sig, Sig) {
    let most = RowLimits::new(power_of_two(log2_square.into()), z.range().high as f64);
    let formula = "bit = 4w >= 4P + Z, w' = 4w - bit (4P + Z), P' = 2P + bit Z";
    b.unit(
        "reciprocal_root_row",
        formula,
        (("w", residue), ("p", product), ("z", z)),
        |b, (w, p, z)| {
            let (rest, product, bit) = b.in_one_clock(|| {
                let grown = w.times_power_of_two(2);
                let difference = &grown - (p.times_power_of_two(2) + &z);
                let below = difference.less_than(&b.integer(0));
                let rest = below.choose(&grown, &difference).assumed(
                    0.0,
                    all_ones(most.residue),
                    "0 <= w <= 2P + Z",
                );
                let doubled = p.times_power_of_two(1);
                let product = below.choose(&doubled, &(&doubled + &z)).assumed(
                    0.0,
                    all_ones(most.product),
                    "R^2 Z <= C/4^k",
                );
                (rest, product, below.not())
            });
            (rest.named("rest"), product.named("product"), bit.named("root_bit"))
        },
    )
}

/// The largest number of as many bits as `limit` has.
fn all_ones(limit: f64) -> f64 {
    let beyond = (limit as u64 + 1).next_power_of_two() as f64;
    // Above 2^53 the number before it is none of f64's.
    (beyond - 1.0).min(beyond.next_down())
}

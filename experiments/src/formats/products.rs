//! What products take.
use std::sync::atomic::{AtomicU32, Ordering};

use specula_datapath::design::Factors;
use specula_datapath::target::{Multiplier, Target};

use crate::cost::blocks_for;

/// How a core's products are made.
#[derive(Clone, Debug)]
pub enum Products {
    /// FPGA tools divide them among blocks whose signed operands have these widths, the wider one
    /// first.
    Blocks([u32; 2]),
    /// FPGA tools make them of logic.
    Logic,
    /// Specula divides them among what the target has.
    Of(Target),
}

/// Widths of factors, signs included, are below this: no signal is wider than 63 bits, and an
/// unsigned one has a bit for the sign.
const WIDTHS: usize = 65;
/// Signs of both factors, and whether they are the same.
const KINDS: usize = 8;
/// Bits of a factor up to which a product on a target is a choice.
const FEW_BITS: u32 = 2;

/// What products take, in cells, each worked out once.
pub(super) struct ProductCells {
    products: Products,
    /// By signs and widths; 0 where it has not been asked for.
    known: Vec<AtomicU32>,
}

impl ProductCells {
    pub fn new(products: &Products) -> ProductCells {
        let unknown = || AtomicU32::new(0);
        ProductCells {
            products: products.clone(),
            known: std::iter::repeat_with(unknown).take(KINDS * WIDTHS * WIDTHS).collect(),
        }
    }

    /// That of a product of such factors, but of other widths, signs included, each taken to be at
    /// least 1 and at most 64: all bits of the blocks that it takes, used or not, and adders.
    pub fn of(&self, factors: &Factors, widths: [i32; 2]) -> i64 {
        // Between 1 and 64.
        let widths = widths.map(|width| width.clamp(1, WIDTHS as i32 - 1) as u32);
        let signs = factors.signed.map(usize::from);
        let kind = (usize::from(factors.square) * 2 + signs[0]) * 2 + signs[1];
        let [a, b] = widths.map(|width| width as usize);
        let known = &self.known[(kind * WIDTHS + a) * WIDTHS + b];
        let seen = known.load(Ordering::Relaxed);
        if seen > 0 {
            return seen.into();
        }
        let cells = self.products.cells(&Factors { widths, ..*factors });
        known.store(cells, Ordering::Relaxed);
        cells.into()
    }
}

impl Products {
    /// The cells of a product; at least 1.
    fn cells(&self, factors: &Factors) -> u32 {
        let [a, b] = factors.widths;
        match self {
            // Some thousand blocks at most.
            Products::Blocks([long, short]) => {
                blocks_for([*long, *short], [a, b]) as u32 * long * short
            }
            Products::Logic => a * b,
            Products::Of(target) => {
                let own = |i: usize| Factor {
                    width: factors.widths[i] - u32::from(!factors.signed[i]),
                    signed: factors.signed[i],
                };
                divided(target.multiplier.as_ref(), [own(0), own(1)], factors.square)
            }
        }
    }
}

/// A factor of a product on a target.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
struct Factor {
    /// Its own bits.
    width: u32,
    signed: bool,
}

impl Factor {
    /// Its last bits and the others.
    fn cut(self, at: u32) -> [Factor; 2] {
        [Factor { width: at, signed: false }, Factor { width: self.width - at, ..self }]
    }

    /// Whether it fits a port of that number.
    fn fits(self, multiplier: &Multiplier, port: usize) -> bool {
        let Multiplier { widths, unsigned, .. } = multiplier;
        self.width <= if self.signed { widths[port] } else { unsigned[port] }
    }
}

/// The cells of a product that is divided as the pass `lower` does: blocks, adders of what they give,
/// and the registers behind these.
fn divided(multiplier: Option<&Multiplier>, [a, b]: [Factor; 2], square: bool) -> u32 {
    let sum = 2 * (a.width + b.width);
    let Some(block) = multiplier.filter(|_| a.width.min(b.width) > FEW_BITS) else {
        return if a.width.min(b.width) > FEW_BITS { a.width * b.width } else { sum };
    };
    if a.fits(block, 0) && b.fits(block, 1) || b.fits(block, 0) && a.fits(block, 1) {
        return block.widths.into_iter().product();
    }
    let of = |a, b, square| divided(multiplier, [a, b], square);
    if square {
        let [low, high] = a.cut(block.unsigned[1]);
        return of(low, low, true) + of(low, high, false) + of(high, high, true) + 2 * sum;
    }
    let [a, b] = if a.width < b.width { [b, a] } else { [a, b] };
    let [low, high] = a.cut(block.unsigned[usize::from(!b.fits(block, 1))]);
    of(low, b, false) + of(high, b, false) + sum
}

//! What products take.
use std::sync::atomic::{AtomicU32, Ordering};

use specula_datapath::design::Factors;
use specula_datapath::resources::blocks_for;
use specula_datapath::target::{Multiplier, Target};

/// How a core's products are made.
#[derive(Clone, Debug)]
pub enum Products {
    /// FPGA tools divide them among blocks whose signed operands have these widths, the wider one
    /// first.
    Blocks([u32; 2]),
    /// FPGA tools make them of logic.
    Logic,
    /// Specula divides them among what the target has.
    Of(Box<Target>),
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
    /// Widths of the signed operands of the blocks that products are divided among, the wider one
    /// first; `None` where they are made of logic.
    pub fn block(&self) -> Option<[u32; 2]> {
        match self {
            Products::Blocks(block) => Some(*block),
            Products::Logic => None,
            Products::Of(target) => {
                let [a, b] = target.multiplier.as_ref()?.widths;
                Some([a.max(b), a.min(b)])
            }
        }
    }

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
                let multiplier = target.multiplier.as_ref();
                let block = multiplier.map_or(0, |block| block.widths.into_iter().product());
                let parts = Parts::of(multiplier, Factor::both(factors), factors.square);
                parts.blocks * block + parts.logic
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
    fn both(factors: &Factors) -> [Factor; 2] {
        [0, 1].map(|i| {
            let (width, signed) = (factors.widths[i], factors.signed[i]);
            Factor { width: width - u32::from(!signed), signed }
        })
    }

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

/// What a product is divided into by the pass `lower`.
#[derive(Clone, Copy, Debug)]
struct Parts {
    blocks: u32,
    /// Bits of adders of what blocks give, and of the registers behind these.
    logic: u32,
}

impl Parts {
    fn of(multiplier: Option<&Multiplier>, [a, b]: [Factor; 2], square: bool) -> Parts {
        let sum = 2 * (a.width + b.width);
        if a.width.min(b.width) <= FEW_BITS {
            return Parts { blocks: 0, logic: sum };
        }
        let Some(block) = multiplier else {
            return Parts { blocks: 0, logic: a.width * b.width };
        };
        if a.fits(block, 0) && b.fits(block, 1) || b.fits(block, 0) && a.fits(block, 1) {
            return Parts { blocks: 1, logic: 0 };
        }
        let of = |a, b, square| Parts::of(multiplier, [a, b], square);
        if square {
            let [low, high] = a.cut(block.unsigned[1]);
            let tiles = [of(low, low, true), of(low, high, false), of(high, high, true)];
            return Parts::together(tiles, 2 * sum);
        }
        let [a, b] = if a.width < b.width { [b, a] } else { [a, b] };
        let [low, high] = a.cut(block.unsigned[usize::from(!b.fits(block, 1))]);
        Parts::together([of(low, b, false), of(high, b, false)], sum)
    }

    fn together<const N: usize>(tiles: [Parts; N], sums: u32) -> Parts {
        let [blocks, logic] = [|of: &Parts| of.blocks, |of: &Parts| of.logic]
            .map(|count| tiles.iter().map(count).sum::<u32>());
        Parts { blocks, logic: logic + sums }
    }
}

#[cfg(test)]
mod tests {
    use specula_datapath::builder::Builder;
    use specula_datapath::design::Op;
    use specula_datapath::pass::lowered;
    use specula_datapath::{Format, InputPort};

    use super::*;

    /// Blocks of a product on the target, as it is lowered, and as they are counted here.
    fn blocks(target: &Target, formats: [Format; 2], square: bool) -> [usize; 2] {
        let builder = Builder::new("product", "a b");
        let control = builder.control();
        let [a, b] = [("a", formats[0]), ("b", formats[1])]
            .map(|(name, format)| builder.input(&InputPort::whole(name, format)));
        let product = if square { a.squared() } else { &a * &b };
        let graph = builder.graph(&control.valid, &[("product", product)]).unwrap();
        let [factors] = &specula_datapath::pass::extent(&graph).unwrap().factors[..] else {
            panic!("one product");
        };
        let graph = lowered(&graph, target, 100.0).graph;
        let is_product = |op: &Op| matches!(op, Op::Mul(..));
        let made = graph.values.iter().filter(|value| is_product(&value.op)).count();
        let multiplier = target.multiplier.as_ref();
        let parts = Parts::of(multiplier, Factor::both(factors), factors.square);
        [made, parts.blocks as usize]
    }

    #[test]
    fn products_are_divided_as_they_are_lowered() {
        let width = |bits: u32| [Format::unsigned(0, bits), Format::signed(0, bits - 1)];
        for target in Target::clocked().filter_map(Target::named) {
            for a in (3..=40).flat_map(width) {
                for b in
                    [3, 9, 16, 17, 18, 19, 20, 21, 24, 25, 26, 35, 37].into_iter().flat_map(width)
                {
                    // A result has 63 bits at most.
                    if a.width() + b.width() > 62 {
                        continue;
                    }
                    let [made, counted] = blocks(&target, [a, b], false);
                    assert_eq!(made, counted, "{}: {a} x {b}", target.name);
                }
                if a.width() <= 31 {
                    let [made, counted] = blocks(&target, [a, a], true);
                    assert_eq!(made, counted, "{}: {a} squared", target.name);
                }
            }
        }
    }
}

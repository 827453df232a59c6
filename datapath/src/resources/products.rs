//! Products, in blocks or in look-up tables.
use crate::design::{Design, Op};
use crate::target::Target;

/// What products take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Products {
    /// Multiplier blocks.
    pub blocks: u64,
    /// Look-up tables.
    pub luts: u64,
}

impl Products {
    /// Those of a design: its blocks, where it was made for a target; else those that its products
    /// of two variables are cut into, and look-up tables for each bit of products with constants.
    pub fn of(design: &Design, target: &Target) -> Products {
        if !design.multipliers.is_empty() {
            return Products { blocks: design.multipliers.len() as u64, luts: 0 };
        }
        let mut products = Products::default();
        for node in &design.nodes {
            let Op::Mul(a, b) = node.op else { continue };
            // A sign bit is added to operands without.
            let [a, b] = [a, b].map(|id| {
                let range = design.node(id).range;
                range.width() + u32::from(!range.signed())
            });
            match (&target.multiplier, design.factors(node)) {
                (Some(block), Some(_)) => products.blocks += blocks_for(block.widths, [a, b]),
                (None, Some(_)) => products.luts += u64::from(a) * u64::from(b),
                (_, None) => products.luts += u64::from(node.width()),
            }
        }
        products
    }
}

/// Number of blocks for a product of two signals, which is divided into parts that a block can
/// multiply. Widths are of operands with a sign, the block's wider one first. Parts after the first
/// have no sign, and therefore one bit less.
pub fn blocks_for([long, short]: [u32; 2], [a, b]: [u32; 2]) -> u64 {
    let parts =
        |width: u32, port: u32| u64::from(width.saturating_sub(1).div_ceil(port - 1).max(1));
    (parts(a, long) * parts(b, short)).min(parts(a, short) * parts(b, long))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_cut_into_what_blocks_multiply() {
        for (widths, blocks) in [
            ([18, 25], 1),
            ([25, 18], 1),
            ([1, 1], 1),
            ([26, 18], 2),
            ([25, 25], 2),
            ([49, 35], 4),
            ([50, 35], 6),
        ] {
            assert_eq!(blocks_for([25, 18], widths), blocks, "{widths:?}");
        }
        for (widths, blocks) in [([18, 18], 1), ([19, 18], 2), ([19, 19], 4), ([36, 18], 3)] {
            assert_eq!(blocks_for([18, 18], widths), blocks, "{widths:?}");
        }
    }
}

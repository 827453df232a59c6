//! Differences in size between two cores.
use serde::Serialize;
use specula_datapath::Design;
use specula_sim::{SimError, Synthesised};

use specula_testbench::BenchError;

/// A function that synthesises designs into cells, such as [`specula_sim::synthesise`].
pub type Synthesis<'a> = &'a dyn Fn(&[&Design]) -> Result<Vec<Synthesised>, SimError>;

/// Difference in size between two cores. It is negative where the shifts and sums of a product with
/// a constant are more hardware than what they replace.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct SizeDelta {
    /// Multipliers of two variables.
    pub multipliers: i64,
    /// Sum over multipliers of the product of their operands' widths.
    pub multiplier_bits: i64,
    /// Adders and subtractors, including those of products with constants.
    pub adders: i64,
    /// Sum of the adders' widths.
    pub adder_bits: i64,
    /// Register bits.
    pub register_bits: i64,
    /// Clocks of latency.
    pub latency: i64,
    /// Cells of an FPGA, if the caller asks for them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cells: Option<CellDelta>,
}

/// Difference in cells of an ECP5 between two cores.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct CellDelta {
    /// Look-up tables of four inputs.
    pub luts: i64,
    /// Multipliers of 18 x 18 bits.
    pub multipliers: i64,
    /// Number of flip-flops.
    pub flip_flops: i64,
}

/// A core that was built.
pub(super) struct Built<'a> {
    design: &'a Design,
    cells: Option<Synthesised>,
}

impl Built<'_> {
    /// Builds these cores and, with `synthesis`, counts their cells.
    pub fn all<'a>(
        designs: &[&'a Design],
        synthesis: Option<Synthesis>,
    ) -> Result<Vec<Built<'a>>, BenchError> {
        let cells = match synthesis {
            Some(synthesise) => synthesise(designs)?.into_iter().map(Some).collect(),
            None => vec![None; designs.len()],
        };
        Ok(designs.iter().zip(cells).map(|(design, cells)| Built { design, cells }).collect())
    }
}

impl SizeDelta {
    /// Whether neither the hardware nor its cells differ.
    pub(super) fn is_nothing(&self) -> bool {
        let nothing =
            SizeDelta { cells: self.cells.map(|_| CellDelta::default()), ..SizeDelta::default() };
        *self == nothing
    }

    /// The size of `more` minus the size of `less`.
    pub(super) fn between(more: &Built, less: &Built) -> SizeDelta {
        let (m, l) = (more.design.size(), less.design.size());
        let difference = |a: u64, b: u64| a as i64 - b as i64;
        let cells = |(more, less): (Synthesised, Synthesised)| CellDelta {
            luts: difference(more.luts, less.luts),
            multipliers: difference(more.multipliers, less.multipliers),
            flip_flops: difference(more.flip_flops, less.flip_flops),
        };
        SizeDelta {
            multipliers: difference(m.multipliers as u64, l.multipliers as u64),
            multiplier_bits: difference(m.multiplier_bits, l.multiplier_bits),
            adders: difference(m.adders as u64, l.adders as u64),
            adder_bits: difference(m.adder_bits, l.adder_bits),
            register_bits: difference(m.register_bits, l.register_bits),
            latency: i64::from(more.design.latency()) - i64::from(less.design.latency()),
            cells: more.cells.zip(less.cells).map(cells),
        }
    }
}

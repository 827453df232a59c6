//! What is counted, and what Lyon's report says of it.
use specula_datapath::Design;

use super::contender::CONTENDERS;

/// What a core takes, by each way of counting.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Two-input gates, inverters included, without flip-flops.
    pub gates: u64,
    /// Look-up tables of four inputs without any block or carry chain.
    pub luts_alone: u64,
    /// Look-up tables of a device that has blocks and carry chains.
    pub luts: u64,
    /// Its multiplier blocks.
    pub blocks: u64,
    /// Flip-flops without blocks.
    pub flip_flops: u64,
    /// Bits of read-only memory, which gates and look-up tables without blocks contain.
    pub table_bits: u64,
    /// Sum over multipliers of the product of their operands' widths.
    pub multiplier_bits: u64,
    /// Clocks from a pixel's entry to its exit.
    pub latency: u64,
}

impl Counts {
    /// What is known of a design without a synthesiser.
    pub fn of(design: &Design) -> Counts {
        let size = design.size();
        Counts {
            table_bits: size.table_bits,
            multiplier_bits: size.multiplier_bits,
            latency: design.latency().into(),
            ..Counts::default()
        }
    }
}

/// A way of counting.
#[derive(Clone, Copy, Debug)]
pub struct Measure {
    /// The title of its column.
    pub title: &'static str,
    /// The number.
    pub of: fn(&Counts) -> u64,
}

impl Measure {
    /// Everything that is counted, in the order of tables.
    pub const ALL: [Measure; 8] = [
        Measure { title: "two-input gates", of: |counts| counts.gates },
        Measure { title: "flip-flops", of: |counts| counts.flip_flops },
        Measure { title: "LUTs alone", of: |counts| counts.luts_alone },
        Measure { title: "LUTs beside blocks", of: |counts| counts.luts },
        Measure { title: "blocks", of: |counts| counts.blocks },
        Measure { title: "bits of tables", of: |counts| counts.table_bits },
        Measure { title: "multiplier bits", of: |counts| counts.multiplier_bits },
        Measure { title: "latency", of: |counts| counts.latency },
    ];
}

/// The contenders' counts in one comparison, in the order of [`CONTENDERS`].
pub type Comparison = [Counts; CONTENDERS.len()];

/// A claim about sizes.
#[derive(Clone, Copy, Debug)]
pub struct SizeClaim {
    /// The claim as text.
    pub what: &'static str,
    /// The ratio that decides it, as text.
    pub quantity: &'static str,
    /// The contenders whose counts are divided.
    between: [usize; 2],
    /// The count.
    of: fn(&Counts) -> u64,
}

impl SizeClaim {
    /// The ratio: the claim holds where it is below 1. `None` where there is nothing to divide by.
    pub fn ratio(&self, counts: &Comparison) -> Option<f64> {
        // Numbers of cells are far below 2^53.
        let [a, b] = self.between.map(|contender| (self.of)(&counts[contender]) as f64);
        (b > 0.0).then(|| a / b)
    }
}

const PHONG: usize = 0;
const FIGURE_7: usize = 1;
const FIGURE_8: usize = 2;
const CROSS: usize = 3;

/// The claims, Lyon's first.
pub const CLAIMS: [SizeClaim; 8] = [
    SizeClaim {
        what: "the reformulation is simpler hardware than standard Phong shading, of Lyon's day",
        quantity: "two-input gates, figures 6 and 7 / Phong",
        between: [FIGURE_7, PHONG],
        of: |c| c.gates,
    },
    SizeClaim {
        what: "",
        quantity: "flip-flops, figures 6 and 7 / Phong",
        between: [FIGURE_7, PHONG],
        of: |c| c.flip_flops,
    },
    SizeClaim {
        what: "the same without blocks",
        quantity: "LUTs alone, figures 6 and 7 / Phong",
        between: [FIGURE_7, PHONG],
        of: |c| c.luts_alone,
    },
    SizeClaim {
        what: "the same of today",
        quantity: "LUTs beside blocks, figures 6 and 7 / Phong",
        between: [FIGURE_7, PHONG],
        of: |c| c.luts,
    },
    SizeClaim {
        what: "",
        quantity: "blocks, figures 6 and 7 / Phong",
        between: [FIGURE_7, PHONG],
        of: |c| c.blocks,
    },
    SizeClaim {
        what: "figure 8's multipliers are smaller than figure 7's",
        quantity: "multiplier bits, figure 8 / figure 7",
        between: [FIGURE_8, FIGURE_7],
        of: |c| c.multiplier_bits,
    },
    SizeClaim {
        what: "",
        quantity: "two-input gates, figure 8 / figure 7",
        between: [FIGURE_8, FIGURE_7],
        of: |c| c.gates,
    },
    SizeClaim {
        what: "D = H × N is simpler than D = R − L (our question, not a claim)",
        quantity: "two-input gates, H × N / figures 6 and 7",
        between: [CROSS, FIGURE_7],
        of: |c| c.gates,
    },
];

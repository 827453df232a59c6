//! How the look-up tables that a design takes are counted.
use serde::Deserialize;

use crate::verilog::Counted;

/// Cells of the fabric, as far as they are counted.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Logic {
    /// Where the carries of sums are.
    pub carry: Carry,
    /// What a look-up table and a flip-flop are to each other.
    pub cell: LogicCell,
    /// Look-up tables that four bits of a delay line in memory take.
    pub memory: u64,
    /// The share of a device's look-up tables, or of its logic cells, that a core may take.
    pub usable: f64,
}

/// Where the carries of sums are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Carry {
    /// Behind a look-up table of each bit, which inverts what is subtracted.
    #[default]
    Behind,
    /// Beside the look-up table of each bit, on the same inputs: what is subtracted is inverted
    /// before both, and the look-up table has an input left for a gate behind the sum.
    Beside,
    /// In cells of two bits, which take the place of two look-up tables.
    Pair,
}

impl Carry {
    /// Look-up tables of a chain of so many bits, of which so many are read.
    pub fn luts(self, length: u64, read: u64) -> u64 {
        match self {
            Carry::Behind => length,
            // A bit that nobody reads has its carry alone.
            Carry::Beside => read,
            Carry::Pair => length.next_multiple_of(2),
        }
    }
}

/// What a look-up table and a flip-flop are to each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LogicCell {
    /// A flip-flop takes what any cell gives.
    #[default]
    Apart,
    /// A flip-flop takes what its own look-up table gives, which is no other's then.
    Paired,
}

impl Default for Logic {
    fn default() -> Logic {
        Logic { carry: Carry::Behind, cell: LogicCell::Apart, memory: 0, usable: 0.9 }
    }
}

impl Logic {
    /// Look-up tables of the delay lines in memory, and of the counters of their addresses.
    pub fn of_delay_lines(&self, counted: &Counted) -> u64 {
        // A counter has a sum, and a table that tells its last number.
        let counters = counted.counters * (4 + 1);
        self.memory * counted.memories(MEMORY_BITS) + counters
    }
}

/// Bits of a word of the memory that look-up tables make.
const MEMORY_BITS: u64 = 4;

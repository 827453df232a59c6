//! What an FPGA tool makes of a design: Yosys, for the ECP5, whose cells it maps without any vendor's program.
use specula_hdl::Design;

use crate::SimError;
use crate::external::{Tool, Workshop};

const YOSYS: Tool = Tool {
    name: "Yosys",
    command: "yosys",
    version_argument: "--version",
    install: "install Yosys, from its own site or by the package `yosys`",
    otherwise: "leave out `--synthesis`",
};

/// The file into which cells are counted.
const COUNTS: &str = "cells.txt";

/// Cells of an ECP5.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Synthesised {
    /// Look-up tables of four inputs: `LUT4`, and the two of each carry cell, `CCU2C`.
    pub luts: u64,
    /// Multipliers of 18 x 18 bits, `MULT18X18D`.
    pub multipliers: u64,
    /// Flip-flops, `TRELLIS_FF`.
    pub flip_flops: u64,
}

/// Synthesises a design by itself, without pads. It takes some ten seconds.
///
/// # Errors
/// [`SimError::ToolAbsent`] if Yosys is not installed, [`SimError::ToolFailed`] if it fails.
pub fn synthesise(design: &Design) -> Result<Synthesised, SimError> {
    let workshop = Workshop::new(design)?;
    let (source, core) = (&workshop.source, &workshop.ports.core);
    let script = format!("read_verilog {source}; synth_ecp5 -top {core}; tee -q -o {COUNTS} stat");
    YOSYS.run(workshop.path(), &["-q".to_owned(), "-p".to_owned(), script])?;
    let text = std::fs::read_to_string(workshop.path().join(COUNTS)).map_err(SimError::file("read what Yosys counted"))?;
    let [luts, carries, multipliers, flip_flops] = ["LUT4", "CCU2C", "MULT18X18D", "TRELLIS_FF"].map(|cell| count(&text, cell));
    Ok(Synthesised { luts: luts + 2 * carries, multipliers, flip_flops })
}

/// The number in the first line that names the cell, before or behind its name, as versions of Yosys have it; 0 if none does.
fn count(text: &str, cell: &str) -> u64 {
    let line = text.lines().find(|line| line.split_whitespace().any(|word| word == cell));
    line.and_then(|line| line.split_whitespace().find_map(|word| word.parse().ok())).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_counted_in_either_column() {
        let text = "   Number of cells:  9\n     LUT4                         1721\n     12   5.0 MULT18X18D\n";
        assert_eq!(["LUT4", "MULT18X18D", "TRELLIS_FF"].map(|cell| count(text, cell)), [1721, 12, 0]);
    }
}

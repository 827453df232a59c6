//! The stimulus as a file: a line for each hold, all numbers hexadecimal.
//!
//! ```text
//! clocks valid starts input input ...
//! ```
//! Inputs are in two's complement, as wide as their port.
use std::io::{self, BufWriter, Write};

use specula_datapath::Design;
use specula_datapath::design::wrapped;

use crate::Stimulus;

/// Writes the whole of `stimulus`.
pub fn write_stimulus(out: impl Write, stimulus: &Stimulus, design: &Design) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    for hold in stimulus.holds() {
        let clocks = hold.clocks.end - hold.clocks.start;
        write!(out, "{clocks:x} {:x} {:x}", u8::from(hold.valid), u8::from(hold.starts))?;
        for (index, node) in design.inputs.iter().enumerate() {
            let Some(node) = *node else { continue };
            // Before the first span there are no inputs yet; registers hold 0 then, and so do the
            // pins.
            let raw = hold.inputs.get(index).copied().unwrap_or(0);
            write!(out, " {:x}", wrapped(raw, design.node(node).width(), false))?;
        }
        writeln!(out)?;
    }
    out.flush()
}

//! Waveforms: a window of a simulation as a VCD [IEEE 1364-2005, section 18].
//!
//! Time is in nanoseconds and a clock takes 10: clock c begins with the rising edge at 10 c, so
//! that a time means the same clock in every window. `reset` is 0 throughout, since the clock of
//! reset comes before clock 0.
//!
//! The text is made here and not by the `vcd` crate, whose writer makes every bit of a value one by
//! one and is about 80 times slower: most of the time of a run that is traced would go into it.
//! That crate reads what others write.
mod header;
mod record;
mod rows;
mod waves;

use std::io::{self, Write};

use specula_datapath::Design;

use crate::Columns;
pub use waves::Waves;

/// Nanoseconds from a rising edge to the next.
pub const PERIOD: u64 = 10;

/// Writes the waveforms of `columns` in one go; `about` says what they are of, such as the scene's
/// name and the design's.
///
/// # Errors
/// What the system says if `out` cannot be written.
pub fn write(out: impl Write, design: &Design, columns: &Columns, about: &str) -> io::Result<()> {
    let mut waves = Waves::begin(out, design, &columns.nodes, about)?;
    waves.append(&columns.batch())?;
    waves.end()
}

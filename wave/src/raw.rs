//! Changes of signals as a reader finds them, before they are converted for drawing.
use std::ops::ControlFlow;

/// A change of a signal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change<'a> {
    /// Time of the change in the file's units.
    pub time: u64,
    /// The signal's number.
    pub signal: u32,
    /// Its new value.
    pub value: Raw<'a>,
    /// Whether the change stands in a section that states the value of every signal, changed or
    /// not.
    pub checkpoint: bool,
}

/// A value as it stands in a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Raw<'a> {
    /// Bits from the highest to the lowest, as digits and letters of any case.
    Bits(&'a [u8]),
    /// Text in any encoding.
    Text(&'a [u8]),
    /// A real number.
    Real(f64),
}

/// A receiver of changes, which may ask the reader to stop.
pub type ChangeSink<'a> = dyn FnMut(Change) -> ControlFlow<()> + 'a;

/// The states of a bit in Verilog and VHDL.
pub const STATES: [u8; 9] = *b"01xzuwlh-";

//! Changes of signals as a reader finds them, before it is known how they are drawn.
use std::ops::ControlFlow;

/// A change of a signal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change<'a> {
    /// When, in the file's units.
    pub time: u64,
    /// The signal's number.
    pub signal: u32,
    /// Its new value.
    pub value: Raw<'a>,
    /// Whether the file states the value of every signal there, changed or not.
    pub checkpoint: bool,
}

/// A value as a file has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Raw<'a> {
    /// Bits from the highest to the lowest, as digits and letters of any case.
    Bits(&'a [u8]),
    /// Text in any encoding.
    Text(&'a [u8]),
    /// A real number.
    Real(f64),
}

/// Who takes changes, and may have enough of them.
pub type Taker<'a> = dyn FnMut(Change) -> ControlFlow<()> + 'a;

/// The states of a bit: those of Verilog and of VHDL.
pub const STATES: [u8; 9] = *b"01xzuwlh-";

//! Mistakes in using the builder.
use crate::pass::LoopTooLate;

/// Why a design cannot be built. Signals and units are named by their path from the design down.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BuildError {
    /// A proven range is wider than signals may be.
    #[error(
        "signal `{signal}` needs {width} bits, and the most is 63: give the narrowing points before it fewer fraction bits"
    )]
    SignalTooWide {
        /// The signal.
        signal: String,
        /// Bits its proven range needs.
        width: u32,
    },
    /// A unit is given a value of a unit other than the one around it.
    #[error(
        "input `{port}` of unit `{unit}` is `{signal}`, which belongs to another unit: make it an output of that unit first"
    )]
    ForeignInput {
        /// The port.
        port: String,
        /// The unit.
        unit: String,
        /// What it is given.
        signal: String,
    },
    /// A unit gives a value of another unit.
    #[error(
        "unit `{unit}` gives `{signal}`, which belongs to another unit: make it an input of the unit first"
    )]
    ForeignOutput {
        /// The unit.
        unit: String,
        /// What it gives.
        signal: String,
    },
    /// A table is read at an address that can be negative.
    #[error("a table is read at `{signal}`, which can be negative: addresses are unsigned")]
    NegativeAddress {
        /// The address.
        signal: String,
    },
    /// What a loop makes of a value has its binary point elsewhere.
    #[error(
        "the loop through `{signal}` begins with {loaded} fraction bits and goes on with {followed}: round what follows"
    )]
    LoopMovesPoint {
        /// The register of the loop.
        signal: String,
        /// Fraction bits of what the loop begins with.
        loaded: u32,
        /// Fraction bits of what it goes on with.
        followed: u32,
    },
    /// A loop reads what is there after its own clock.
    #[error(transparent)]
    LoopTooLate(#[from] LoopTooLate),
}

//! Devices of a family, and what each has.
use serde::Deserialize;

/// A device, as far as a core's size is compared with it.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Device {
    /// Its name on the command line.
    pub name: String,
    /// Look-up tables.
    pub luts: u64,
    /// Flip-flops.
    pub flip_flops: u64,
    /// Multiplier blocks.
    pub blocks: u64,
    /// Block RAMs.
    pub memories: u64,
}

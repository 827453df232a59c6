//! Error against run time and size: methods × formats on one scene, in hardware, and the papers'
//! loops in software.
//!
//! A [`Configuration`] becomes a core; [`Measured`] contains the results of simulating every pixel,
//! its cycles and figures of its design. A [`Journal`] keeps results by spec, so that an
//! interrupted sweep can be continued.
mod configuration;
mod cycles;
mod journal;
mod measured;
mod predicted;
pub mod software;
mod software_equivalent;
mod surface;
mod sweep;
mod thread_clock;

pub use configuration::{Configuration, Formats};
pub use cycles::{FrameCycles, WORD_BITS};
pub use journal::{Damaged, Journal, JournalError};
pub use measured::Measured;
pub use predicted::predicted_mhz;
pub use software_equivalent::software_equivalent;
pub use surface::interpolation_errors;
pub use sweep::{Measurement, Planned, SweepError, SweepResult, plan, sweep};

//! Error against run time and size: methods × formats on one scene, in hardware, and the papers'
//! loops in software.
//!
//! A [`Configuration`] becomes a core; [`Measured`] is what every pixel of its simulation, its
//! cycles and its design say of it. A [`Journal`] keeps results by spec, so that a sweep goes on
//! where it was interrupted.
mod configuration;
mod counterpart;
mod cycles;
mod journal;
mod measured;
pub mod software;
mod surface;
mod sweep;
mod thread_clock;

pub use configuration::{Configuration, Formats};
pub use counterpart::counterpart;
pub use cycles::{FrameCycles, WORD_BITS};
pub use journal::{Damaged, Journal, JournalError};
pub use measured::Measured;
pub use surface::interpolation_errors;
pub use sweep::{Measurement, Planned, Row, SweepError, plan, sweep};

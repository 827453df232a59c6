//! What has been measured.
use specula_experiments::benchmark::{Budget, Measurement};
use specula_testbench::Bench;

/// A measurement, and the core and scene that were measured.
pub struct Measured<'a> {
    pub scene: &'a str,
    pub bench: &'a Bench<'a>,
    pub budget: Budget,
    pub measurement: Measurement,
}

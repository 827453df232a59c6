//! How methods raise the bases of their highlights to powers.
use serde::{Deserialize, Serialize};
use specula_datapath::Format;
use specula_scene::needs::Needs;

use super::narrowing::UNIT;
use super::{Choice, CoreSpec, InputPort, NarrowingPoint, SpecError};

/// How a power is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Power {
    /// n = 2^j, by j squarings.
    Squaring,
    /// Any n, as 2^(n log₂ b), by tables.
    Tables,
}

/// The power of a method's highlight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerUnit {
    /// How it is taken.
    pub power: Power,
    /// log₂ of what the exponent is of n.
    pub log2_factor: u32,
    /// Format of the base, and of each square of it.
    pub base: Format,
    /// Format of what tables give.
    pub shape: Format,
}

impl Power {
    /// The option that methods with the choice have.
    pub(super) const CHOICE: Choice =
        Choice { key: "power", values: &["\"squaring\"", "\"tables\""] };

    /// By squaring where that reaches every exponent.
    pub(super) fn for_needs(needs: &Needs) -> Power {
        if needs.uneven_shininess.is_none() { Power::Squaring } else { Power::Tables }
    }

    /// What it is, for people to read.
    pub(super) fn option(self) -> (&'static str, String) {
        let power = match self {
            Power::Squaring => "b^n by squaring, n = 2^j",
            Power::Tables => "b^n = 2^(n log2 b) by tables",
        };
        ("power", power.to_owned())
    }

    /// Whether it reaches every exponent.
    ///
    /// # Errors
    /// [`SpecError::UnevenShininess`] in the name of `method` if not.
    pub(super) fn check_serves(self, needs: &Needs, method: &'static str) -> Result<(), SpecError> {
        match (self, needs.uneven_shininess) {
            (Power::Squaring, Some(shininess)) => {
                let above = shininess.next_power_of_two();
                Err(SpecError::UnevenShininess { method, shininess, below: above / 2, above })
            }
            _ => Ok(()),
        }
    }
}

impl PowerUnit {
    /// Format of the power.
    pub fn format(&self) -> Format {
        match self.power {
            Power::Squaring => self.base,
            Power::Tables => self.shape,
        }
    }

    /// The narrowing point behind the base, if there is one.
    pub(super) fn narrowing_point(&self) -> Option<NarrowingPoint> {
        let shape = || {
            NarrowingPoint::rounded("shape", self.shape, UNIT, "the power of the base, by tables")
                .with_at_most(16)
        };
        (self.power == Power::Tables).then(shape)
    }

    /// The port of the exponent, or of its logarithm.
    pub fn port(&self, core: &CoreSpec) -> InputPort {
        let largest = core.largest_shininess << self.log2_factor;
        let port = |name: &str, low: u32, high: u32| {
            let format = Format::unsigned((u32::BITS - high.leading_zeros()).max(1), 0);
            InputPort::between(name, format, low.into(), high.into())
        };
        match self.power {
            Power::Squaring => port("log2_exponent", 0, largest.ilog2()),
            Power::Tables => port("exponent", 1, largest),
        }
    }

    /// What the port is given.
    pub(super) fn input(&self, shininess: u32) -> i64 {
        let exponent = shininess << self.log2_factor;
        match self.power {
            Power::Squaring => exponent.ilog2().into(),
            Power::Tables => exponent.into(),
        }
    }
}

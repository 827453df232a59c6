//! How methods raise the bases of their highlights to powers.
use serde::{Deserialize, Serialize};
use specula_datapath::Format;
use specula_scene::needs::Needs;

use crate::core_input::{CoreInput, InputRole};
use crate::error::SpecError;
use crate::input_meaning::InputMeaning;
use crate::narrowing::{NarrowingPoint, UNIT};
use crate::parameters::CoreParameters;
use crate::shading_method::OptionDomain;

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
    pub(crate) const OPTION_DOMAIN: OptionDomain =
        OptionDomain { key: "power", values: &["\"squaring\"", "\"tables\""] };

    /// By squaring where that reaches every exponent.
    pub(crate) fn for_needs(needs: &Needs) -> Power {
        if needs.uneven_shininess.is_none() { Power::Squaring } else { Power::Tables }
    }

    /// What it is, for people to read.
    pub(crate) fn option(self) -> (&'static str, String) {
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
    pub(crate) fn check_compatible(
        self,
        needs: &Needs,
        method: &'static str,
    ) -> Result<(), SpecError> {
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
    pub(crate) fn narrowing_point(&self) -> Option<NarrowingPoint> {
        let shape = || {
            NarrowingPoint::rounded("shape", self.shape, UNIT, "the power of the base, by tables")
                .with_at_most(16)
        };
        (self.power == Power::Tables).then(shape)
    }

    /// The input for the exponent, or for its logarithm.
    pub fn exponent_input(&self, core: &CoreParameters) -> CoreInput {
        let largest = core.largest_shininess << self.log2_factor;
        let input = |meaning: InputMeaning, name: &str, low: u32, high: u32| {
            let format = Format::unsigned((u32::BITS - high.leading_zeros()).max(1), 0);
            CoreInput::between(meaning, name, format, low.into(), high.into())
        };
        let of = |what: &'static str, computed: String| {
            InputMeaning::of(InputRole::Exponent, what, computed)
        };
        let exponent = format!("{} times the material's exponent n", 1 << self.log2_factor);
        match self.power {
            Power::Squaring => {
                let logarithm =
                    of("log2 of the highlight's exponent", format!("log2 of {exponent}"));
                input(logarithm, "log2_exponent", 0, largest.ilog2())
            }
            Power::Tables => {
                input(of("the highlight's exponent", exponent), "exponent", 1, largest)
            }
        }
    }

    /// The raw value of that input.
    pub(crate) fn exponent(&self, shininess: u32) -> i64 {
        let exponent = shininess << self.log2_factor;
        match self.power {
            Power::Squaring => exponent.ilog2().into(),
            Power::Tables => exponent.into(),
        }
    }
}

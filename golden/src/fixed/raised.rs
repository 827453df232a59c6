//! Powers of highlights' bases, as the spec has them taken.
use specula_spec::{CoreParameters, Format, PowerUnit, power};

use super::number::Wide;
use super::observer::{Observer, narrow};
use super::power::Power;

/// b^n in one core's formats.
pub(super) enum Raised {
    /// n = 2^j, by j squarings.
    Squaring {
        /// Of each square.
        base: Format,
    },
    /// Any n.
    Tables {
        /// The unit.
        power: Power,
        /// Of the power.
        shape: Format,
    },
}

impl Raised {
    pub fn new(core: &CoreParameters, unit: PowerUnit) -> Raised {
        match unit.power {
            power::Power::Squaring => Raised::Squaring { base: unit.base },
            power::Power::Tables => {
                let exponent_bits = unit.exponent_input(core).port.format.integer_bits;
                Raised::Tables {
                    power: Power::new(exponent_bits, unit.shape.fraction_bits),
                    shape: unit.shape,
                }
            }
        }
    }

    /// Format of the power.
    pub fn format(&self) -> Format {
        match self {
            Raised::Squaring { base } => *base,
            Raised::Tables { shape, .. } => *shape,
        }
    }

    /// b^n of what the port of the exponent is given.
    pub fn raise(&self, observer: &mut impl Observer, base: Wide, exponent: Wide) -> Wide {
        match self {
            Raised::Squaring { base: format } => {
                let squarings = exponent.to_num::<u32>();
                (0..squarings)
                    .fold(base, |b, j| narrow(observer, format_args!("square{j}"), b * b, *format))
            }
            Raised::Tables { power, shape } => {
                let power = power.raise(base, exponent.to_num());
                observer.see(format_args!("power"), power, *shape);
                power
            }
        }
    }
}

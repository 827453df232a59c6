//! Powers of highlights' bases, as the spec has them taken.
use specula_scene::spec::power::{Power, PowerUnit};

use super::{any_power, power};
use specula_datapath::builder::{Builder, Sig};

/// base^n; `exponent` is what the unit's port is given.
pub fn raised(b: &Builder, base: &Sig, exponent: &Sig, unit: PowerUnit) -> Sig {
    let fraction_bits = unit.format().fraction_bits;
    match unit.power {
        Power::Squaring => power(b, base, exponent, fraction_bits),
        Power::Tables => any_power(b, base, exponent, fraction_bits),
    }
}

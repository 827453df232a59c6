//! What spots leave of their light: max(S·L, 0)^p [Hast, Barrera and Bengtsson, after eq. 35].
use specula_spec::{CoreParameters, Format};

use super::method::Intensities;
use super::number::{Wide, round_to};
use super::observer::Observer;
use super::power::Power;

/// All spots of a core.
pub(super) struct Spots {
    /// Of the cosine between a spot's axis and the way from it.
    base: Format,
    /// Of the share.
    shape: Format,
    power: Power,
}

impl Spots {
    /// Those of a core, if it has any.
    pub fn new(core: &CoreParameters, base: Format, shape: Format) -> Option<Spots> {
        let exponent_bits = u32::BITS - core.largest_spot_exponent().leading_zeros();
        let mut exponents = (0..core.lights).filter_map(|index| core.spot_exponent(index));
        exponents.next().map(|_| Spots {
            base,
            shape,
            power: Power::new(exponent_bits, shape.fraction_bits),
        })
    }

    /// The share of one, of its exact cosine.
    pub fn share(&self, observer: &mut impl Observer, cosine: Wide, exponent: Wide) -> Wide {
        let cosine = round_to(cosine, self.base.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("spot_base"), cosine, self.base);
        let share = self.power.raise(cosine, exponent.to_num());
        observer.see(format_args!("spot"), share, self.shape);
        share
    }
}

/// The share of an amount of light, rounded to its format; all of it where there is no spot.
pub(super) fn share_of(share: Option<Wide>, amount: Wide, format: Format) -> Wide {
    share.map_or(amount, |share| round_to(share * amount, format.fraction_bits))
}

/// The same of both intensities.
pub(super) fn spotted(
    share: Option<Wide>,
    intensities: Intensities<Wide>,
    formats: &Intensities<Format>,
) -> Intensities<Wide> {
    Intensities {
        diffuse: share_of(share, intensities.diffuse, formats.diffuse),
        specular: share_of(share, intensities.specular, formats.specular),
    }
}

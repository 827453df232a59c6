//! What distance leaves of lights, bit for bit, whatever the method is [Hast, Barrera and Bengtsson,
//! §1; `docs/arithmetic.md`].
use specula_spec::attenuation::AttenuationFormats;
use specula_spec::{CoreParameters, Format, Quadratic};

use super::error::PacketError;
use super::method::Intensities;
use super::number::{Wide, round_to};
use super::observer::Observer;
use super::span_extent::{SpanExtent, quadratic_at};
use super::spot::spotted;

/// The lights of one core, some of which become weaker.
pub(super) struct Attenuation(AttenuationFormats);

impl Attenuation {
    /// That of a core, if any of its lights becomes weaker.
    pub fn new(core: &CoreParameters) -> Option<Attenuation> {
        core.attenuation.as_ref().map(|attenuation| Attenuation(attenuation.formats.clone()))
    }

    /// Whether what distance leaves of light number `index` stays where it can be.
    pub fn check(
        &self,
        index: usize,
        along: &Quadratic<Wide>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        let name = format_args!("light{index}_attenuation");
        extent.share(name, along, self.0.attenuation_accumulator)
    }

    /// What distance leaves of intensities at pixel i.
    pub fn of(
        &self,
        along: &Quadratic<Wide>,
        i: u32,
        intensities: Intensities<Wide>,
        observer: &mut impl Observer,
    ) -> Intensities<Wide> {
        let AttenuationFormats { attenuation_accumulator, attenuation, attenuated } = &self.0;
        let accumulated = quadratic_at(along, i);
        observer.see(
            format_args!("attenuation_accumulator"),
            accumulated,
            *attenuation_accumulator,
        );
        let share = round_to(accumulated, attenuation.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("attenuation"), share, *attenuation);
        let arriving = spotted(Some(share), intensities, &self.formats());
        observer.see(format_args!("attenuated_diffuse"), arriving.diffuse, *attenuated);
        observer.see(format_args!("attenuated_specular"), arriving.specular, *attenuated);
        arriving
    }

    /// Formats of what arrives.
    pub fn formats(&self) -> Intensities<Format> {
        Intensities { diffuse: self.0.attenuated, specular: self.0.attenuated }
    }
}

//! What distance leaves of lights, whatever the method is [Hast, Barrera and Bengtsson, §1].
use specula_spec::attenuation::{AttenuationFormats, OVERSHOOT};
use specula_spec::{CoreInputs, CoreParameters, InputGroup, LightInputs, Quadratic};

use super::common::Intensities;
use super::forward::Forward;
use super::share::{self, Share};
use crate::units;
use specula_datapath::builder::{Builder, Sig, TimeSlots};

/// The lights of a core, some of which become weaker.
pub(super) struct Attenuation<'a> {
    forward: Forward<'a>,
    formats: &'a AttenuationFormats,
    /// Whether the light of each pipeline becomes weaker.
    applies: Vec<Sig>,
}

impl<'a> Attenuation<'a> {
    /// That of a core, if any of its lights becomes weaker.
    pub fn new(
        b: &'a Builder,
        parameters: &'a CoreParameters,
        slots: &'a TimeSlots,
    ) -> Option<Attenuation<'a>> {
        let formats = &parameters.attenuation.as_ref()?.formats;
        let forward = Forward { b, first: &slots.first_pixel, steps: parameters.longest_span - 1 };
        let becomes_weaker = |index| parameters.attenuation_of(index).is_some();
        let applies = share::applies(b, slots, (0..parameters.lights).map(becomes_weaker));
        Some(Attenuation { forward, formats, applies })
    }

    /// What distance leaves of the intensities of pipeline number `index`.
    pub fn of(
        &self,
        index: usize,
        along: Option<&Quadratic<Sig>>,
        intensities: Intensities,
    ) -> Intensities {
        let Some(along) = along else { return intensities };
        let AttenuationFormats { attenuation, attenuated, .. } = *self.formats;
        let (b, bits) = (self.forward.b, attenuation.fraction_bits);
        let called = |part: &str| format!("light{index}_{part}");
        let limits = (-OVERSHOOT, 1.0 + OVERSHOOT);
        let along = self.forward.quadratic(&called("attenuation"), along, limits, bits);
        let share = b.instance(&called("arriving"), || units::clamp_share(b, &along, bits));
        let share = Share { applies: self.applies[index].clone(), share };
        share.of_both(intensities, [attenuated.fraction_bits; 2])
    }
}

/// The inputs of lights; those that share a pipeline have the same ones if one of them becomes
/// weaker: the others stay whole.
pub(super) fn alike<S, L>(
    b: &Builder,
    slots: &TimeSlots,
    inputs: &CoreInputs<S, L, Sig>,
) -> Vec<LightInputs<L, Sig>>
where
    L: InputGroup<Value = Sig, Mapped<Sig> = L>,
{
    let mut lights: Vec<LightInputs<L, Sig>> =
        inputs.lights.iter().map(|light| light.map_each(&mut Sig::clone)).collect();
    if slots.count() > 1 && lights.iter().any(|light| light.attenuation.is_some()) {
        let whole = || Quadratic {
            start: b.integer(1),
            first_difference: b.integer(0),
            second_difference: b.integer(0),
        };
        lights.iter_mut().for_each(|light| {
            light.attenuation.get_or_insert_with(whole);
        });
    }
    lights
}

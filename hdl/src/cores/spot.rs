//! What spots leave of their light, where ways to places are followed.
use specula_spec::{CoreParameters, LightInputs};

use super::share;
use specula_datapath::builder::{Builder, Sig, TimeSlots};

/// Whether the light of each pipeline is a spot.
pub(super) fn spots(b: &Builder, parameters: &CoreParameters, slots: &TimeSlots) -> Vec<Sig> {
    let is_spot = |index| parameters.spot_exponent(index).is_some();
    share::applies(b, slots, (0..parameters.lights).map(is_spot))
}

/// Gives lights that share a pipeline the inputs of spots if one of them is a spot, what `none`
/// makes of 0 where they are none; `spot` finds those of a light that has a way.
pub(super) fn alike<L, S>(
    b: &Builder,
    slots: &TimeSlots,
    lights: &mut [LightInputs<L, Sig>],
    spot: impl Fn(&mut L) -> Option<&mut Option<S>>,
    none: impl Fn(&Sig) -> S,
) {
    let mut spots: Vec<&mut Option<S>> =
        lights.iter_mut().filter_map(|inputs| spot(&mut inputs.light)).collect();
    if slots.count() == 1 || spots.iter().all(|spot| spot.is_none()) {
        return;
    }
    let zero = b.integer(0);
    spots.iter_mut().for_each(|spot| {
        spot.get_or_insert_with(|| none(&zero));
    });
}

//! Lights of all kinds in one form, so that they can share a pipeline.
use specula_spec::phong::{PhongLight, Way};

use super::super::pipelines;
use specula_datapath::builder::{Builder, Sig, TimeSlots};

/// A pipeline's light, which may be another in every time slot.
pub(super) struct Lamp {
    pub light: PhongLight<Sig>,
    /// Whether it is at a place.
    pub local: Sig,
    /// Whether it is a spot.
    pub spot: Sig,
}

/// The lights of each pipeline.
pub(super) fn lamps(b: &Builder, slots: &TimeSlots, lights: &[PhongLight<Sig>]) -> Vec<Lamp> {
    let bit = |is: bool| b.integer(i64::from(is));
    let bits = |is: fn(&PhongLight<Sig>) -> bool| {
        lights.iter().map(|light| bit(is(light))).collect::<Vec<Sig>>()
    };
    let (local, spot) = (bits(|light| light.way.is_some()), bits(|light| light.exponent.is_some()));
    if slots.count() == 1 {
        let lamp = |((light, local), spot)| Lamp { light, local, spot };
        return pipelines(slots, lights).into_iter().zip(local).zip(spot).map(lamp).collect();
    }
    let lamp =
        |light| Lamp { light, local: slots.multiplexed(&local), spot: slots.multiplexed(&spot) };
    pipelines(slots, &alike(b, lights)).into_iter().map(lamp).collect()
}

/// The lights with the inputs of all kinds among them; those that a light has no use for are 0.
fn alike(b: &Builder, lights: &[PhongLight<Sig>]) -> Vec<PhongLight<Sig>> {
    let zero = || b.integer(0);
    let zeros = || [zero(), zero(), zero()];
    let way = lights.iter().find_map(|light| light.way.as_ref());
    let still = way.map(|way| Way {
        start: zeros(),
        delta: zeros(),
        axis: way.axis.as_ref().map(|_| zeros()),
    });
    let any = |has: fn(&PhongLight<Sig>) -> bool| lights.iter().any(has);
    let has_direction = any(|light| light.direction.is_some());
    let has_axis = any(|light| light.axis.is_some());
    let has_exponent = any(|light| light.exponent.is_some());
    let has_light_dot_view = any(|light| light.light_dot_view.is_some());
    let has_halfway_gain = any(|light| light.halfway_gain.is_some());
    let filled = |light: &PhongLight<Sig>| PhongLight {
        direction: light.direction.clone().or(has_direction.then(zeros)),
        way: light.way.as_ref().or(still.as_ref()).map(|way| way.map(Sig::clone)),
        axis: light.axis.clone().or(has_axis.then(zeros)),
        exponent: light.exponent.clone().or(has_exponent.then(zero)),
        light_dot_view: light.light_dot_view.clone().or(has_light_dot_view.then(zero)),
        halfway_gain: light.halfway_gain.clone().or(has_halfway_gain.then(zero)),
        diffuse: light.diffuse.clone(),
        specular: light.specular.clone(),
    };
    lights.iter().map(filled).collect()
}

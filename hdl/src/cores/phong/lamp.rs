//! Lights of all kinds in one form, so that they can share a pipeline.
use specula_spec::phong::{PhongLight, Way};
use specula_spec::{InputGroup, LightInputs};

use specula_datapath::builder::{Builder, Sig, TimeSlots};

/// The inputs of one light.
type Inputs = LightInputs<PhongLight<Sig>, Sig>;

/// A pipeline's light, which may be another in every time slot.
pub(super) struct Lamp<'a> {
    pub light: &'a PhongLight<Sig>,
    /// Whether it is at a place.
    pub local: Sig,
    /// Whether it is a spot.
    pub spot: Sig,
}

/// Of what kind each light is.
pub(super) struct Kinds {
    local: Vec<Sig>,
    spot: Vec<Sig>,
}

impl Kinds {
    pub fn new(b: &Builder, lights: &[Inputs]) -> Kinds {
        let bits = |is: fn(&PhongLight<Sig>) -> bool| {
            lights.iter().map(|inputs| b.integer(i64::from(is(&inputs.light)))).collect()
        };
        Kinds {
            local: bits(|light| light.way.is_some()),
            spot: bits(|light| light.exponent.is_some()),
        }
    }

    /// The light of pipeline `index`.
    pub fn lamp<'a>(
        &self,
        slots: &TimeSlots,
        index: usize,
        light: &'a PhongLight<Sig>,
    ) -> Lamp<'a> {
        let of_pipeline = |bits: &[Sig]| match slots.count() {
            1 => bits[index].clone(),
            _ => slots.multiplexed(bits),
        };
        Lamp { light, local: of_pipeline(&self.local), spot: of_pipeline(&self.spot) }
    }
}

/// The lights with the inputs of all kinds among them; those that a light has no use for are 0.
pub(super) fn alike(b: &Builder, lights: &[Inputs]) -> impl Iterator<Item = Inputs> {
    let zero = || b.integer(0);
    let zeros = move || [zero(), zero(), zero()];
    let way = lights.iter().find_map(|inputs| inputs.light.way.as_ref());
    let still = way.map(|way| Way {
        start: zeros(),
        delta: zeros(),
        axis: way.axis.as_ref().map(|_| zeros()),
    });
    let any = |has: fn(&PhongLight<Sig>) -> bool| lights.iter().any(|inputs| has(&inputs.light));
    let has_direction = any(|light| light.direction.is_some());
    let has_axis = any(|light| light.axis.is_some());
    let has_exponent = any(|light| light.exponent.is_some());
    let has_light_dot_view = any(|light| light.light_dot_view.is_some());
    let has_halfway_gain = any(|light| light.halfway_gain.is_some());
    let filled = move |light: &PhongLight<Sig>| PhongLight {
        direction: light.direction.clone().or(has_direction.then(zeros)),
        way: light.way.as_ref().or(still.as_ref()).map(|way| way.map_each(&mut Sig::clone)),
        axis: light.axis.clone().or(has_axis.then(zeros)),
        exponent: light.exponent.clone().or(has_exponent.then(zero)),
        light_dot_view: light.light_dot_view.clone().or(has_light_dot_view.then(zero)),
        halfway_gain: light.halfway_gain.clone().or(has_halfway_gain.then(zero)),
    };
    lights.iter().map(move |inputs| LightInputs {
        light: filled(&inputs.light),
        attenuation: inputs
            .attenuation
            .as_ref()
            .map(|attenuation| attenuation.map_each(&mut Sig::clone)),
        diffuse: inputs.diffuse.clone(),
        specular: inputs.specular.clone(),
    })
}

//! What cores have in common: control inputs, the eye, the pipelines of lights, and the tail that
//! makes a pixel of what they give.
use specula_spec::{Components, CoreInputs, CoreParameters, Format, InputGroup, LightInputs};

use super::attenuation::{self, Attenuation};
use crate::units::{self, Light};
use specula_datapath::bound::Interval;
use specula_datapath::builder::{BuildError, Builder, Sig, TimeSlots, Vector};
use specula_datapath::graph::Graph;

/// V = (0, 0, 1): the eye is at infinity, so what multiplies its components folds away.
pub(super) fn eye(b: &Builder) -> Vector {
    Vector::new([0, 0, 1].map(|component| b.integer(component)))
}

/// A unit vector that the host rounded: longer than 1 by √3/2 units of the last place at most.
pub(super) fn unit_vector(components: &[Sig; 3], format: Format) -> Vector {
    Vector::new(components.clone())
        .no_longer_than(1.0 + format.ulp())
        .no_shorter_than(1.0, "it is a unit vector")
}

/// What a scene's needs say of the normals along spans.
pub(super) const SHORTEST_NORMAL: &str = "no normal between two ends is shorter than in any span";

/// What needs say of the squared length of a normal between two ends.
pub(super) fn squared_normal(square: Sig, parameters: &CoreParameters) -> Sig {
    let least = parameters.shortest_normal * parameters.shortest_normal;
    square.real_within(Interval::at_least(least), SHORTEST_NORMAL)
}

/// Opens the control inputs; lights that share a pipeline have a time slot each from there on, and
/// components that share multipliers take turns.
pub(super) fn time_slots(b: &Builder, parameters: &CoreParameters) -> TimeSlots {
    match parameters.components {
        Components::Parallel => b.time_slots(&b.control(), parameters.interval()),
        Components::Serial => b.component_turns(&b.control()),
    }
}

/// The intensities of one light at a pixel, 0 to 1.
pub(super) struct Intensities {
    pub diffuse: Sig,
    pub specular: Sig,
}

/// The inputs of each pipeline: those of each light, or of the light whose time slot it is. Lights
/// are alike: they have the same inputs.
pub(super) fn pipelines<L>(
    slots: &TimeSlots,
    lights: Vec<LightInputs<L, Sig>>,
) -> Vec<LightInputs<L, Sig>>
where
    L: InputGroup<Value = Sig, Mapped<Sig> = L>,
{
    if slots.count() == 1 {
        return lights;
    }
    let inputs = |light: &LightInputs<L, Sig>| {
        let mut inputs = Vec::new();
        light.append_to(&mut inputs);
        inputs
    };
    let of_lights: Vec<Vec<Sig>> = lights.iter().map(inputs).collect();
    let mut columns =
        (0..).map(|k| of_lights.iter().map(|inputs| inputs[k].clone()).collect::<Vec<Sig>>());
    let selected = |first: &LightInputs<L, Sig>| {
        first.map_each(&mut |input: &Sig| {
            columns.next().map_or_else(|| input.clone(), |column| slots.multiplexed(&column))
        })
    };
    lights.first().map(selected).into_iter().collect()
}

/// The codes of the sum of ambient light and what `shade` makes of each pipeline's light are the
/// core's outputs.
pub(super) fn finish<S, L>(
    b: &Builder,
    parameters: &CoreParameters,
    slots: &TimeSlots,
    inputs: &CoreInputs<S, L, Sig>,
    shade: impl Fn(usize, &L) -> Intensities,
) -> Result<Graph, BuildError>
where
    L: InputGroup<Value = Sig, Mapped<Sig> = L>,
{
    b.clone().graph(&slots.valid_in_last_slot, &codes(b, parameters, slots, inputs, shade))
}

/// Those codes, named as the core's first outputs are.
pub(super) fn codes<S, L>(
    b: &Builder,
    parameters: &CoreParameters,
    slots: &TimeSlots,
    inputs: &CoreInputs<S, L, Sig>,
    shade: impl Fn(usize, &L) -> Intensities,
) -> [(&'static str, Sig); 3]
where
    L: InputGroup<Value = Sig, Mapped<Sig> = L>,
{
    let lights = pipelines(slots, attenuation::alike(b, slots, inputs));
    let attenuation = Attenuation::new(b, parameters, slots);
    let shaded = |(index, inputs): (usize, &LightInputs<L, Sig>)| {
        let shaded = shade(index, &inputs.light);
        let Intensities { diffuse, specular } = match &attenuation {
            Some(attenuation) => attenuation.of(index, inputs.attenuation.as_ref(), shaded),
            None => shaded,
        };
        Light {
            diffuse,
            specular,
            diffuse_coefficients: inputs.diffuse.clone(),
            specular_coefficients: inputs.specular.clone(),
        }
    };
    let lights: Vec<Light> = lights.iter().enumerate().map(shaded).collect();
    let [red, green, blue] = units::channels(b, slots, &inputs.ambient, &lights);
    [("red", red), ("green", green), ("blue", blue)]
}

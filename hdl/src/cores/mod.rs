//! Cores: units put together so that a span goes in and pixels come out, one in each clock or,
//! where lights share a pipeline, in as many as there are lights.
mod consistent;
mod direct;
mod duff;
mod forward;
mod gouraud;
mod hybrid;
mod lyon;
mod phong;
mod reflection;
mod slerp;

use std::rc::Rc;

use specula_spec::{
    CoreInputs, CoreParameters, CoreSpec, Format, InputGroup, LightInputs, MethodSpec,
};

use crate::units::{self, Light};
use specula_datapath::bound::Interval;
use specula_datapath::builder::{BuildError, Builder, Sig, TimeSlots, Vector};
use specula_datapath::design::Design;
use specula_datapath::graph::Graph;
use specula_datapath::pass::compile;
use specula_datapath::target::Generic;

/// The core that a spec asks for, elaborated under the module name `name`.
///
/// # Errors
/// [`BuildError`] if the spec's formats ask for a signal of more than 63 bits.
pub fn elaborate(spec: &CoreSpec, name: &str) -> Result<Design, BuildError> {
    let target = Rc::new(Generic);
    let graph = graph(spec, |formula| Builder::new(name, formula, target.clone()))?;
    Ok(compile(&graph, &*target)?)
}

/// The core that a spec asks for, before any pass, described with the builder for its formula.
///
/// # Errors
/// As [`elaborate`].
pub fn graph(
    spec: &CoreSpec,
    builder: impl FnOnce(&'static str) -> Builder,
) -> Result<Graph, BuildError> {
    match &spec.method {
        MethodSpec::Lyon(lyon) => lyon::core(
            builder("Lyon's reformulation of Phong shading [Lyon, TR 43]"),
            &spec.parameters,
            lyon,
            &spec.ports(lyon),
        ),
        MethodSpec::Phong(phong) => phong::core(
            builder("Phong shading with true normalisation [lecture, eq. 2.1, 4.1, 4.2]"),
            &spec.parameters,
            phong,
            &spec.ports(phong),
        ),
        MethodSpec::Hybrid(hybrid) => hybrid::core(
            builder("Gouraud diffuse, specular p/q by forward differences [Hast et al.]"),
            &spec.parameters,
            hybrid,
            &spec.ports(hybrid),
        ),
        MethodSpec::Duff(duff) => duff::core(
            builder("Diffuse p/sqrt q by forward differences [Hast et al.]"),
            &spec.parameters,
            duff,
            &spec.ports(duff),
        ),
        MethodSpec::Gouraud(gouraud) => gouraud::core(
            builder("Intensities of vertices or of polygons [lecture, eq. 2.1, 3.2-3.6]"),
            &spec.parameters,
            gouraud,
            &spec.ports(gouraud),
        ),
        MethodSpec::Reflection(reflection) => reflection::core(
            builder("Reflection shading: quotients of quadratics [Hast et al.]"),
            &spec.parameters,
            reflection,
            &spec.ports(reflection),
        ),
        MethodSpec::Consistent(consistent) => consistent::core(
            builder("Consistent normal interpolation [Reshetov, Soupikov and Mark]"),
            &spec.parameters,
            consistent,
            &spec.ports(consistent),
        ),
        MethodSpec::Slerp(slerp) => slerp::core(
            builder(
                "Incremental spherical interpolation of N.L and N.V [lecture, eq. 4.5, 4.7-4.12]",
            ),
            &spec.parameters,
            slerp,
            &spec.ports(slerp),
        ),
        MethodSpec::Direct(direct) => direct::core(
            builder("Fast Phong shading, evaluated at every pixel [lecture, eq. 4.3-4.6]"),
            &spec.parameters,
            direct,
            &spec.ports(direct),
        ),
    }
}

/// V = (0, 0, 1): the eye is at infinity, so what multiplies its components folds away.
fn eye(b: &Builder) -> Vector {
    Vector::new([0, 0, 1].map(|component| b.integer(component)))
}

/// A unit vector that the host rounded: longer than 1 by √3/2 units of the last place at most.
fn unit_vector(components: &[Sig; 3], format: Format) -> Vector {
    Vector::new(components.clone())
        .no_longer_than(1.0 + format.ulp())
        .no_shorter_than(1.0, "it is a unit vector")
}

/// What a scene's needs say of the normals along spans.
const SHORTEST_NORMAL: &str = "no normal between two ends is shorter than in any span";

/// What needs say of the squared length of a normal between two ends.
fn squared_normal(square: Sig, spec: &CoreParameters) -> Sig {
    let least = spec.shortest_normal * spec.shortest_normal;
    square.real_within(Interval::at_least(least), SHORTEST_NORMAL)
}

/// Opens the control inputs; lights that share a pipeline have a time slot each from there on.
fn time_slots(b: &Builder, spec: &CoreParameters) -> TimeSlots {
    b.time_slots(&b.control(), spec.interval())
}

/// The intensities of one light at a pixel, 0 to 1.
struct Intensities {
    diffuse: Sig,
    specular: Sig,
}

/// The inputs of each pipeline: those of each light, or of the light whose time slot it is. Lights
/// are alike: they have the same inputs.
fn pipelines<L>(slots: &TimeSlots, lights: &[LightInputs<L, Sig>]) -> Vec<LightInputs<L, Sig>>
where
    L: InputGroup<Value = Sig, Mapped<Sig> = L>,
{
    if slots.count() == 1 {
        return lights.iter().map(|light| light.map_each(&mut Sig::clone)).collect();
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
fn finish<S, L>(
    b: &Builder,
    slots: &TimeSlots,
    inputs: &CoreInputs<S, L, Sig>,
    shade: impl Fn(usize, &L) -> Intensities,
) -> Result<Graph, BuildError>
where
    L: InputGroup<Value = Sig, Mapped<Sig> = L>,
{
    let lights = pipelines(slots, &inputs.lights);
    let shaded = |(index, inputs): (usize, &LightInputs<L, Sig>)| {
        let Intensities { diffuse, specular } = shade(index, &inputs.light);
        Light {
            diffuse,
            specular,
            diffuse_coefficients: inputs.diffuse.clone(),
            specular_coefficients: inputs.specular.clone(),
        }
    };
    let lights: Vec<Light> = lights.iter().enumerate().map(shaded).collect();
    let [red, green, blue] = units::channels(b, slots, &inputs.ambient, &lights);
    b.clone().graph(&slots.valid_in_last_slot, &[("red", red), ("green", green), ("blue", blue)])
}

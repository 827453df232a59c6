//! The methods for programs.
use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::Value;
use specula_scene::spec::{LARGEST_SHININESS, MOST_LIGHTS, NarrowingPoint, SpecError};
use specula_scene::{CoreSpec, Format, LoadedScene, Method, Needs};
use specula_testbench::Bench;

use crate::error::ToolError;

/// The scene whose cores are described.
const SCENE: &str = "teapot";

/// One of the objects that `methods --json` prints.
#[derive(Serialize)]
struct MethodFacts {
    name: &'static str,
    summary: &'static str,
    paper: &'static str,
    /// None where the paper does not number them.
    equations: Option<&'static str>,
    needs: SceneFacts,
    /// The values of each key of the method's table in a scene file, its formats apart.
    options: BTreeMap<&'static str, Vec<Value>>,
    /// Of the general core that the teapot's default options give, in the order of the data.
    formats: Vec<FormatFacts>,
    /// Clocks from a pixel's entry to its exit.
    latency: u32,
    /// Of two variables.
    multipliers: usize,
    /// And subtractors.
    adders: usize,
    registers: usize,
    register_bits: u64,
}

/// What a scene must be for the method.
#[derive(Serialize)]
struct SceneFacts {
    most_lights: usize,
    largest_shininess: u32,
    lights_and_eye_at_infinity: bool,
}

#[derive(Serialize)]
struct FormatFacts {
    name: &'static str,
    format: Format,
    /// What is rounded.
    value: &'static str,
}

/// The methods as text.
pub fn text() -> Result<String, ToolError> {
    let scene = specula_scene::load(SCENE, None)?;
    let needs = Needs::of(&scene.frame);
    let methods: Vec<MethodFacts> =
        Method::ALL.into_iter().map(|method| facts(method, &scene, &needs)).collect::<Result<_, ToolError>>()?;
    let mut text = serde_json::to_string_pretty(&methods).map_err(ToolError::Json)?;
    text.push('\n');
    Ok(text)
}

fn facts(method: Method, scene: &LoadedScene, needs: &Needs) -> Result<MethodFacts, ToolError> {
    let spec = scene.core_spec(Some(method))?.general();
    let design = Bench::new(&scene.frame, &spec, &specula_hdl::verilog::module_name(SCENE))?.design;
    let size = design.size();
    Ok(MethodFacts {
        name: method.name(),
        summary: method.summary(),
        paper: method.paper(),
        equations: method.equations(),
        needs: scene_facts(method, needs),
        options: options(method).map_err(ToolError::Json)?,
        formats: spec.narrowing_points().iter().map(format_facts).collect(),
        latency: design.latency(),
        multipliers: size.multipliers,
        adders: size.adders,
        registers: design.nodes.iter().filter(|node| node.registered()).count(),
        register_bits: size.register_bits,
    })
}

/// What the method takes, and whether it refuses a scene that differs from one it serves in the eye.
fn scene_facts(method: Method, needs: &Needs) -> SceneFacts {
    let local = CoreSpec::for_scene(&Needs { local_eye: true, ..needs.clone() }, None, Some(method)).err();
    SceneFacts {
        most_lights: MOST_LIGHTS,
        largest_shininess: LARGEST_SHININESS,
        lights_and_eye_at_infinity: matches!(local, Some(SpecError::Local { .. })),
    }
}

/// TOML writes the values, strings and whole numbers, as JSON does.
fn options(method: Method) -> serde_json::Result<BTreeMap<&'static str, Vec<Value>>> {
    let values = |values: &[&str]| values.iter().map(|value| serde_json::from_str(value)).collect::<serde_json::Result<_>>();
    method.choices().iter().map(|choice| Ok((choice.key, values(choice.values)?))).collect()
}

fn format_facts(point: &NarrowingPoint) -> FormatFacts {
    FormatFacts { name: point.name, format: point.format, value: point.value }
}

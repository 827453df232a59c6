//! The methods as JSON.
use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::Value;
use specula_datapath::Design;
use specula_experiments::operations::Contents;
use specula_experiments::stress::variant::Variant;
use specula_scene::limits::{LARGEST_SHININESS, MOST_LIGHTS};
use specula_scene::{LoadedScene, Needs};
use specula_spec::{Format, Method, NarrowingPoint, SceneCore, Viewpoint};
use specula_testbench::{Bench, BenchError};

use crate::error::ToolError;

/// The scene whose cores are described.
const SCENE: &str = "teapot";

/// One of the objects in the array that `methods --json` prints.
#[derive(Serialize)]
struct MethodFacts {
    name: &'static str,
    summary: &'static str,
    paper: &'static str,
    /// The equations; `None` if the paper does not number them.
    equations: Option<&'static str>,
    needs: SceneFacts,
    /// The values of each key of the method's table in a scene file, except formats.
    options: BTreeMap<&'static str, Vec<Value>>,
    /// The formats of the general core with the default options for the teapot, in the order of the
    /// data flow.
    formats: Vec<FormatFacts>,
    /// Clocks from a pixel's entry to its exit.
    latency: u32,
    /// Operations for a pixel, without powers and the material's products, as the papers count
    /// them.
    operations: Contents,
    /// The core with each value of each option, one option changed at a time.
    variants: Vec<VariantFacts>,
    /// Multipliers of two variables.
    multipliers: usize,
    /// Adders and subtractors.
    adders: usize,
    registers: usize,
    register_bits: u64,
}

/// Which scenes the method can shade.
#[derive(Serialize)]
struct SceneFacts {
    most_lights: usize,
    largest_shininess: u32,
    places_seen_from: Viewpoint,
}

#[derive(Serialize)]
struct VariantFacts {
    option: &'static str,
    value: Value,
    latency: u32,
    operations: Contents,
}

#[derive(Serialize)]
struct FormatFacts {
    name: &'static str,
    format: Format,
    /// The value that is rounded.
    value: &'static str,
}

/// The methods as JSON text.
pub fn text() -> Result<String, ToolError> {
    let scene = specula_scene::load(SCENE, None)?;
    let methods: Vec<MethodFacts> = Method::ALL
        .into_iter()
        .map(|method| facts(method, &scene))
        .collect::<Result<_, ToolError>>()?;
    let mut text = serde_json::to_string_pretty(&methods).map_err(ToolError::Json)?;
    text.push('\n');
    Ok(text)
}

fn facts(method: Method, scene: &LoadedScene) -> Result<MethodFacts, ToolError> {
    let spec = scene.core_spec(Some(method))?.general();
    let design = Bench::new(&scene.frame, &spec, &specula_hdl::module_name(SCENE, &spec))?.design;
    let size = design.size();
    Ok(MethodFacts {
        name: method.name(),
        summary: method.summary(),
        paper: method.paper(),
        equations: method.equations(),
        needs: scene_facts(spec.places_seen_from()),
        options: options(method).map_err(ToolError::Json)?,
        formats: spec.narrowing_points().iter().map(format_facts).collect(),
        latency: design.latency(),
        operations: Contents::of(&design),
        variants: variants(method, scene)?,
        multipliers: size.multipliers,
        adders: size.adders,
        registers: design.nodes.iter().filter(|node| node.registered()).count(),
        register_bits: size.register_bits,
    })
}

/// The scenes that the method can shade.
fn scene_facts(places_seen_from: Viewpoint) -> SceneFacts {
    SceneFacts { most_lights: MOST_LIGHTS, largest_shininess: LARGEST_SHININESS, places_seen_from }
}

/// The core with each value of each option.
fn variants(method: Method, scene: &LoadedScene) -> Result<Vec<VariantFacts>, ToolError> {
    let needs = Needs::of(&scene.frame);
    let all = method.option_domains().iter().chain(method.output_domains());
    let values = all.flat_map(|choice| choice.values.iter().map(|value| (choice.key, *value)));
    let facts = |(option, value): (&'static str, &str)| {
        let design = variant(&needs, &Variant { method, table: format!("{option} = {value}\n") })?;
        let value = serde_json::from_str(value).map_err(ToolError::Json)?;
        Ok(VariantFacts {
            option,
            value,
            latency: design.latency(),
            operations: Contents::of(&design),
        })
    };
    values.map(facts).collect()
}

/// The general core with one option changed.
fn variant(needs: &Needs, variant: &Variant) -> Result<Design, BenchError> {
    let spec = variant.core_spec(needs)?;
    Ok(specula_hdl::elaborate(&spec, SCENE)?)
}

/// The values of each option. TOML writes them, strings and integers, as JSON does.
fn options(method: Method) -> serde_json::Result<BTreeMap<&'static str, Vec<Value>>> {
    let values = |values: &[&str]| {
        values.iter().map(|value| serde_json::from_str(value)).collect::<serde_json::Result<_>>()
    };
    let all = method.option_domains().iter().chain(method.output_domains());
    all.map(|choice| Ok((choice.key, values(choice.values)?))).collect()
}

fn format_facts(point: &NarrowingPoint) -> FormatFacts {
    FormatFacts { name: point.name, format: point.format, value: point.value }
}

//! `specula needs`: what a scene needs, and what its core leaves out.
use std::io::Write;

use clap::Args;
use serde::Serialize;
use specula_datapath::Design;
use specula_experiments::auto::{self, Candidate};
use specula_experiments::{KeepCost, Saving, Savings, SizeDelta, Synthesis, ablation, keep_costs};
use specula_scene::perspective::Interpolation;
use specula_scene::{LoadedScene, Needs};
use specula_sim::{Progress, synthesise};
use specula_spec::{CoreSpec, Method, Specialise};

use crate::arguments::{CoreArguments, SceneArguments, WishedMethod, method_parser};
use crate::error::ToolError;
use crate::verdict::Verdict;
use crate::{progress, table};

const EXAMPLE: &str = "\
Each line is measured by elaborating the core with and without knowledge of that need. Savings \
overlap, so their sum is not what all of them save together. The latter is measured against two \
general cores: one that knows nothing about the scene (4 lights at once, spans of 8192 pixels, n up \
to 8191), and one that a renderer would use (as many lights as the scene, spans as wide as the \
picture, n up to 128). A negative number of adders is the cost of products with constants, which \
replace multipliers. Leaving inputs out changes no pixel; options and formats are exact enough.

Example: specula needs teapot --method phong";

/// Arguments of `needs`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Shading method [default: what the scene says, else auto]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,
    /// Also synthesise the core without each need, with Yosys for an ECP5: takes half a minute or
    /// more
    #[arg(long)]
    synthesis: bool,
    /// Print JSON, with the ranges of every quantity, instead of tables
    #[arg(long)]
    json: bool,
}

/// The JSON object that `needs --json` prints.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    method: &'static str,
    /// How weights go along spans, where the camera is a perspective one.
    #[serde(skip_serializing_if = "Option::is_none")]
    interpolation: Option<Interpolation>,
    needs: &'a Needs,
    savings: &'a Savings,
    keeping: &'a [KeepCost],
    /// A core by another method or with other options that is both smaller and more exact.
    better: Option<&'a Candidate>,
}

/// Prints the needs and what they save.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let scene = arguments.scene.load()?;
    // The user asks what the scene leaves out, even if its file asks for a general core.
    let wanted = CoreArguments {
        method: arguments.method.map(WishedMethod::Named),
        specialise: Some(Specialise::Scene),
        ..CoreArguments::default()
    };
    let spec = wanted.core(&scene)?.spec;
    let (needs, savings) = (scene.needs()?, measured(&scene, &spec, arguments.synthesis)?);
    let products = wanted.made_for.products()?;
    let keeping = keep_costs(&scene, spec.method(), &products)?;
    let better = auto::better_than(&scene, &spec, &products)?;
    let report = Report {
        scene: &scene.name,
        method: spec.method().name(),
        interpolation: scene.frame.interpolation(),
        needs: &needs,
        savings: &savings,
        keeping: &keeping,
        better: better.as_ref(),
    };
    let text = if arguments.json {
        serde_json::to_string_pretty(&report).map_err(ToolError::Json)? + "\n"
    } else {
        let table = [vec![TITLES.map(str::to_owned)], rows(&savings)].concat();
        let cells = if arguments.synthesis {
            format!("\n{}", table::shown(&cells(&savings)))
        } else {
            String::new()
        };
        let keeping = table::shown(&kept(&keeping));
        let better = better.as_ref().map(|Candidate { core, error, cells }| {
            format!("\nsmaller and more exact: {core}, {cells} cells, {error:.2} LSB (`--method auto` chooses)\n")
        });
        let facts = table::shown(&facts(&report));
        let better = better.unwrap_or_default();
        format!("{facts}\n{}{cells}\n{keeping}{better}", table::shown(&table))
    };
    write!(stdout, "{text}").map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}

/// What the needs save, in cells of an ECP5 too if the user asks for them.
fn measured(scene: &LoadedScene, spec: &CoreSpec, synthesis: bool) -> Result<Savings, ToolError> {
    let bar = progress::steps();
    bar.set_message("modules");
    let watch = |progress: Progress| {
        bar.set_length(progress.modules as u64);
        bar.set_position(progress.done as u64);
    };
    let synthesise = |designs: &[&Design]| synthesise(designs, &watch);
    let savings = ablation(scene, spec, synthesis.then_some(&synthesise as Synthesis));
    bar.finish_and_clear();
    Ok(savings?)
}

fn facts(report: &Report) -> Vec<[String; 2]> {
    let needs = report.needs;
    let yes_or_no = |answer: bool| if answer { "yes" } else { "no" }.to_owned();
    let seen = |colour: [f64; 3]| {
        if colour == [0.0; 3] {
            "none".to_owned()
        } else {
            colour.map(|c| format!("{c:.3}")).join(", ")
        }
    };
    let exponents = match (needs.smallest_shininess, needs.largest_shininess) {
        (n, largest) if n == largest => n.to_string(),
        (smallest, largest) => format!("{smallest} to {largest}"),
    };
    let wraps = needs.has_places().then(|| {
        let moved = format!("{:.2} LSB", needs.most_off_by_wraps);
        ("wrapped directions to places may move colours by", moved)
    });
    let rows = [
        ("scene", format!("{}, by {}", report.scene, report.method)),
        ("lights", format!("{}, of which {} at a place", needs.lights, needs.local_lights.len())),
        ("directions to lights and eye are constant", yes_or_no(!needs.has_places())),
        ("longest span", format!("{} pixels", needs.longest_span)),
        ("widest angle between normals of a span", format!("{:.1} degrees", needs.widest_angle)),
        ("materials", needs.materials.to_string()),
        ("exponents", exponents),
        ("all of them powers of two", yes_or_no(needs.uneven_shininess.is_none())),
        ("strongest ambient light sent back", seen(needs.contributions.ambient)),
        ("strongest diffuse light", seen(needs.contributions.diffuse)),
        ("strongest highlights", seen(needs.contributions.specular)),
        ("grey", yes_or_no(needs.contributions.grey)),
        ("one normal over each triangle", yes_or_no(needs.flat)),
        ("consistent normals would differ", yes_or_no(needs.consistent_normals_differ)),
    ];
    let camera = report.interpolation.map(|way| ("camera", way.in_words().to_owned()));
    let weaker = (!needs.attenuated_lights.is_empty()).then(|| {
        ("lights that become weaker with distance", needs.attenuated_lights.len().to_string())
    });
    let rows = rows.into_iter().chain(camera).chain(weaker).chain(wraps);
    rows.map(|(name, value)| [name.to_owned(), value]).collect()
}

/// Titles of [`rows`].
pub const TITLES: [&str; 9] = [
    "need",
    "left out or narrowed",
    "multipliers",
    "bits",
    "adders",
    "bits",
    "registers",
    "clocks",
    "why it is safe",
];

/// Rows of need, what was left out, what it saves in multipliers, their bits, adders, their bits,
/// register bits and clocks, and why it is safe.
pub fn rows(savings: &Savings) -> Vec<[String; 9]> {
    let row = |need: &str, left_out: &str, saves: &SizeDelta, safe: &str| {
        let [multipliers, multiplier_bits, adders, adder_bits, registers, latency] =
            numbers(saves).map(|number| number.to_string());
        let (need, left_out, safe) = (need.to_owned(), left_out.to_owned(), safe.to_owned());
        [need, left_out, multipliers, multiplier_bits, adders, adder_bits, registers, latency, safe]
    };
    let of = |saving: &Saving| row(saving.need, &saving.left_out, &saving.saves, saving.safe);
    let mut rows: Vec<[String; 9]> = savings.needs.iter().map(of).collect();
    let together = savings.together.iter();
    rows.extend(together.map(|general| {
        row(general.baseline.name(), &general.built_for, &general.saves, "every pixel is compared")
    }));
    rows
}

/// A table of what it costs to keep things variable.
fn kept(costs: &[KeepCost]) -> Vec<[String; 7]> {
    let titles = ["keeping", "multipliers", "bits", "adders", "bits", "registers", "clocks"];
    let row = |KeepCost { thing, costs }: &KeepCost| {
        let [a, b, c, d, e, f] = numbers(costs).map(|number| format!("{number:+}"));
        [(*thing).to_owned(), a, b, c, d, e, f]
    };
    [titles.map(str::to_owned)].into_iter().chain(costs.iter().map(row)).collect()
}

/// The numbers of both tables: multipliers, their bits, adders, their bits, register bits and clocks.
fn numbers(delta: &SizeDelta) -> [i64; 6] {
    [
        delta.multipliers,
        delta.multiplier_bits,
        delta.adders,
        delta.adder_bits,
        delta.register_bits,
        delta.latency,
    ]
}

/// A table of saved cells; empty if they were not counted.
fn cells(savings: &Savings) -> Vec<[String; 4]> {
    let titles = ["need", "LUTs", "MULT18X18D", "flip-flops"].map(str::to_owned);
    let row = |(need, saves): (&str, &SizeDelta)| {
        let cells = saves.cells?;
        let numbers =
            [cells.luts, cells.multipliers, cells.flip_flops].map(|number| number.to_string());
        let [luts, multipliers, flip_flops] = numbers;
        Some([need.to_owned(), luts, multipliers, flip_flops])
    };
    let needs = savings.needs.iter().map(|saving| (saving.need, &saving.saves));
    let together = savings.together.iter().map(|general| (general.baseline.name(), &general.saves));
    let rows = needs.chain(together).filter_map(row);
    [titles].into_iter().chain(rows).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use specula_spec::SceneCore;

    #[test]
    fn the_table_fits_into_80_columns() {
        for name in ["teapot", "lamps"] {
            let scene = specula_scene::load(name, Some((1024, 768))).expect("it is built in");
            let spec = scene.core_spec(None).expect("a method serves it").specialised(&scene.frame);
            let savings = measured(&scene, &spec, false).expect("cores can be built");
            let table = [vec![TITLES.map(str::to_owned)], rows(&savings)].concat();
            let text = table::folded(&table, 80);
            assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
        }
    }
}

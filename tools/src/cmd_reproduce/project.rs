//! `specula reproduce project`: the lecture's programming project, with Hast's and Reshetov's
//! schemes beside it.
use std::fmt::Write as _;
use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use specula_experiments::benchmark::Machine;
use specula_experiments::reproduce::project::model::Illumination;
use specula_experiments::reproduce::project::{
    ALGORITHMS, CLAIMS, Model, Outcome, SpeedClaim, Timed, timed,
};
use specula_experiments::tradeoff::software::TimingExtent;
use specula_scene::SceneError;
use specula_scene::mesh::Mesh;

use super::page::Page;
use super::section::written;
use crate::error::ToolError;
use crate::output::Interrupts;
use crate::table;
use crate::verdict::Verdict;

const EXAMPLE: &str = "\
Times the papers' loops in software, on one thread, on three models, with light and eye at infinity and \
at places, and says of each claim about their speed whether it holds here. All loops of a model run in \
turns, so that other work on the machine disturbs all alike; numbers are medians. Writes DIR/project.md.

Example: specula reproduce project --mesh scan.ply -o out/project";

/// Arguments of `reproduce project`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// The third model, a scan (.obj, .ply, .stl, .glb) [default: a built-in stand-in]
    #[arg(long, value_name = "FILE")]
    mesh: Option<PathBuf>,
    /// Number of rounds, 1 to 1000
    #[arg(long, default_value_t = 21, value_parser = clap::value_parser!(u32).range(1..=1000))]
    rounds: u32,
    /// Folder to write into, in addition to printing the text
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Width and height of the pictures.
const SIZE: (u32, u32) = (640, 480);
/// Least number of pixels that a loop shades in a round.
const PIXELS: u64 = 100_000;

/// Times every loop on every model, writes the page and prints it.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let extent = TimingExtent { rounds: arguments.rounds as usize, pixels: PIXELS };
    let mut all = vec![];
    for model in &models(arguments)? {
        for illumination in Illumination::ALL {
            all.push(timed(model, SIZE, illumination, extent)?);
        }
    }
    let page =
        Page { name: NAME, head: HEAD, text: text(&all, arguments.rounds), pictures: vec![] };
    page.give(arguments.output.as_deref(), stdout, interrupts)?;
    Ok(Verdict::Done)
}

fn models(arguments: &Arguments) -> Result<[Model; 3], SceneError> {
    let scan = match &arguments.mesh {
        Some(path) => {
            // Warnings about what is skipped say nothing about speed.
            let (mesh, _) = Mesh::read(path)?;
            let name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
            Model { name: name.unwrap_or_default(), mesh }
        }
        None => Model::stand_in()?,
    };
    Ok([Model::teapot(), Model::torus(), scan])
}

/// Name of the page's file.
const NAME: &str = "project.md";
/// How the page begins.
const HEAD: &str = "\
# How fast the papers' algorithms are in software

Written by `specula reproduce project`: the lecture's programming project 1, with Hast's schemes and consistent normals beside its four
algorithms. Loops are the papers' own, in f32, one thread (`golden/src/loops`).
";

const METHOD: &str = "\
*A pixel* is the inner loop; *a span* is the set-up of one, with its share of what is computed once for a frame; *all* is both, for each pixel.
Ratios are to naive Phong shading of the same rows. One light; at places, the lamp is one and a half radii from the model's middle and the
eye three. Times are medians of interleaved rounds, of the time in which the thread had a processor; within 5 % two loops count as equally fast.
Error is against exact Phong shading with directions from each pixel: at places it is large for loops that take directions from elsewhere, and a loop that is fast and wrong is no faster way
to the same picture.
";

fn text(all: &[Timed], rounds: u32) -> String {
    let machine = Machine::this();
    let mut text = format!(
        "{HEAD}\n{METHOD}\nMeasured on: {}, {rounds} rounds. Made by Specula {}.\n\n## What the papers claim\n\n",
        machine.cpu,
        env!("CARGO_PKG_VERSION")
    );
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}", claims(all));
    for timed in all {
        let _ = writeln!(
            text,
            "## {}, {}\n\n{} visible triangles, {} spans, {} pixels: {} pixels a span.\n\n{}",
            timed.model,
            timed.illumination.name(),
            timed.triangles,
            timed.spans,
            timed.pixels,
            written(((timed.pixels as f64 / timed.spans.max(1) as f64) * 10.0).round() / 10.0),
            rows(timed)
        );
    }
    text.trim_end().to_owned() + "\n"
}

/// The claims: a ratio for each model and illumination, and the verdict over all of them.
fn claims(all: &[Timed]) -> String {
    let heads = all.iter().map(|timed| format!("{}, {}", timed.model, timed.illumination.name()));
    let titles: Vec<String> = ["paper", "claim", "ratio"]
        .map(str::to_owned)
        .into_iter()
        .chain(heads)
        .chain(["verdict".to_owned()])
        .collect();
    let row = |claim: &SpeedClaim| -> Vec<String> {
        let ratios: Vec<Option<f64>> = all.iter().map(claim.ratio).collect();
        let shown = ratios.iter().map(|ratio| ratio.map_or("–".to_owned(), decimals));
        [claim.paper.name(), claim.what, claim.quantity]
            .map(str::to_owned)
            .into_iter()
            .chain(shown)
            .chain([verdict(claim, &ratios)])
            .collect()
    };
    let rows: Vec<Vec<String>> = CLAIMS.iter().map(row).collect();
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let rule = format!("|{}\n", "---|".repeat(titles.len()));
    line(&titles) + &rule + &rows.iter().map(|row| line(row)).collect::<String>()
}

fn verdict(claim: &SpeedClaim, ratios: &[Option<f64>]) -> String {
    let outcomes: Vec<Outcome> = ratios.iter().flatten().copied().map(claim.judge).collect();
    let count = |wanted: Outcome| outcomes.iter().filter(|outcome| **outcome == wanted).count();
    let named = [Outcome::Holds, Outcome::Equal, Outcome::Fails]
        .into_iter()
        .map(|outcome| (outcome, count(outcome)))
        .filter(|(_, count)| *count > 0);
    match named.collect::<Vec<_>>().as_slice() {
        [] => "not timed".to_owned(),
        [(outcome, _)] => outcome.name().to_owned(),
        several => several
            .iter()
            .map(|(outcome, count)| format!("{} in {count}", outcome.name()))
            .collect::<Vec<_>>()
            .join(", "),
    }
}

fn rows(timed: &Timed) -> String {
    let naive = timed.naive();
    let ratio = |part: f64, of: Option<f64>| of.map_or("–".to_owned(), |of| decimals(part / of));
    let rows: Vec<[String; 9]> = timed
        .rows
        .iter()
        .map(|(title, row)| {
            [
                (*title).to_owned(),
                decimals(row.pixel_ns),
                ratio(row.pixel_ns, naive.map(|naive| naive.pixel_ns)),
                decimals(row.set_up_ns),
                ratio(row.set_up_ns, naive.map(|naive| naive.set_up_ns)),
                decimals(row.total_ns),
                decimals(row.ratio_to_phong),
                written(row.error.max_lsb),
                written(row.error.rms_lsb),
            ]
        })
        .collect();
    let table = table::markdown(
        [
            "algorithm",
            "a pixel, ns",
            "ratio",
            "a span, ns",
            "ratio",
            "all, ns a pixel",
            "ratio",
            "largest error, LSB",
            "rms, LSB",
        ],
        &rows,
    );
    match timed.illumination {
        Illumination::Infinity => table,
        Illumination::Places => format!("{table}\n{}\n", seen_from()),
    }
}

/// Where each loop at places takes directions from.
fn seen_from() -> String {
    let named = ALGORITHMS.iter().map(|a| format!("{}: {}", a.title, a.seen_from));
    format!("Directions come from – {}.", named.collect::<Vec<_>>().join("; "))
}

/// A time or a ratio, as exactly as it is worth telling.
fn decimals(number: f64) -> String {
    if number < 100.0 { format!("{number:.2}") } else { format!("{number:.0}") }
}

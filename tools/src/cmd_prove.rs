//! `specula prove`: bounds that another program derives again.
mod json;
mod page;
mod proven;
mod tables;

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use specula_datapath::Builder;
use specula_proof::{gappa, prove};
use specula_sim::Tool;
use specula_spec::{CoreSpec, Method};
use specula_testbench::BenchError;

use crate::arguments::{CoreArguments, PictureArguments, SceneArguments, WishedMethod};
use crate::error::ToolError;
use crate::output::{Destination, Interrupts, MARKDOWN, REPORT};
use crate::verdict::Verdict;
use proven::Proven;

const EXAMPLE: &str = "\
Asks Gappa (Debian's package `gappa`) for every value of every unit what Specula states of it: the \
range, the bound on |fixed - real|, and where the real value lies. Gappa is given the unit's operators \
and formula, what is known of its inputs, and facts by their names; docs/proofs.md says how. Prints \
goals of each method, every bound with the one that Gappa finds by itself, and the facts. With -o \
it writes DIR/report.md, report.json and the scripts, each of which `gappa FILE` proves.

Exit status: 0 if all is proven or stated by a fact that is named, 1 if not, 2 if Gappa cannot be asked.

Example: specula prove teapot --method lyon -o out/proof
Example: specula prove --all-methods";

/// What asks Gappa, and what does without.
const GAPPA: Tool = Tool {
    name: "Gappa",
    command: gappa::COMMAND,
    version_argument: "--version",
    install: "install Gappa, from its own site or by the package `gappa`",
    otherwise: "rely on Specula's own bounds: no other command needs it",
};

/// The scene whose cores are proven by all methods where none is named.
const SCENE: &str = "teapot";

/// Arguments of `prove`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// A built-in scene (see `specula scenes`), a scene file (.toml), or a mesh (.obj, .ply, .stl,
    /// .glb) [with --all-methods: teapot, if none is named]
    #[arg(required_unless_present = "all_methods")]
    scene: Option<String>,
    #[command(flatten)]
    picture: PictureArguments,
    #[command(flatten)]
    wanted: CoreArguments,
    /// Prove the scene's core by each method in turn
    #[arg(long, conflicts_with = "method")]
    all_methods: bool,
    /// Seconds that Gappa may take for a goal
    #[arg(long, value_name = "S", default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..=3600))]
    seconds: u64,
    /// Print report.json instead of tables
    #[arg(long)]
    json: bool,
    /// Folder for the report and the scripts [default: none is written]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Asks Gappa, writes the scripts, and prints what came of it.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    GAPPA.present().map_err(BenchError::from)?;
    let cores = cores(arguments)?;
    let limit = Duration::from_secs(arguments.seconds);
    let of = |spec: &CoreSpec| {
        let graph = specula_hdl::cores::graph(spec, |formula| Builder::new("core", formula));
        let graph = graph.map_err(BenchError::from)?;
        Ok(Proven { method: spec.method(), answers: prove(&graph, limit)? })
    };
    let proven = cores.iter().map(of).collect::<Result<Vec<Proven>, ToolError>>()?;
    let scene = arguments.scene.as_deref().unwrap_or(SCENE);
    if let Some(folder) = &arguments.output {
        write(folder, scene, &proven, interrupts)?;
    }
    let text = if arguments.json {
        json::text(scene, &proven, &[]).map_err(ToolError::Json)?
    } else {
        tables::text(&proven)
    };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    let holds = proven.iter().all(Proven::holds);
    Ok(if holds { Verdict::Done } else { Verdict::Disagrees })
}

/// The cores to prove.
fn cores(arguments: &Arguments) -> Result<Vec<CoreSpec>, ToolError> {
    let scene = SceneArguments {
        scene: arguments.scene.clone().unwrap_or_else(|| SCENE.to_owned()),
        picture: arguments.picture.clone(),
    };
    let scene = scene.load()?;
    let core = |wanted: &CoreArguments| Ok(wanted.core(&scene)?.spec);
    if !arguments.all_methods {
        return Ok(vec![core(&arguments.wanted)?]);
    }
    let by = |&method: &Method| {
        let method = Some(WishedMethod::Named(method));
        core(&CoreArguments { method, ..arguments.wanted.clone() })
    };
    Method::ALL.iter().map(by).collect()
}

fn write(
    folder: &Path,
    scene: &str,
    proven: &[Proven],
    interrupts: &Interrupts,
) -> Result<(), ToolError> {
    let scripts: Vec<(String, String)> = proven.iter().flat_map(Proven::scripts).collect();
    let names = scripts.iter().map(|(name, _)| name.clone());
    let files: Vec<String> =
        [MARKDOWN, REPORT].map(str::to_owned).into_iter().chain(names).collect();
    let destination = Destination::check(folder, &files, interrupts)?;
    let staging = destination.stage()?;
    let put =
        |name: &str, text: &str| fs::write(staging.file(name), text).map_err(staging.failed(name));
    for (name, text) in &scripts {
        put(name, text)?;
    }
    put(MARKDOWN, &page::text(scene, proven))?;
    let report = json::text(scene, proven, &files);
    let report = report.map_err(|error| staging.failed(REPORT)(io::Error::other(error)))?;
    put(REPORT, &report)?;
    Ok(staging.publish()?)
}

//! `specula explore`: the smallest core that shades a scene well enough.
mod tables;

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use serde::Serialize;
use specula_experiments::explore::{Device, Exploration, Explored, Wanted, explore};
use specula_experiments::search::error_of_method;
use specula_scene::Frame;
use specula_spec::{Method, SpecFile};

use crate::arguments::{SceneArguments, method_parser, parse_error, selected_methods};
use crate::clock::Clock;
use crate::error::{NothingExplored, ToolError};
use crate::output::{Interrupts, write_core};
use crate::target_arguments::{CLOCK_HELP, TargetArguments};
use crate::verdict::Verdict;
use crate::{progress, table};

const EXAMPLE: &str = "\
Tries options and formats of each method, every core made for the scene alone. Errors are total: \
the core's codes against exact Phong shading, over every pixel. Cells are bit products of \
multipliers, bits of adders, of registers and of read-only memory, and the clock is assumed. With \
--target or --device every core is made for it: cells are its look-up tables, its flip-flops, and \
for each multiplier block what the device has of look-up tables for each; the clock is the one that \
the target's delays predict, and cores are compared by cells times the time for a frame.

DIR/spec.toml is the smallest core within the error, for `run --core` and `generate --spec`.

Example: specula explore teapot --max-error 2lsb --device ecp5-25 -o out/explored";

/// Arguments of `explore`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE, mut_arg("clock", |clock| clock.help(CLOCK_HELP)))]
pub struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Folder to write [default: out/NAME-explored, by the scene's name]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Largest total error against exact shading, measured on every pixel of this scene, that the
    /// best core may have, such as 2lsb
    #[arg(long, value_name = "LSB", allow_hyphen_values = true, value_parser = parse_error)]
    max_error: f64,
    /// Methods to try, separated by commas [default: all]
    #[arg(long, value_name = "METHODS", value_delimiter = ',', value_parser = method_parser())]
    methods: Vec<Method>,
    #[command(flatten)]
    made_for: TargetArguments,
    /// Print JSON, with every core of the front, instead of a table
    #[arg(long)]
    json: bool,
}

/// The JSON object that `explore --json` prints.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a str,
    max_error: f64,
    device: Option<&'a Device>,
    #[serde(flatten)]
    exploration: &'a Exploration,
}

/// Searches, writes the best core, and prints the front.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let scene = arguments.scene.load_frame()?;
    let methods = selected_methods(&arguments.methods);
    let made_for = &arguments.made_for;
    let (device, target) = (made_for.device.as_ref(), made_for.wanted()?);
    let most = arguments.max_error;
    let wanted = Wanted { most, methods: &methods, device: device.cloned(), target };
    let bar = progress::count("cores tried");
    let exploration = explore(&scene.frame, &wanted, &|| bar.inc(1));
    bar.finish_and_clear();
    let exploration = exploration?;
    let best = exploration
        .best
        .map(|index| &exploration.front[index])
        .ok_or_else(|| nothing(&wanted, &exploration, &scene.frame))?;
    let file = SpecFile { name: scene.name.clone(), spec: best.spec.clone() };
    // This is not `run`'s folder, into which no other core's spec may be put.
    let folder = arguments
        .output
        .clone()
        .unwrap_or_else(|| Path::new("out").join(format!("{}-explored", scene.name)));
    let written = write_core(&folder, &[(SpecFile::NAME.to_owned(), file.text())], interrupts)?;
    let text = if arguments.json {
        let (scene, max_error) = (scene.name.as_str(), arguments.max_error);
        let report = Report { scene, max_error, device, exploration: &exploration };
        serde_json::to_string_pretty(&report).map_err(ToolError::Json)? + "\n"
    } else {
        let paths: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
        format!("{}\n{}\n", described(&exploration, arguments), paths.join("\n"))
    };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(verdict(&exploration))
}

/// The verdict; cores with an error above their bound are reported on standard error.
fn verdict(exploration: &Exploration) -> Verdict {
    let mut verdict = Verdict::Done;
    let mut stderr = io::stderr().lock();
    for (core, [error, bound]) in
        exploration.front.iter().filter_map(|core| Some((core, core.beyond_bound()?)))
    {
        verdict = Verdict::Disagrees;
        let name = &core.core;
        // The exit status says the same, so a closed standard error is no reason to stop.
        let _ = writeln!(
            stderr,
            "disagreement: {name}: a quantisation error of {error:.3} LSB, above the proven bound of {bound:.3}: the set-up or the bound is wrong"
        );
    }
    verdict
}

/// The error that says why there is no best core.
fn nothing(wanted: &Wanted, exploration: &Exploration, frame: &Frame) -> ToolError {
    ToolError::NothingExplored(NothingExplored {
        wanted: wanted.most,
        nearest: match exploration.front.last() {
            Some(Explored { error, core, spec, .. }) if *error > wanted.most => {
                let own = error_of_method(spec, frame);
                format!(
                    "the nearest comes to {error:.2} LSB: {core}, whose method is off by {own:.2} LSB in exact arithmetic"
                )
            }
            Some(_) => "those that come as near do not fit the device, or do not reach the clock"
                .to_owned(),
            None => exploration.refused.join("; "),
        },
    })
}

/// The front as a table, and a summary of what was tried.
fn described(exploration: &Exploration, arguments: &Arguments) -> String {
    let given = arguments.made_for.given_for_any_device();
    let on_target = exploration.front.iter().any(|core| core.on_target.is_some());
    let (front, order, clock) = if on_target {
        let order = "cells times time";
        (tables::on_target(exploration), order, "the predicted clock of each".to_owned())
    } else {
        let clock = Clock::of(None, given);
        (tables::for_any_device(exploration, clock), "size", clock.in_words())
    };
    let refused: String =
        exploration.refused.iter().map(|reason| format!("left out: {reason}\n")).collect();
    let words = format!(
        "{} cores were tried, of which these {} are neither beaten in {order} nor in error; frames/s, set-up counted, at {clock}\n{refused}",
        exploration.tried,
        exploration.front.len(),
    );
    format!("{front}\n{}", table::paragraphs(&words))
}

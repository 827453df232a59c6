//! `specula schedule`: a core clock by clock.
mod contents;
mod picture;
mod text;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use specula_testbench::BenchError;

use crate::arguments::NameArguments;
use crate::error::ToolError;
use crate::job::SceneOrSpec;
use crate::output::{Interrupts, write_file};
use crate::verdict::Verdict;
use contents::{Contents, Core};

const EXAMPLE: &str = "\
Clock by clock: the operators on the longest path that ends in the clock, counts of the others, and \
the register bits that are carried into the next clock: inside multiplier blocks, in flip-flops, in \
memories. With --target also the nanoseconds of that path, as the target's delays predict them, and \
what they leave of the period. docs/schedule.md says how the schedule is found.

Example: specula schedule torus --target ecp5 --clock 200 -o torus.svg";

/// Arguments of `schedule`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    #[command(flatten)]
    core: SceneOrSpec,
    /// Print every operator of each clock, and every signal of its longest path
    #[arg(long, conflicts_with = "json")]
    all: bool,
    /// Print everything as JSON
    #[arg(long)]
    json: bool,
    /// Write a picture (.svg): a row for each clock, its longest path and its register bits as bars
    #[arg(short, long, value_name = "FILE", value_parser = parse_picture)]
    output: Option<PathBuf>,
}

/// Prints the schedule, and writes its picture.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let (file, _) = arguments.core.file(&NameArguments::default())?;
    let module = specula_hdl::module_name(&file.name, &file.spec);
    let design = specula_hdl::elaborate(&file.spec, &module).map_err(BenchError::from)?;
    arguments.core.made_for().fitted(&file.spec, &design)?;
    let limit = specula_hdl::clock_limit(&file.spec, &module).map_err(BenchError::from)?;
    let core = Core { name: &file.name, spec: &file.spec, design: &design, limit };
    let contents = Contents::of(&core);
    if let Some(path) = &arguments.output {
        let svg = specula_drawing::svg(&picture::sheet(&contents));
        write_file(path, interrupts, |path| fs::write(path, svg))?;
    }
    let text = match (arguments.json, arguments.all) {
        (true, _) => serde_json::to_string_pretty(&contents).map_err(ToolError::Json)? + "\n",
        (false, true) => text::complete(&contents),
        (false, false) => text::overview(&contents),
    };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}

/// Parses `-o`.
fn parse_picture(text: &str) -> Result<PathBuf, String> {
    let path = Path::new(text);
    let drawn = path.extension().filter(|ending| ending.eq_ignore_ascii_case("svg"));
    drawn.map(|_| path.to_owned()).ok_or("write the name of a picture that ends in .svg".to_owned())
}

//! `specula reproduce figure9`: Lyon's figure 9, each row shaded by the core that has its formula
//! [Lyon, TR 43].
mod names;
mod picture;
mod report;
mod shaded;

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use specula_experiments::figure9::{self, Balls, FigureRow, ROWS};
use specula_scene::Frame;
use specula_spec::CoreError;
use specula_testbench::{Bench, EngineKind, Image};

use crate::arguments::{engine_parser, parse_size};
use crate::disagreement::Disagreement;
use crate::error::ToolError;
use crate::output::{Destination, Interrupts, MARKDOWN, REPORT};
use crate::run::{DEFAULT_ENGINE, simulate};
use crate::verdict::Verdict;
use crate::verilog::Origin;
use crate::{picture as png, verilog};
use names::{FORMULAS, NAME, SIMULATED, module};
use shaded::{Line, Shaded};

const EXAMPLE: &str = "\
Shades Lyon's figure 9, a core for each of its twelve rows, and compares every pixel with the \
bit-true model and with the formula in f64. Writes DIR/figure9.png, formulas.png (the same in f64), \
the cores, report.md and report.json.

Exit status: 0 if every pixel agrees and no quantisation error is above its proven bound, 1 if not.

Example: specula reproduce figure9 --size 385x129 -o out/figure9";

/// Arguments of `reproduce figure9`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// Folder to write [default: out/figure9]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Width and height in pixels into which a row of balls has to fit, at least 7x3 [default:
    /// 385x129, the report's]
    #[arg(long = "size", value_name = "WxH", allow_hyphen_values = true, value_parser = parse_balls)]
    balls: Option<Balls>,
    /// Engine that simulates the cores
    #[arg(long, default_value = DEFAULT_ENGINE.name(), value_parser = engine_parser())]
    engine: EngineKind,
    /// Print report.json instead of the table
    #[arg(long)]
    json: bool,
}

/// The size of the balls in the report.
const BALLS: Balls = Balls { radius: 64 };

/// Parses `--size`: the result is the largest balls of which a row fits.
fn parse_balls(text: &str) -> Result<Balls, String> {
    let (width, height) = parse_size(text)?;
    Balls::within(width, height)
        .ok_or_else(|| "five balls in a row take 7x3 pixels at least".to_owned())
}

/// Shades every row, writes all files, and prints the table or the report.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let balls = arguments.balls.unwrap_or(BALLS);
    let folder = arguments.output.clone().unwrap_or_else(|| PathBuf::from("out").join(NAME));
    let destination = Destination::check(&folder, &files(), interrupts)?;
    let frame = figure9::frame(balls);
    let numbered = ROWS.iter().zip(1..);
    let rows: Vec<Shaded> = numbered
        .map(|(row, number)| shaded(arguments, (row, number), balls, &frame))
        .collect::<Result<_, _>>()?;
    let json = write(&destination, arguments, balls, &rows)?;
    let text =
        if arguments.json { json } else { report::summary(&rows, &files(), &destination.shown) };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(verdict(&rows))
}

fn shaded(
    arguments: &Arguments,
    (row, number): (&FigureRow, usize),
    balls: Balls,
    frame: &Frame,
) -> Result<Shaded, ToolError> {
    let spec = row.core(frame).map_err(CoreError::Spec)?;
    let module = module(number);
    let bench = Bench::new(frame, &spec, &module)?;
    let outcome = simulate(&bench, arguments.engine)?;
    let error = figure9::errors(row, balls, &outcome.simulated);
    let origin = Origin {
        scene: format!("{NAME}, row {number}: {}", row.title),
        command: format!("specula reproduce {NAME}"),
    };
    Ok(Shaded {
        line: Line::new((row, number), &bench, &outcome, error),
        verilog: verilog::text(&origin, &spec, &bench.design),
        disagreement: Disagreement::of(&outcome, &bench, None),
        simulated: outcome.simulated,
    })
}

/// Every file that is written.
fn files() -> Vec<String> {
    let cores = (1..=ROWS.len()).map(|number| verilog::file_name(&module(number)));
    [SIMULATED, FORMULAS, MARKDOWN, REPORT].map(str::to_owned).into_iter().chain(cores).collect()
}

/// Writes all files and returns the JSON report.
fn write(
    destination: &Destination,
    arguments: &Arguments,
    balls: Balls,
    rows: &[Shaded],
) -> Result<String, ToolError> {
    let staging = destination.stage()?;
    let exact = figure9::exact(balls);
    let simulated: Vec<Image> = rows.iter().map(|row| row.simulated.clone()).collect();
    let figures = [
        (SIMULATED, figure9::simulated(balls, &simulated)),
        (FORMULAS, figure9::rounded(balls, &exact)),
    ];
    for (name, figure) in figures {
        let drawing = picture::labelled(balls, &figure);
        png::write_line_drawing(&staging.file(name), &drawing).map_err(staging.failed(name))?;
    }
    let json = report::json(rows, balls, arguments.engine, &files());
    let json = json.map_err(|error| staging.failed(REPORT)(io::Error::other(error)))?;
    let cores = rows.iter().map(|row| (row.line.verilog.as_str(), row.verilog.as_str()));
    let markdown = report::markdown(rows, balls, &exact);
    for (name, text) in cores.chain([(MARKDOWN, markdown.as_str()), (REPORT, json.as_str())]) {
        fs::write(staging.file(name), text).map_err(staging.failed(name))?;
    }
    staging.publish()?;
    Ok(json)
}

/// The verdict; disagreements are reported on standard error.
fn verdict(rows: &[Shaded]) -> Verdict {
    let mut verdict = Verdict::Done;
    let mut stderr = io::stderr().lock();
    for (row, disagreement) in rows.iter().filter_map(|row| Some((row, row.disagreement.as_ref()?)))
    {
        verdict = Verdict::Disagrees;
        for line in disagreement.lines() {
            // The report and the exit status say the same, so a closed standard error is no reason
            // to stop.
            let _ = writeln!(stderr, "disagreement: row {}: {line}", row.line.row);
        }
    }
    verdict
}

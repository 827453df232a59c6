//! `specula run figure9`: Lyon's figure 9, each row shaded by the core that has its formula [Lyon,
//! TR 43].
mod picture;
mod report;

use std::fs;
use std::io::{self, Write};

use specula_experiments::figure9::{self, Balls, ROWS, Row};
use specula_scene::{Frame, SceneError};
use specula_testbench::trace::Choice;
use specula_testbench::{Bench, Image};

use super::{Arguments, MARKDOWN, simulate};
use crate::cli::Verdict;
use crate::disagreement::Disagreement;
use crate::error::ToolError;
use crate::header::Origin;
use crate::output::{Destination, Interrupts, REPORT};
use crate::{picture as png, verilog};
use report::Line;

/// What stands in a scene's place on the command line.
pub const NAME: &str = "figure9";
/// The radius of the report's balls, in pixels.
const RADIUS: u32 = 64;
const SIMULATED: &str = "figure9.png";
const FORMULAS: &str = "formulas.png";

/// A row that has been simulated and compared.
struct Shaded {
    line: Line,
    verilog: String,
    simulated: Image,
    disagreement: Option<Disagreement>,
}

/// Shades every row, writes everything, and prints the table or the report.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let balls = balls(arguments)?;
    let folder = arguments.output.folder(NAME);
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

/// As large as asked for, if nothing is asked for that a set of cores does not have.
fn balls(arguments: &Arguments) -> Result<Balls, ToolError> {
    let Arguments { scene, name, core, wishes, device, clock, trace, .. } = arguments;
    let asked = [
        ("--name", name.name.is_some()),
        ("--core", core.is_some()),
        ("--method", wishes.method.is_some()),
        ("--specialise", wishes.specialise.is_some()),
        ("--max-error", wishes.max_error.is_some()),
        ("--device", device.device.is_some()),
        ("--clock", clock.is_given()),
        ("--trace", !matches!(trace, Choice::Worst | Choice::None)),
    ];
    if let Some((option, _)) = asked.into_iter().find(|(_, given)| *given) {
        return Err(ToolError::Figure9 { wrong: format!("{option} is for one core") });
    }
    let Some((width, height)) = scene.picture.size else { return Ok(Balls { radius: RADIUS }) };
    match Balls::within(width, height) {
        Some(balls) => Ok(balls),
        None => Err(ToolError::Figure9 {
            wrong: format!("its balls have no room in {width}x{height} pixels"),
        }),
    }
}

fn shaded(
    arguments: &Arguments,
    (row, number): (&Row, usize),
    balls: Balls,
    frame: &Frame,
) -> Result<Shaded, ToolError> {
    let spec = row.core(frame).map_err(SceneError::Spec)?;
    let module = module(number);
    let bench = Bench::new(frame, &spec, &module)?;
    let outcome = simulate(&bench, arguments.engine)?;
    let error = figure9::errors(row, balls, &outcome.simulated);
    let origin = Origin {
        scene: format!("{NAME}, row {number}: {}", row.title),
        command: format!("specula run {NAME}"),
    };
    Ok(Shaded {
        line: Line::new((row, number), &bench, &outcome, error),
        verilog: verilog::text(&origin, &spec, &bench.design),
        disagreement: Disagreement::of(&outcome, &bench),
        simulated: outcome.simulated,
    })
}

fn module(number: usize) -> String {
    format!("{NAME}_row{number:02}")
}

/// Every file that is written.
fn files() -> Vec<String> {
    let cores = (1..=ROWS.len()).map(|number| verilog::file_name(&module(number)));
    [SIMULATED, FORMULAS, MARKDOWN, REPORT].map(str::to_owned).into_iter().chain(cores).collect()
}

/// Writes everything, and gives the JSON report.
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

/// The verdict; what disagrees is said to whoever watches.
fn verdict(rows: &[Shaded]) -> Verdict {
    let mut verdict = Verdict::Done;
    let mut stderr = io::stderr().lock();
    for (row, disagreement) in rows.iter().filter_map(|row| Some((row, row.disagreement.as_ref()?)))
    {
        verdict = Verdict::Disagrees;
        for line in disagreement.lines() {
            // The report says the same, and the exit status tells.
            let _ = writeln!(stderr, "disagreement: row {}: {line}", row.line.row);
        }
    }
    verdict
}

//! `specula stress`: the catalogue of extremes, and the search for broken bounds.
mod climb;
mod files;
mod json;
mod plots;
mod results;
mod scene_files;
mod table;

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use specula_experiments::climb::Search;
use specula_experiments::stress::{CATALOGUE, Cell, RAW, RAW_INPUT, TrialExtent, sweep};
use specula_spec::Method;

use crate::arguments::method_parser;
use crate::error::ToolError;
use crate::output::{Destination, Interrupts};
use crate::progress;
use crate::verdict::Verdict;
use results::{RowResult, Stress};

const EXAMPLE: &str = "\
Tries each row of the catalogue of extremes, and random spans between its ends, with exact shading, \
the bit-true model and the simulated core of every method with each of its options. Reports for each \
method in each row the requirements and the results: the method holds, is at a documented limit \
(with the figure), or is at fault. Writes DIR/report.md, report.json, plots of the drift of \
recurrences with the length of a span, and for each row and method the scene file of the worst span, \
for `run`.

With --climb it searches for broken bounds instead: scenes of spans with cores of any options and \
formats are changed in small steps towards the largest ratio of the measured quantisation error to \
the proven bound. Writes DIR/report.json, for each method the scene file with the largest ratio, and \
minimised ones that break a bound, all for `run`. A bound of 255 LSB or more counts as none.

Exit status: 0 if nothing is at fault and no bound is broken, 1 if not, 2 if it could not be tried.

Example: specula stress --method slerp --seed 7
Example: specula stress --climb --scenes 100000 --seed 7";

/// Default number of scenes that a search tries.
const SCENES: u64 = 20_000;

/// Arguments of `stress`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// Try only this method
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,
    /// Seed of the random numbers; the same seed gives the same spans
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Number of random spans in each row
    #[arg(long, value_name = "N", default_value_t = TrialExtent::WHOLE.spans as u32, value_parser = clap::value_parser!(u32).range(1..=4096), conflicts_with = "climb")]
    spans: u32,
    /// Search for broken bounds instead of trying the catalogue
    #[arg(long)]
    climb: bool,
    /// Number of scenes that the search tries, divided among the methods
    #[arg(long, value_name = "N", default_value_t = SCENES, value_parser = clap::value_parser!(u64).range(1..=1_000_000_000), requires = "climb")]
    scenes: u64,
    /// Print report.json instead of the table
    #[arg(long)]
    json: bool,
    /// Folder to write [default: out/stress, or out/climb with --climb]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

impl Arguments {
    fn methods(&self) -> Vec<Method> {
        self.method.map_or(Method::ALL.into(), |method| vec![method])
    }

    fn destination(
        &self,
        by_default: &str,
        files: &[String],
        interrupts: &Interrupts,
    ) -> Result<Destination, ToolError> {
        let folder = self.output.as_deref().unwrap_or(Path::new(by_default));
        Ok(Destination::check(folder, files, interrupts)?)
    }
}

/// Tries the catalogue or searches for broken bounds, writes all files, and prints the table or the
/// report.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    if arguments.climb {
        search(arguments, stdout, interrupts)
    } else {
        try_catalogue(arguments, stdout, interrupts)
    }
}

fn search(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let methods = arguments.methods();
    let destination =
        arguments.destination("out/climb", &climb::possible_names(&methods), interrupts)?;
    let search = Search { seed: arguments.seed, scenes: arguments.scenes, methods };
    climb::execute(&search, &destination, arguments.json, stdout)
}

fn try_catalogue(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let methods = arguments.methods();
    let destination =
        arguments.destination("out/stress", &files::possible_names(&methods), interrupts)?;
    let extent = TrialExtent { spans: arguments.spans as usize, ..TrialExtent::WHOLE };
    let bar = progress::steps();
    let cells = sweep(arguments.seed, &methods, extent, &|done, all| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
    });
    bar.finish_and_clear();
    let stress = Stress { seed: arguments.seed, spans: arguments.spans, rows: rows(cells) };
    let report = files::write(&destination, &stress)?;
    let text = if arguments.json { report } else { table::text(&stress, &destination.shown) };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(if stress.rows.iter().any(RowResult::has_fault) {
        Verdict::Disagrees
    } else {
        Verdict::Done
    })
}

/// Groups cells by the rows that they belong to.
fn rows(cells: Vec<Cell>) -> Vec<RowResult> {
    let of_catalogue = CATALOGUE.iter().map(|row| (row.id, row.input));
    let row = |(id, input)| {
        let cells = cells.iter().filter(|cell| cell.row == id).cloned().collect();
        RowResult { id, input, cells }
    };
    of_catalogue.chain([(RAW, RAW_INPUT)]).map(row).collect()
}

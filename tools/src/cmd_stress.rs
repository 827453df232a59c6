//! `specula stress`: the catalogue of extremes.
mod files;
mod json;
mod plots;
mod table;

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use specula_scene::Method;
use specula_testbench::stress::{CATALOGUE, Cell, Extent, RAW, RAW_INPUT, Verdict as StressVerdict, sweep};

use crate::arguments::method_parser;
use crate::cli::Verdict;
use crate::error::ToolError;
use crate::output::Destination;
use crate::progress;

const EXAMPLE: &str = "\
Puts each row of the catalogue of extremes, and random spans between its ends, through exact
shading, the bit-true model and the simulated core of every method with each of its options.
Says of each method in each row what is asked and what came: it holds, is at a documented limit of
the method (with the figure), or is at fault. Writes DIR/report.md, report.json, plots of how
recurrences drift with the length of a span, and for each row and method the scene file of the
worst span, which `run` takes.

Exit status: 0 if nothing is at fault, 1 if anything is, 2 if it could not be tried.

Example: specula stress --method slerp --seed 7";

/// Arguments of `stress`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// Try this method alone
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,
    /// Of the random numbers; the same seed gives the same spans
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Random spans of each row
    #[arg(long, value_name = "N", default_value_t = Extent::WHOLE.spans as u32, value_parser = clap::value_parser!(u32).range(1..=4096))]
    spans: u32,
    /// Print report.json instead of the table
    #[arg(long)]
    json: bool,
    /// Folder to write
    #[arg(short, long, value_name = "DIR", default_value = "out/stress")]
    output: PathBuf,
}

/// The catalogue, tried.
struct Stress {
    seed: u64,
    spans: u32,
    rows: Vec<RowResult>,
}

/// A row, tried on each method.
struct RowResult {
    id: &'static str,
    input: &'static str,
    cells: Vec<Cell>,
}

impl RowResult {
    /// The worst that any method comes to; nothing where none has a core.
    fn verdict(&self) -> Option<StressVerdict> {
        self.cells.iter().filter_map(Cell::verdict).max()
    }

    fn has_fault(&self) -> bool {
        self.verdict() == Some(StressVerdict::Fault)
    }
}

/// Tries the catalogue, writes everything, and prints the table or the report.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let methods: Vec<Method> = arguments.method.map_or(Method::ALL.into(), |method| vec![method]);
    let destination = Destination::check(&arguments.output, &files::possible_names(&methods))?;
    let extent = Extent { spans: arguments.spans as usize, ..Extent::WHOLE };
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
    Ok(if stress.rows.iter().any(RowResult::has_fault) { Verdict::Disagrees } else { Verdict::Done })
}

/// Cells in the rows that they belong to.
fn rows(cells: Vec<Cell>) -> Vec<RowResult> {
    let of_catalogue = CATALOGUE.iter().map(|row| (row.id, row.input));
    let row = |(id, input)| {
        let cells = cells.iter().filter(|cell| cell.row == id).cloned().collect();
        RowResult { id, input, cells }
    };
    of_catalogue.chain([(RAW, RAW_INPUT)]).map(row).collect()
}

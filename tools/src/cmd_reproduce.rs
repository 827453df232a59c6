//! `specula reproduce`: what the papers claim, computed.
use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use specula_testbench::reproduce::{Paper, Verdict as Judged};

use crate::cli::Verdict;
use crate::error::ToolError;
use crate::output::write_file;
use crate::table;

const EXAMPLE: &str = "\
Computes what the papers claim with this program's own exact shading, compares it with the project's
independent measurements, and says of each claim whether it holds.

Exit status: 0 if every number is as measured before, 1 if not.

Example: specula reproduce lyon -o out/reproduce";

/// Arguments of `reproduce`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// The paper [default: all of them]
    #[arg(value_parser = paper_parser())]
    paper: Option<Paper>,
    /// Folder to write reproduction.md into, beside printing it
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

fn paper_parser() -> impl TypedValueParser<Value = Paper> {
    PossibleValuesParser::new(Paper::ALL.map(Paper::name))
        .try_map(|name| Paper::ALL.into_iter().find(|paper| paper.name() == name).ok_or("there is no such paper"))
}

/// Computes and prints.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let papers: Vec<Paper> = arguments.paper.map_or(Paper::ALL.into(), |paper| vec![paper]);
    let judged: Vec<Judged> = papers.into_iter().flat_map(Paper::verdicts).collect();
    let text = markdown(&judged);
    if let Some(folder) = &arguments.output {
        write_file(&folder.join("reproduction.md"), |path| std::fs::write(path, &text))?;
    }
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(if judged.iter().all(|judged| judged.as_expected) { Verdict::Done } else { Verdict::Disagrees })
}

fn markdown(judged: &[Judged]) -> String {
    let titles = ["paper", "claim", "measured quantity", "measured", "before", "verdict"];
    let rows: Vec<[String; 6]> = judged.iter().map(row).collect();
    let head = "# What the papers claim\n\nWritten by `specula reproduce`. *Before* is the project's independent measurement (NUMERICS.md).\n\n";
    format!("{head}{}", table::markdown(titles, &rows))
}

fn row(judged: &Judged) -> [String; 6] {
    let before = if judged.as_expected { format!("{}", judged.expected) } else { format!("{}: DIFFERS", judged.expected) };
    [
        judged.paper.name().to_owned(),
        judged.claim.to_owned(),
        judged.quantity.to_owned(),
        // What rounding leaves of 0 differs from machine to machine.
        if judged.measured.abs() < 1e-9 { "0".to_owned() } else { format!("{:.7}", judged.measured) },
        before,
        (if judged.holds { "holds" } else { "does not hold" }).to_owned(),
    ]
}

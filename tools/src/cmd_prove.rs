//! `specula prove`: bounds that another program derives again.
mod answer;
mod gappa;

use std::io::Write;
use std::time::Duration;

use clap::Args;
use rayon::prelude::*;
use specula_datapath::Builder;
use specula_datapath::proof::{Detail, questions};
use specula_testbench::BenchError;

use crate::arguments::{CoreArguments, SceneArguments};
use crate::error::ToolError;
use crate::output::Interrupts;
use crate::verdict::Verdict;

/// Arguments of `prove`.
#[derive(Clone, Debug, Args)]
pub struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    wanted: CoreArguments,
    /// Seconds that Gappa may take for a goal
    #[arg(long, value_name = "S", default_value_t = 5)]
    seconds: u64,
}

pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    _interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    gappa::GAPPA.present().map_err(BenchError::from)?;
    let scene = arguments.scene.load()?;
    let spec = arguments.wanted.core(&scene)?.spec;
    let graph = specula_hdl::cores::graph(&spec, |formula| Builder::new("core", formula))
        .map_err(BenchError::from)?;
    let coarse = questions(&graph, Detail::Unit);
    let fine = questions(&graph, Detail::Narrowings);
    let limit = Duration::from_secs(arguments.seconds);
    let answers: Result<Vec<_>, ToolError> = coarse
        .par_iter()
        .zip(&fine)
        .map(|(question, finer)| answer::answered(question, finer, limit))
        .collect();
    for (question, answer) in coarse.iter().zip(answers?) {
        for outcome in answer.outcomes {
            writeln!(
                stdout,
                "{} {} {:?} {:?} {:?} {:?} {:?}",
                question.path, question.signal, outcome.about, outcome.standing, outcome.stated, outcome.found, outcome.premises
            )
            .map_err(ToolError::Print)?;
        }
    }
    Ok(Verdict::Done)
}

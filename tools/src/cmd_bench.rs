//! `specula bench`: how fast each simulator runs a core.
mod json;
mod measured;
mod table;

use std::io::Write;

use clap::Args;
use specula_experiments::benchmark::{Budget, Measurement, Step, measure};
use specula_spec::{Method, Specialise, UnnamedFormats};
use specula_testbench::Bench;

use crate::arguments::{CoreArguments, WishedMethod, method_parser, parse_size, specialise_parser};
use crate::error::ToolError;
use crate::progress;
use crate::verdict::Verdict;
use measured::Measured;

const EXAMPLE: &str = "\
Shades the scene's spans, over and over, in each simulator that is installed: this program's own, \
rust-hdl's, Verilator, and Icarus Verilog. The mode says what is recorded of every clock: the \
outputs, every signal, or a waveform of every signal, written to a file (vcd, fst) or discarded \
(vcd-null). Rounds are interleaved, figures are their medians, and the pixels of every run are checked.

With five rounds it takes one to two minutes, half of them for Verilator's builds. Close other \
programs first.

Example: specula bench torus --method hybrid --json";

/// Arguments of `bench`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// A built-in scene (see `specula scenes`), a scene file (.toml), or a mesh (.obj, .ply, .stl,
    /// .glb)
    #[arg(default_value = "teapot")]
    scene: String,
    /// Width and height of the picture in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, default_value = "640x480", value_parser = parse_size)]
    size: (u32, u32),
    /// Shading method [default: what the scene says, else auto]
    #[arg(long, value_parser = method_parser())]
    method: Option<Method>,
    /// Make the core for this scene alone, as `run` does, or the general one, which takes every
    /// input
    #[arg(long, value_name = "FOR", default_value = "general", value_parser = specialise_parser())]
    specialise: Specialise,
    /// Number of rounds whose median is reported
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    rounds: u32,
    /// Duration of each run in seconds, from 0.001 to 100
    #[arg(long, value_name = "S", allow_hyphen_values = true, default_value = "0.25", value_parser = parse_seconds)]
    seconds: f64,
    /// Print JSON instead of a table
    #[arg(long)]
    json: bool,
}

/// Measures all engines and prints the result.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let scene = crate::scene::load(&arguments.scene, Some(arguments.size))?;
    let wanted = CoreArguments {
        method: arguments.method.map(WishedMethod::Named),
        specialise: Some(arguments.specialise),
        formats: Some(UnnamedFormats::Recommended),
        ..CoreArguments::default()
    };
    let spec = wanted.core(&scene)?.spec;
    let bench = Bench::new(&scene.frame, &spec, &specula_hdl::module_name(&scene.name, &spec))?;
    let budget = Budget { rounds: arguments.rounds as usize, seconds: arguments.seconds };
    let measurement = measured(&bench, budget)?;
    let measured = Measured { scene: &scene.name, bench: &bench, budget, measurement };
    let text = if arguments.json {
        json::text(&measured).map_err(ToolError::Json)?
    } else {
        table::text(&measured)
    };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}

fn measured(bench: &Bench, budget: Budget) -> Result<Measurement, ToolError> {
    let bar = progress::steps();
    let measurement = measure(bench, budget, &mut |step| {
        if let Step::Measuring { done, all, .. } = *step {
            bar.set_length(all as u64);
            bar.set_position(done as u64);
        }
        bar.set_message(described(step));
    });
    bar.finish_and_clear();
    Ok(measurement?)
}

fn described(step: &Step) -> String {
    match step {
        Step::Building { engine, mode } => {
            format!("building {} for {}", engine.program(), mode.name())
        }
        Step::Trying { config } => format!("trying {}", config.describe()),
        Step::Measuring { config, .. } => format!("measuring {}", config.describe()),
    }
}

/// Parses `--seconds`.
fn parse_seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse::<f64>().ok().filter(|seconds| (0.001..=100.0).contains(seconds));
    seconds.ok_or_else(|| "write a number from 0.001 to 100, as in 0.25".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seconds_are_read_or_refused() {
        assert_eq!(parse_seconds("0.25"), Ok(0.25));
        for text in ["", "x", "0", "-1", "1e9", "inf", "NaN"] {
            assert!(parse_seconds(text).is_err(), "{text}");
        }
    }
}

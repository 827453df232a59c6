//! Measures the delays of a target with Yosys and nextpnr, and prints them as TOML:
//!
//!     cargo run --release -p specula-flow --example measure_target -- ecp5 [--seeds N] [--check]
//!
//! `docs/targets.md` says what is measured, and what becomes of it.
use std::process::ExitCode;

use specula_flow::measure::{self, Family};
use specula_flow::synth::{SynthError, SynthTarget};

/// Seeds of the placer unless said otherwise.
const SEEDS: u32 = 3;

/// What the command line asks for.
struct Asked {
    target: &'static (SynthTarget, Family),
    seeds: u32,
    /// Whether to measure circuits that no figure comes from, too.
    check: bool,
}

fn main() -> ExitCode {
    let Some(asked) = asked(std::env::args().skip(1)) else {
        let names: Vec<&str> = measure::TARGETS.iter().map(|(target, _)| target.name).collect();
        eprintln!("usage: measure_target {} [--seeds N] [--check]", names.join("|"));
        return ExitCode::from(2);
    };
    match measured(&asked) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{:?}", miette::Report::new(error));
            ExitCode::FAILURE
        }
    }
}

fn measured(asked: &Asked) -> Result<(), SynthError> {
    let watch = |name: &str, nanoseconds: f64| eprintln!("{nanoseconds:7.2} ns  {name}");
    let delays = measure::measure(asked.target, asked.seeds, &watch)?;
    print!("{}", measure::text(&delays));
    if asked.check {
        eprintln!("circuits that no figure comes from:");
        for check in measure::check(asked.target, asked.seeds, &delays)? {
            let measure::Check { name, predicted, measured } = check;
            eprintln!("{measured:7.2} ns, {predicted:7.2} ns by the model  {name}");
        }
    }
    Ok(())
}

fn asked(mut arguments: impl Iterator<Item = String>) -> Option<Asked> {
    let name = arguments.next()?;
    let target = measure::TARGETS.iter().find(|(target, _)| target.name == name)?;
    let mut asked = Asked { target, seeds: SEEDS, check: false };
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--check" => asked.check = true,
            "--seeds" => asked.seeds = arguments.next()?.parse().ok().filter(|&seeds| seeds > 0)?,
            _ => return None,
        }
    }
    Some(asked)
}

//! Measures the delays of a target with Yosys and nextpnr, and prints them as TOML:
//!
//!     cargo run --release -p specula-flow --example measure_target -- ecp5 [--seeds N]
//!
//! `docs/targets.md` says what is measured, and what becomes of it.
use std::process::ExitCode;

use specula_flow::measure;

/// Seeds of the placer unless said otherwise.
const SEEDS: u32 = 3;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some((target, seeds)) = asked(&arguments) else {
        let names: Vec<&str> = measure::TARGETS.iter().map(|(target, _)| target.name).collect();
        eprintln!("usage: measure_target {} [--seeds N]", names.join("|"));
        return ExitCode::from(2);
    };
    let watch = |name: &str, nanoseconds: f64| eprintln!("{nanoseconds:7.2} ns  {name}");
    let measured = measure::measure(target, seeds, &watch).and_then(|delays| {
        print!("{}", measure::text(&delays));
        eprintln!("circuits that no figure comes from:");
        let checks = measure::check(target, seeds, &delays, &|_, _| ())?;
        for check in checks {
            eprintln!(
                "{:7.2} ns predicted, {:7.2} measured  {}",
                check.predicted, check.measured, check.name
            );
        }
        Ok(())
    });
    match measured {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{:?}", miette::Report::new(error));
            ExitCode::FAILURE
        }
    }
}

/// The target and the number of seeds that the command line asks for.
fn asked(
    arguments: &[String],
) -> Option<(&'static (specula_flow::synth::SynthTarget, measure::Family), u32)> {
    let (name, seeds) = match arguments {
        [name] => (name, SEEDS),
        [name, flag, seeds] if flag == "--seeds" => (name, seeds.parse().ok().filter(|&n| n > 0)?),
        _ => return None,
    };
    Some((measure::TARGETS.iter().find(|(target, _)| target.name == name)?, seeds))
}

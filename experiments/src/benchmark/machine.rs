//! The machine on which measurements are made.
use std::fs;
use std::process::Command;
use std::thread;

use specula_sim::fast::InstructionSet;

/// The machine, as its makers describe it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Machine {
    /// The processor's model.
    pub cpu: String,
    /// Number of processors that this program may use.
    pub cores: usize,
    /// The instruction set that the columnar engine uses.
    pub instruction_set: &'static str,
    /// The versions of the installed tools, as they report them.
    pub tools: Vec<String>,
}

impl Machine {
    /// This machine.
    pub fn this() -> Machine {
        let tools = [["verilator", "--version"], ["g++", "--version"], ["iverilog", "-V"]];
        Machine {
            cpu: cpu().unwrap_or_else(|| format!("unknown {}", std::env::consts::ARCH)),
            cores: thread::available_parallelism().map_or(1, usize::from),
            instruction_set: InstructionSet::best().name(),
            tools: tools
                .into_iter()
                .filter_map(|[tool, argument]| first_line(tool, &[argument]))
                .collect(),
        }
    }
}

fn cpu() -> Option<String> {
    let linux = || model_name(&fs::read_to_string("/proc/cpuinfo").ok()?);
    let macos = || first_line("sysctl", &["-n", "machdep.cpu.brand_string"]);
    linux().or_else(macos)
}

/// The processor's model in the text of Linux's `/proc/cpuinfo`.
fn model_name(text: &str) -> Option<String> {
    let (_, name) = text
        .lines()
        .filter_map(|line| line.split_once(':'))
        .find(|(key, _)| key.trim() == "model name")?;
    Some(name.trim().to_owned())
}

fn first_line(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).env("LC_ALL", "C").output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).lines().next()?.trim().to_owned();
    (!text.is_empty()).then_some(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_model_is_found() {
        let text = "processor\t: 0\nmodel\t\t: 1\nmodel name\t: A CPU @ 3 GHz\n\nprocessor\t: 1\n";
        assert_eq!(model_name(text).as_deref(), Some("A CPU @ 3 GHz"));
        assert_eq!(model_name("Processor: ARM\n"), None);
    }
}

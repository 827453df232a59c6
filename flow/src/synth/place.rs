//! One run of nextpnr.
use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};
use specula_datapath::Design;
use specula_sim::{SimError, Tool};

use super::path::{CriticalPath, ReportedPath};
use super::{SynthError, SynthTarget, yosys};

/// A core that is placed and routed.
#[derive(Clone, Debug, Serialize)]
pub struct Placed {
    /// Seed of the placer.
    pub seed: u32,
    /// The clock that every path allows, in MHz.
    pub reached_mhz: f64,
    /// The longest path, if nextpnr tells it.
    pub critical_path: Option<CriticalPath>,
}

/// What runs with different seeds have in common.
pub struct Job<'a> {
    /// nextpnr.
    pub placer: &'a Tool,
    /// Where Yosys has left the netlist.
    pub directory: &'a Path,
    /// The target.
    pub target: &'a SynthTarget,
    /// The frequency to ask for, in MHz.
    pub asked_mhz: u32,
}

/// The parts of nextpnr's report that are read.
#[derive(Deserialize)]
struct Report {
    fmax: BTreeMap<String, Frequency>,
    #[serde(default)]
    critical_paths: Vec<ReportedPath>,
}

/// The frequency of a clock.
#[derive(Deserialize)]
pub struct Frequency {
    /// What every path allows, in MHz.
    pub achieved: f64,
}

impl Job<'_> {
    /// Places and routes a design's netlist with a seed.
    pub fn run(&self, design: &Design, seed: u32) -> Result<Placed, SynthError> {
        let text = self.report(seed, &[])?;
        placed(&text, design, seed).map_err(|problem| self.unknown(problem))
    }

    /// Places and routes the netlist with a seed and `more` arguments, and gives nextpnr's report.
    pub fn report(&self, seed: u32, more: &[&str]) -> Result<String, SynthError> {
        let name = format!("report_{seed}.json");
        let own = ["--json", yosys::NETLIST, "--report", &name, "-q"];
        let numbers =
            ["--freq".into(), self.asked_mhz.to_string(), "--seed".into(), seed.to_string()];
        let texts = self.target.arguments.iter().chain(&own).chain(more);
        let arguments: Vec<String> =
            texts.map(|argument| (*argument).to_owned()).chain(numbers).collect();
        self.placer
            .run_with_warnings(self.directory, &arguments)
            .map_err(|error| failed(error, self.target.device))?;
        Ok(std::fs::read_to_string(self.directory.join(&name))
            .map_err(SimError::file(format!("read {name} from nextpnr")))?)
    }

    /// The error that a report is not what it should be.
    pub fn unknown(&self, problem: String) -> SynthError {
        SynthError::Report { program: self.placer.command, problem }
    }
}

/// The error of a run that failed; nextpnr says why in lines that begin with `ERROR`.
fn failed(error: SimError, device: &'static str) -> SynthError {
    let SimError::ToolFailed { output, .. } = error else { return error.into() };
    let told: Vec<&str> = output.lines().filter(|line| line.starts_with("ERROR")).collect();
    let output = if told.is_empty() { output.clone() } else { told.join("\n") };
    SynthError::NotPlaced { device, output }
}

/// What a report says.
fn placed(text: &str, design: &Design, seed: u32) -> Result<Placed, String> {
    let report: Report = serde_json::from_str(text).map_err(|error| error.to_string())?;
    let slowest = report.fmax.values().map(|clock| clock.achieved).min_by(f64::total_cmp);
    let reached_mhz = slowest.ok_or("it tells no clock's frequency")?;
    let critical_path =
        report.critical_paths.iter().find(|path| path.is_clocked()).map(|path| path.named(design));
    Ok(Placed { seed, reached_mhz, critical_path })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slowest_clock_counts() {
        let design = crate::synth::path::tests::sum_and_product();
        let text =
            r#"{"fmax": {"a": {"achieved": 99.5, "constraint": 300}, "b": {"achieved": 71.25}}}"#;
        let placed = placed(text, &design, 3).expect("it is a report");
        assert_eq!((placed.seed, placed.reached_mhz), (3, 71.25));
        assert!(placed.critical_path.is_none());
    }

    #[test]
    fn a_core_that_is_too_large_is_said_to_be() {
        let error = SimError::ToolFailed {
            command: "nextpnr-ice40 --hx8k".to_owned(),
            status: "exit status: 255".to_owned(),
            output: "Info: packing\nERROR: Unable to place cell 'core.sum_LC'\n1 error".to_owned(),
        };
        let error = failed(error, SynthTarget::ICE40_HX.device).to_string();
        let expected = "the core cannot be placed on the iCE40HX8K CT256:\n\
                        ERROR: Unable to place cell 'core.sum_LC'";
        assert_eq!(error, expected);
    }

    #[test]
    fn a_report_without_a_clock_is_refused() {
        let design = crate::synth::path::tests::sum_and_product();
        for text in ["", "[]", "{}", r#"{"fmax": {}}"#, r#"{"fmax": {"a": {"achieved": "fast"}}}"#]
        {
            assert!(placed(text, &design, 1).is_err(), "{text}");
        }
    }
}

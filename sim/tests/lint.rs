//! The cores' Verilog passes the tools that people run on it, and none of them says a word.
use std::path::Path;
use std::process::Command;

use specula_datapath::design::ScopeId;
use specula_datapath::verilog::{self, Header};
use specula_fixtures::specs::{lyon, spec, spec_with};
use specula_fixtures::{each_method, few_spans, tools};
use specula_spec::lyon::{Difference, LyonSpec, Normalisation, Normals, ShapeDatapath};
use specula_spec::{CoreSpec, Method};

/// Specs that differ in what hardware they ask for.
fn specs() -> Vec<CoreSpec> {
    let mut specs: Vec<CoreSpec> = [1, 2, 4]
        .into_iter()
        .flat_map(|lights| Method::ALL.map(|method| spec(&few_spans::frame(5, lights, 6), method)))
        .collect();
    let frame = few_spans::frame(6, 1, 6);
    let choices = [
        (Difference::ReflectionMinusLight, Normalisation::G1, 0, 0),
        (Difference::ReflectionMinusLight, Normalisation::G2, 1, 3),
        (Difference::HalfwayCrossNormal, Normalisation::G1, 2, 1),
        (Difference::HalfwayCrossNormal, Normalisation::G2, 0, 2),
        (Difference::ReflectionMinusLight, Normalisation::G2, 2, 2),
    ];
    specs.extend(choices.map(|(difference, normalisation, newton_steps, squarings)| {
        lyon(&frame, |lyon| {
            (lyon.difference, lyon.normalisation) = (difference, normalisation);
            (lyon.newton_steps, lyon.squarings) = (newton_steps, squarings);
        })
    }));
    let changes: [fn(&mut LyonSpec); 7] = [
        |lyon| lyon.normals = Normals::Flat,
        |lyon| lyon.normals = Normals::Wrapped,
        |lyon| lyon.normalisation = Normalisation::Exact,
        |lyon| (lyon.normalisation, lyon.shape) = (Normalisation::None, ShapeDatapath::Root),
        |lyon| lyon.difference = Difference::LightReflection,
        |lyon| {
            (lyon.difference, lyon.shape) = (Difference::UnitHalfwayProjection, ShapeDatapath::Root)
        },
        |lyon| lyon.difference = Difference::UnitHalfwayMinusNormal,
    ];
    specs.extend(changes.map(|change| lyon(&frame, change)));
    let options = [
        (Method::Phong, "highlight = \"blinn\""),
        (Method::Phong, "highlight = \"torrance-sparrow\""),
        (Method::Phong, "highlight = \"trowbridge-reitz\""),
        (Method::Hybrid, "power = \"tables\""),
        (Method::Duff, "specular = \"blinn\"\npower = \"tables\""),
        (Method::Reflection, "power = \"tables\""),
        (Method::Consistent, "power = \"tables\""),
        (Method::Consistent, "diffuse = \"consistent\"\nhighlight = \"blinn\""),
        (Method::Slerp, "power = \"tables\""),
        (Method::Direct, "power = \"tables\""),
        (Method::Direct, "root = \"newton\""),
        (Method::Lyon, "normals = \"wrapped\"\naxis = \"previous\""),
        (Method::Slerp, "form = \"vector\""),
        (Method::Slerp, "form = \"vector\"\nframe = \"ends\""),
    ];
    specs.extend(options.map(|(method, lines)| spec_with(&frame, method, lines)));
    // For one frame alone, and for one in which every pixel is the same.
    let flat = few_spans::frame(6, 1, 1);
    specs.extend(Method::ALL.map(|method| spec(&frame, method).specialised(&frame)));
    specs.push(spec(&flat, Method::Gouraud).specialised(&flat));
    specs
}

/// Runs a tool on the Verilog of every spec of a method; `arguments` are given the core's name, and
/// run where its file `<name>.v` is.
fn silent(method: Method, tool: &str, arguments: impl Fn(&str) -> Vec<String>) {
    if !tools::is_installed(tool) {
        return;
    }
    let directory = tempfile::tempdir().unwrap();
    let name = method.name();
    for spec in specs().into_iter().filter(|spec| spec.method() == method) {
        let design = specula_hdl::elaborate(&spec, spec.method().name()).unwrap();
        let text = verilog::print(&design.to_block(), &Header { lines: vec!["A core.".into()] });
        std::fs::write(directory.path().join(format!("{name}.v")), text).unwrap();
        assert_silent(&mut command(tool, directory.path(), &arguments(name)), &spec);
    }
}

fn command(tool: &str, directory: &Path, arguments: &[String]) -> Command {
    let mut command = Command::new(tool);
    command.current_dir(directory).args(arguments).env("LC_ALL", "C");
    command
}

fn assert_silent(command: &mut Command, spec: &CoreSpec) {
    let output = command.output().unwrap();
    let said = [output.stdout, output.stderr].concat();
    let said = String::from_utf8_lossy(&said);
    assert!(output.status.success() && said.is_empty(), "{command:?} on {spec:?}:\n{said}");
}

fn words(line: String) -> Vec<String> {
    line.split(' ').map(str::to_owned).collect()
}

fn verilator_is_silent(method: Method) {
    silent(method, "verilator", |name| {
        words(format!("--lint-only -Wall --top-module {name} {name}.v"))
    });
}

fn icarus_is_silent(method: Method) {
    silent(method, "iverilog", |name| {
        words(format!("-g2001 -Wall -s {name} -o {name}.vvp {name}.v"))
    });
}

fn yosys_is_silent(method: Method) {
    let script = |name: &str| {
        format!("read_verilog {name}.v; hierarchy -check -top {name}; proc; check -assert")
    };
    silent(method, "yosys", |name| ["-q".into(), "-p".into(), script(name)].to_vec());
}

/// A scene may be called as something in its core.
#[test]
fn verilator_is_silent_whatever_the_scene_is_called() {
    if !tools::is_installed("verilator") {
        return;
    }
    let spec = spec(&few_spans::frame(5, 1, 6), Method::Hybrid);
    let inside = specula_hdl::elaborate(&spec, spec.method().name()).unwrap();
    let in_top = inside
        .nodes
        .iter()
        .filter(|node| node.scope == ScopeId::TOP)
        .map(|node| node.name.as_str());
    let instances = inside
        .scopes
        .iter()
        .filter(|scope| scope.parent == Some(ScopeId::TOP))
        .map(|scope| scope.instance.as_str());
    let directory = tempfile::tempdir().unwrap();
    let ports = ["red", "valid", "valid_out", "start", "clock", "reset"];
    for scene in
        in_top.chain(instances).step_by(7).chain(ports).chain(["entity", "always_ff", "always"])
    {
        let name = specula_hdl::module_name(scene, &spec);
        let design = specula_hdl::elaborate(&spec, &name).unwrap();
        let text = verilog::print(&design.to_block(), &Header { lines: vec!["A core.".into()] });
        std::fs::write(directory.path().join(format!("{name}.v")), text).unwrap();
        let arguments = words(format!("--lint-only -Wall --top-module {name} {name}.v"));
        assert_silent(&mut command("verilator", directory.path(), &arguments), &spec);
    }
}

each_method!(verilator_is_silent);
each_method!(icarus_is_silent);
each_method!(yosys_is_silent);

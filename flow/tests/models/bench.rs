//! A bench that reads a line of inputs for each clock and writes a line of outputs.
use std::fmt::Write;
use std::path::Path;
use std::process::{Command, Output};

use specula_fixtures::tools;

/// A device under test.
pub struct Device<'a> {
    /// The file of its model, in the folder of models.
    pub model: &'a str,
    /// Inputs with their widths in bits, in the order in which a line has them.
    pub inputs: &'a [(&'a str, u32)],
    /// Declarations and instances, with outputs called `out_0`, `out_1` and so on, and `clock`.
    pub instances: String,
    /// Number of outputs.
    pub outputs: usize,
}

impl Device<'_> {
    /// Values of all outputs in each clock, before its edge; `None` if Icarus is not installed.
    pub fn run(&self, lines: &[Vec<u64>]) -> Option<Vec<Vec<u64>>> {
        if !tools::is_installed("iverilog") {
            return None;
        }
        let folder = tempfile::tempdir().unwrap();
        let mut stimulus = String::new();
        for line in lines {
            let words: Vec<String> = line.iter().map(|value| format!("{value:x}")).collect();
            writeln!(stimulus, "{}", words.join(" ")).unwrap();
        }
        std::fs::write(folder.path().join("in.txt"), stimulus).unwrap();
        std::fs::write(folder.path().join("bench.v"), self.bench()).unwrap();
        let output = simulated(folder.path(), self.model);
        assert!(output.status.success() && output.stderr.is_empty(), "{output:?}");
        let text = std::fs::read_to_string(folder.path().join("out.txt")).unwrap();
        let number = |word: &str| u64::from_str_radix(word, 16).expect("no value is unknown");
        Some(text.lines().map(|line| line.split(' ').map(number).collect()).collect())
    }

    fn bench(&self) -> String {
        let declared: String = self
            .inputs
            .iter()
            .map(|(name, width)| format!("  reg [{}:0] {name} = 0;\n", width - 1))
            .collect();
        let outputs: Vec<String> = (0..self.outputs).map(|k| format!("out_{k}")).collect();
        let names: Vec<&str> = self.inputs.iter().map(|(name, _)| *name).collect();
        format!(
            "module bench;\n  reg clock = 0;\n  integer in, out, fields;\n{declared}\
             {instances}\n  initial begin\n    in = $fopen(\"in.txt\", \"r\");\n    out = \
             $fopen(\"out.txt\", \"w\");\n    fields = $fscanf(in, \"{reads}\", {names});\n    \
             while (fields == {count}) begin\n      #1 $fdisplay(out, \"{writes}\", {outputs});\n      \
             #1 clock = 1;\n      #1 clock = 0;\n      fields = $fscanf(in, \"{reads}\", {names});\n    \
             end\n    $fclose(out);\n  end\nendmodule\n",
            instances = self.instances,
            reads = vec!["%h"; names.len()].join(" "),
            names = names.join(", "),
            count = names.len(),
            writes = vec!["%h"; outputs.len()].join(" "),
            outputs = outputs.join(", "),
        )
    }
}

/// Connections of a port's bits, each by itself.
pub fn bits(port: &str, wire: &str, width: usize) -> String {
    (0..width).map(|k| format!(".{port}{k}({wire}[{k}]), ")).collect()
}

/// What `vvp` says of `bench.v` in a folder, with a model.
pub fn simulated(folder: &Path, model: &str) -> Output {
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(model);
    let compiled = Command::new("iverilog")
        .current_dir(folder)
        .args(["-g2001", "-s", "bench", "-o", "bench.vvp", "bench.v"])
        .arg(model)
        .output()
        .unwrap();
    assert!(compiled.status.success() && compiled.stderr.is_empty(), "{compiled:?}");
    Command::new("vvp").current_dir(folder).args(["-n", "bench.vvp"]).output().unwrap()
}

/// What a model writes to standard error when it is instantiated with parameters that it does not
/// know; `None` if Icarus is not installed.
pub fn refusal(module: &str, parameters: &str) -> Option<String> {
    if !tools::is_installed("iverilog") {
        return None;
    }
    let folder = tempfile::tempdir().unwrap();
    let text = format!("module bench;\n  {module} #({parameters}) block ();\nendmodule\n");
    std::fs::write(folder.path().join("bench.v"), text).unwrap();
    let output = simulated(folder.path(), &format!("{module}.v"));
    Some(String::from_utf8(output.stderr).unwrap())
}

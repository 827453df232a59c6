//! Host code in Python, run by CPython with numpy.
use std::fmt::Write;
use std::fs;
use std::process::Command;

use specula_fixtures::tools;
use specula_flow::host::{HostCode, Source};

use crate::c::{read, succeed, write};
use crate::cores::{HostResult, HostedCore, is_of_material, length};

/// What the code of each core gives. None without an interpreter that has numpy.
pub fn run(cores: &[HostedCore]) -> Option<Vec<HostResult>> {
    let python = tools::python_with_numpy()?;
    let folder = tempfile::tempdir().expect("there is room for a folder");
    let mut program = "import numpy as np\n".to_owned();
    for core in cores {
        write(folder.path(), &format!("{}.py", core.name), core.text("_ip.py").as_bytes());
        let values: Vec<u8> = core.values().into_iter().flat_map(f64::to_le_bytes).collect();
        write(folder.path(), &format!("{}.in", core.name), &values);
        program.push_str(&core.with_code(|code| statements(core, code)));
    }
    write(folder.path(), "hosts.py", program.as_bytes());
    succeed(Command::new(python).args(["-W", "error", "hosts.py"]).current_dir(folder.path()));
    let result = |core: &HostedCore| {
        let bytes =
            fs::read(folder.path().join(format!("{}.out", core.name))).expect("it is there");
        read(core, &bytes)
    };
    Some(cores.iter().map(result).collect())
}

/// Statements that run the code of a core.
fn statements(core: &HostedCore, code: &HostCode) -> String {
    let name = &core.name;
    let mut text = format!("import {name} as block\nvalues = np.fromfile(\"{name}.in\")\n");
    let (frame, spans) = (code.frame_sources(), code.span_sources());
    let length_of =
        |sources: &[&Source]| sources.iter().map(|source| length(source)).sum::<usize>();
    if code.has_frame() {
        let _ = writeln!(text, "frame = block.Frame({})", arguments(&frame, "values[", 0));
    }
    let (before, width) = (length_of(&frame), 4 + length_of(&spans));
    let _ = writeln!(text, "rows = values[{before}:].reshape(-1, {width})");
    let mut fields = "pixels=rows[:, 0].astype(int), last=rows[:, 1] > 0, ".to_owned();
    if code.has_positions() {
        fields.push_str("x=rows[:, 2].astype(int), y=rows[:, 3].astype(int), ");
    }
    fields.push_str(&arguments(&spans, "rows[:, ", 4));
    let frame = if code.packets_need_the_frame() { "frame, " } else { "" };
    let writes = if code.writes() > 0 { "block.registers(frame)" } else { "[]" };
    let _ = writeln!(
        text,
        "with open(\"{name}.out\", \"wb\") as out:\n    out.write(np.array({writes}, \
         np.uint32).tobytes())\n    out.write(block.packets({frame}block.Spans({fields}))\
         .tobytes())"
    );
    text
}

/// Values as arguments, from a place of an array on; those of a material as one argument.
fn arguments(sources: &[&Source], array: &str, mut place: usize) -> String {
    let (mut own, mut of_material) = (String::new(), String::new());
    for source in sources {
        let value = match length(source) {
            1 => format!("{array}{place}]"),
            length => format!("{array}{place}:{}]", place + length),
        };
        place += length(source);
        let arguments = if is_of_material(source) { &mut of_material } else { &mut own };
        let _ = write!(arguments, "{}={value}, ", source.name);
    }
    if !of_material.is_empty() {
        let _ = write!(own, "material=block.Material({of_material})");
    }
    own
}

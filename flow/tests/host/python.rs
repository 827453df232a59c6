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

fn statements(core: &HostedCore, code: &HostCode) -> String {
    let name = &core.name;
    let mut text = format!("import {name} as block\nvalues = np.fromfile(\"{name}.in\")\n");
    let frame = code.frame_sources();
    let mut place = 0;
    let mut of_frame = |source: &&&Source| {
        let value = match length(source) {
            1 => format!("values[{place}]"),
            length => format!("values[{place}:{}]", place + length),
        };
        place += length(source);
        format!("{}={value}", source.name)
    };
    let [own, of_material] = [false, true].map(|is_material| {
        let wanted = frame.iter().filter(|source| is_of_material(source) == is_material);
        wanted.collect::<Vec<_>>().iter().map(&mut of_frame).collect::<Vec<_>>().join(", ")
    });
    if code.has_frame() {
        let material = match of_material.is_empty() {
            true => String::new(),
            false => format!(", material=block.Material({of_material})"),
        };
        let _ =
            writeln!(text, "frame = block.Frame({})", (own + &material).trim_start_matches(", "));
    }
    let frame_length = place;
    let sources = code.span_sources();
    let width = 4 + sources.iter().map(|source| length(source)).sum::<usize>();
    let _ = writeln!(text, "rows = values[{frame_length}:].reshape(-1, {width})");
    let mut place = 4;
    let mut of_span = |source: &&&Source| {
        let value = match length(source) {
            1 => format!("rows[:, {place}]"),
            length => format!("rows[:, {place}:{}]", place + length),
        };
        place += length(source);
        format!("{}={value}", source.name)
    };
    let [own, of_material] = [false, true].map(|is_material| {
        let wanted = sources.iter().filter(|source| is_of_material(source) == is_material);
        wanted.collect::<Vec<_>>().iter().map(&mut of_span).collect::<Vec<_>>().join(", ")
    });
    let mut arguments = "pixels=rows[:, 0].astype(int), last=rows[:, 1] > 0".to_owned();
    if code.has_positions() {
        arguments.push_str(", x=rows[:, 2].astype(int), y=rows[:, 3].astype(int)");
    }
    for (argument, is_there) in [
        (own.clone(), !own.is_empty()),
        (format!("material=block.Material({of_material})"), !of_material.is_empty()),
    ] {
        if is_there {
            let _ = write!(arguments, ", {argument}");
        }
    }
    let frame = if code.packets_need_the_frame() { "frame, " } else { "" };
    let writes = match code.writes() {
        0 => "[]",
        _ => "block.registers(frame)",
    };
    let _ = writeln!(
        text,
        "with open(\"{name}.out\", \"wb\") as out:\n    out.write(np.array({writes}, \
         np.uint32).tobytes())\n    out.write(block.packets({frame}block.Spans({arguments}))\
         .tobytes())"
    );
    text
}

//! Host code in C, compiled by gcc.
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use specula_fixtures::tools;
use specula_flow::host::{HostCode, Kind, Source};

use crate::cores::{HostResult, HostedCore, is_of_material, length};

const WARNINGS: [&str; 5] = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"];

/// What the code of each core gives with numbers of a type. None without gcc.
pub fn run(cores: &[HostedCore], real: &str) -> Option<Vec<HostResult>> {
    if !tools::is_installed("gcc") {
        return None;
    }
    let folder = tempfile::tempdir().expect("there is room for a folder");
    let mut program = "#include <stdio.h>\n#include <string.h>\n".to_owned();
    for core in cores {
        // A header that is for double alone refuses to be asked.
        if real != "double" {
            let _ = writeln!(program, "#define {}_REAL {real}", core.name.to_uppercase());
        }
        let _ = writeln!(program, "#include \"{}.h\"", core.name);
        write(folder.path(), &format!("{}.h", core.name), core.text(".h").as_bytes());
        let values: Vec<u8> = core.values().into_iter().flat_map(f64::to_le_bytes).collect();
        write(folder.path(), &format!("{}.in", core.name), &values);
    }
    program.push_str(NEXT);
    cores.iter().for_each(|core| program.push_str(&core.with_code(|code| function(core, code))));
    program.push_str("int main(void) {\n");
    for core in cores {
        let _ = writeln!(program, "  run_{}();", core.name);
    }
    program.push_str("  return 0;\n}\n");
    write(folder.path(), "hosts.c", program.as_bytes());
    let compile = [
        &["-std=c99", "-O2", "-ffp-contract=off"][..],
        &WARNINGS,
        &["-o", "hosts", "hosts.c", "-lm"],
    ];
    succeed(Command::new("gcc").args(compile.concat()).current_dir(folder.path()));
    succeed(Command::new("./hosts").current_dir(folder.path()));
    let result = |core: &HostedCore| {
        let bytes =
            fs::read(folder.path().join(format!("{}.out", core.name))).expect("it is there");
        read(core, &bytes)
    };
    Some(cores.iter().map(result).collect())
}

/// Writes a file of the folder.
pub fn write(folder: &Path, name: &str, bytes: &[u8]) {
    fs::write(folder.join(name), bytes).expect("a file can be written");
}

/// Runs a program, which has to succeed.
pub fn succeed(command: &mut Command) {
    let ended = command.output().expect("the program runs");
    let said = [ended.stdout, ended.stderr].concat();
    assert!(ended.status.success(), "{command:?}: {}", String::from_utf8_lossy(&said));
}

/// What a program has written: register writes, and words.
pub fn read(core: &HostedCore, bytes: &[u8]) -> HostResult {
    let stream = core.stream();
    let writes = HostCode::new(&stream).writes();
    let (registers, words) = bytes.split_at(8 * writes);
    let number = |bytes: &[u8]| {
        bytes.iter().rev().fold(0_u64, |number, &byte| number << 8 | u64::from(byte))
    };
    let write = |bytes: &[u8]| (number(&bytes[..4]) as u32, number(&bytes[4..]) as u32);
    HostResult {
        registers: registers.chunks(8).map(write).collect(),
        words: words.chunks(core.word_bits() as usize / 8).map(number).collect(),
    }
}

const NEXT: &str = "\
static double next(FILE *file) {
  double value = 0;
  if (fread(&value, sizeof value, 1, file) != 1) value = 0;
  return value;
}
";

/// The function that runs the code of a core.
fn function(core: &HostedCore, code: &HostCode) -> String {
    let (name, upper) = (&core.name, core.name.to_uppercase());
    let mut text = format!(
        "static void run_{name}(void) {{\n  FILE *in = fopen(\"{name}.in\", \"rb\");\n\
         \x20 FILE *out = fopen(\"{name}.out\", \"wb\");\n  struct {name}_span span;\n\
         \x20 uint{}_t words[{upper}_WORDS];\n  int i;\n",
        core.word_bits()
    );
    let material_of_spans = code.has_material() && code.materials_are_of_spans();
    if material_of_spans {
        let _ = writeln!(text, "  struct {name}_material material;");
    }
    if code.has_frame() {
        let _ = writeln!(text, "  struct {name}_frame frame;");
    }
    for source in code.frame_sources() {
        let holder = if is_of_material(source) { "frame.material." } else { "frame." };
        text.push_str(&assigned(name, holder, source));
    }
    if code.writes() > 0 {
        let _ = writeln!(
            text,
            "  {{\n    struct {name}_write writes[{upper}_WRITES];\n    {name}_registers(&frame, \
             writes);\n    fwrite(writes, sizeof writes, 1, out);\n  }}"
        );
    }
    let _ = writeln!(text, "  for (i = 0; i < {}; ++i) {{", core.spans());
    text.push_str("  span.pixels = (uint32_t)next(in);\n  span.last = next(in) > 0;\n");
    let position = ["x", "y"].map(|axis| {
        if code.has_positions() {
            format!("  span.{axis} = (uint32_t)next(in);\n")
        } else {
            "  (void)next(in);\n".to_owned()
        }
    });
    text.push_str(&position.concat());
    for source in code.span_sources() {
        let holder = if is_of_material(source) { "material." } else { "span." };
        text.push_str(&assigned(name, holder, source));
    }
    if material_of_spans {
        text.push_str("  span.material = &material;\n");
    }
    let frame = if code.packets_need_the_frame() { "&frame, " } else { "" };
    let _ = writeln!(
        text,
        "  {name}_packet({frame}&span, words);\n  fwrite(words, sizeof words, 1, out);\n  }}\n\
         \x20 fclose(in);\n  fclose(out);\n}}"
    );
    text
}

/// Statements that read a field.
fn assigned(name: &str, holder: &str, source: &Source) -> String {
    let field = &source.name;
    let kind =
        if source.kind == Kind::Whole { "uint32_t".to_owned() } else { format!("{name}_real") };
    let one = |place: &str| format!("  {holder}{field}{place} = ({kind})next(in);\n");
    match length(source) {
        1 => one(""),
        _ => ["[0]", "[1]", "[2]"].map(one).concat(),
    }
}

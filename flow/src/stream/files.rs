//! The files of a block.
use super::c_header::c_header;
use super::constraints::constraints;
use super::handshake::Handshake;
use super::system_rdl::system_rdl;
use super::template::Values;
use super::vectors::{FrameVectors, Vectors};
use super::{StreamCore, bench, data_sheet, fill, formal, synthesis};

/// A file of a block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name, without a folder.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// How a block's host code is called, as its documents show it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HostCall {
    /// Whether there are values of a frame.
    pub has_frame: bool,
    /// Whether packets depend on them.
    pub packets_need_the_frame: bool,
}

/// What a simulator needs of a block besides the core's own file: stream top, registers, bench, and
/// vectors of some frames.
pub fn bench_files(core: &StreamCore, frames: &[FrameVectors]) -> Vec<File> {
    let vectors = Vectors::new(core, frames);
    filled_bench_files(core, &vectors, &verilog_values(core, &vectors, frames.len()))
}

/// The same, of vectors and values that are there.
fn filled_bench_files(core: &StreamCore, vectors: &Vectors, values: &Values) -> Vec<File> {
    let mut files = vec![
        verilog(core, values, "_axis.v", "the stream top", include_str!("templates/axis.v")),
        verilog(core, values, "_regs.v", "the registers", include_str!("templates/regs.v")),
        verilog(core, values, "_ip.v", "streams and registers", include_str!("templates/ip.v")),
        verilog(core, values, "_tb.v", "the bench", include_str!("templates/tb.v")),
        file(core, "_packets.hex", vectors.packets()),
        file(core, "_pixels.hex", vectors.pixels()),
    ];
    if core.has_frame_inputs() {
        files.push(file(core, "_registers.hex", vectors.registers()));
    }
    files
}

/// Every file of a block besides the core's own, which `command` has made, and its host code, which
/// is called by `call`: those of its bench, properties, constraints, flow files, documents.
pub fn files(
    core: &StreamCore,
    frames: &[FrameVectors],
    command: &str,
    call: HostCall,
) -> Vec<File> {
    let name = core.name();
    let vectors = Vectors::new(core, frames);
    let mut values = verilog_values(core, &vectors, frames.len());
    let formal = include_str!("templates/formal.v");
    let mut files = filled_bench_files(core, &vectors, &values);
    files.extend([
        verilog(core, &values, "_formal.v", "the properties", formal),
        file(core, "_registers.h", c_header(core)),
        file(core, ".rdl", system_rdl(core)),
    ]);
    files.extend(constraints(core));
    let handshake = Handshake::new(core, frames);
    files.extend(handshake.into_iter().flat_map(|handshake| handshake.drawings(name)));
    document_values(core, command, &mut values);
    host_call(core, call, &mut values);
    let filled = |name: String, template: &str| File { name, text: values.fill(template) };
    files.extend([
        filled(format!("{name}.md"), include_str!("templates/data_sheet.md")),
        filled("README.md".to_owned(), include_str!("templates/README.md")),
        filled(format!("{name}.core"), include_str!("templates/fusesoc.core")),
        filled("Makefile".to_owned(), include_str!("templates/Makefile")),
        filled("prove.sh".to_owned(), include_str!("templates/prove.sh")),
        filled(format!("test_{name}.py"), include_str!("templates/cocotb.py")),
        filled(format!("{name}_ip.tcl"), include_str!("templates/vivado.tcl")),
        filled(format!("{name}_litex.py"), include_str!("templates/litex.py")),
    ]);
    files
}

/// A file that is called after the core.
fn file(core: &StreamCore, suffix: &str, text: String) -> File {
    File { name: format!("{}{suffix}", core.name()), text }
}

/// A file of Verilog, by its template.
fn verilog(core: &StreamCore, values: &Values, suffix: &str, what: &str, template: &str) -> File {
    let mut values = values.clone();
    let (version, name) = (env!("CARGO_PKG_VERSION"), core.name());
    values.set("ABOUT", format!("// Specula {version}: {what} of the core {name}."));
    file(core, suffix, values.fill(template))
}

/// Everything that templates of Verilog ask for.
fn verilog_values(core: &StreamCore, vectors: &Vectors, frames: usize) -> Values {
    let mut values = fill::values(core);
    bench::values(core, vectors, frames, &mut values);
    formal::values(core, &mut values);
    let axis = "\n//\n// Before the first span of a frame the pipeline drains; then `frame` is high for a \
                clock, in which\n// inputs that hold for a frame are taken over.";
    let regs = "\n//\n// What is written to an input waits for the next frame: the core sees it from the \
                first span on whose\n// packet comes whole after it, if that begins a frame.";
    let registers = core.has_frame_inputs();
    values.set("FRAME_ABOUT", if registers { axis } else { "" });
    values.set("REGS_ABOUT", if registers { regs } else { "" });
    values
}

/// Adds what templates of documents and flow files ask for besides.
fn document_values(core: &StreamCore, command: &str, values: &mut Values) {
    let name = core.name();
    values.set("VERSION_TEXT", env!("CARGO_PKG_VERSION"));
    values.set("VERSION_MAJOR_MINOR", MAJOR_MINOR);
    values.set("COMMAND", command);
    values.set("CLASS", class_name(name));
    synthesis::values(core, values);
    data_sheet::values(core, values);
    let registers = core.has_frame_inputs();
    values.set(
        "REGISTER_VECTORS",
        if registers { format!(" {name}_registers.hex") } else { String::new() },
    );
}

/// Adds how the host's code is called.
fn host_call(core: &StreamCore, call: HostCall, values: &mut Values) {
    let name = core.name();
    let HostCall { has_frame, packets_need_the_frame } = call;
    values.set("UPPER", name.to_uppercase());
    values.set("AND_A_FRAME", if has_frame { " and of a frame" } else { "" });
    values.set("FRAME_ARGUMENT", if packets_need_the_frame { "&frame, " } else { "" });
    values.set("PYTHON_FRAME_ARGUMENT", if packets_need_the_frame { "frame, " } else { "" });
    let registers = core.has_frame_inputs();
    let before = if registers { ", and the registers before it" } else { "" };
    values.set("HOST_REGISTERS", before);
    let writes = format!("grep -v '^//' {name}_registers.hex; ");
    values.set("HOST_WRITES", if registers { writes } else { String::new() });
}

/// The program's version as Vivado counts versions of an IP.
const MAJOR_MINOR: &str =
    concat!(env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"));

/// The name of a core's class in Python: that of `lit_torus` is `LitTorusCore`.
fn class_name(name: &str) -> String {
    let word = |word: &str| {
        let (first, rest) = word.split_at(word.chars().next().map_or(0, char::len_utf8));
        first.to_uppercase() + rest
    };
    name.split('_').map(word).chain(["Core".to_owned()]).collect()
}

//! The files of a block.
use crate::host::HostCode;

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

/// Every file of a block besides the core's own, which `command` has made: stream top, registers,
/// bench, vectors of some frames, documents.
pub fn files(core: &StreamCore, frames: &[FrameVectors], command: &str) -> Vec<File> {
    let vectors = Vectors::new(core, frames);
    let name = core.name();
    let file = |suffix: &str, text: String| File { name: format!("{name}{suffix}"), text };
    let values = values(core, &vectors, frames.len(), command);
    let verilog = |suffix: &str, what: &str, template: &str| {
        let mut values = values.clone();
        let version = env!("CARGO_PKG_VERSION");
        values.set("ABOUT", format!("// Specula {version}: {what} of the core {name}."));
        file(suffix, values.fill(template))
    };
    let mut files = vec![
        verilog("_axis.v", "the stream top", include_str!("templates/axis.v")),
        verilog("_regs.v", "the registers", include_str!("templates/regs.v")),
        verilog("_ip.v", "streams and registers", include_str!("templates/ip.v")),
        verilog("_tb.v", "the bench", include_str!("templates/tb.v")),
        verilog("_formal.v", "the properties", include_str!("templates/formal.v")),
        file("_packets.hex", vectors.packets()),
        file("_pixels.hex", vectors.pixels()),
        file("_registers.h", c_header(core)),
        file(".rdl", system_rdl(core)),
    ];
    if core.has_frame_inputs() {
        files.push(file("_registers.hex", vectors.registers()));
    }
    files.extend(constraints(core));
    let handshake = Handshake::new(core, frames);
    files.extend(handshake.into_iter().flat_map(|handshake| handshake.drawings(name)));
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

/// Everything that the templates ask for.
fn values(core: &StreamCore, vectors: &Vectors, frames: usize, command: &str) -> Values {
    let name = core.name();
    let mut values = fill::values(core);
    bench::values(core, vectors, frames, &mut values);
    formal::values(core, &mut values);
    values.set("VERSION_TEXT", env!("CARGO_PKG_VERSION"));
    values.set("VERSION_MAJOR_MINOR", MAJOR_MINOR);
    values.set("COMMAND", command);
    values.set("CLASS", class_name(name));
    synthesis::values(core, &mut values);
    data_sheet::values(core, &mut values);
    let registers = core.has_frame_inputs();
    values.set(
        "REGISTER_VECTORS",
        if registers { format!(" {name}_registers.hex") } else { String::new() },
    );
    let axis = "\n//\n// Before the first span of a frame the pipeline drains; then `frame` is high for a \
                clock, in which\n// inputs that hold for a frame are taken over.";
    let regs = "\n//\n// What is written to an input waits for the next frame: the core sees it from the \
                first span on whose\n// packet comes whole after it, if that begins a frame.";
    host_code(core, &mut values);
    values.set("FRAME_ABOUT", if registers { axis } else { "" });
    values.set("REGS_ABOUT", if registers { regs } else { "" });
    values
}

/// How the host's code is called.
fn host_code(core: &StreamCore, values: &mut Values) {
    let (name, code) = (core.name(), HostCode::new(core));
    let needs_frame = code.packets_need_the_frame();
    values.set("UPPER", name.to_uppercase());
    values.set("AND_A_FRAME", if code.has_frame() { " and of a frame" } else { "" });
    values.set("FRAME_ARGUMENT", if needs_frame { "&frame, " } else { "" });
    values.set("PYTHON_FRAME_ARGUMENT", if needs_frame { "frame, " } else { "" });
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

//! The files of a block.
use std::fmt::Write;

use specula_spec::{FieldContent, Positions};

use crate::host::HostCode;

use super::register_map::{Access, Register, register_map};
use super::template::Values;
use super::vectors::{FrameVectors, Vectors};
use super::{StreamCore, bench, fill};

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
        file("_packets.hex", vectors.packets()),
        file("_pixels.hex", vectors.pixels()),
        file("_packet.md", packet_page(core)),
        file("_registers.h", c_header(core)),
        file(".rdl", system_rdl(core)),
    ];
    if core.has_frame_inputs() {
        files.push(file("_registers.hex", vectors.registers()));
    }
    files.extend(constraints(core));
    let plain =
        |name: &str, template: &str| File { name: name.to_owned(), text: values.fill(template) };
    files.push(plain("README.md", include_str!("templates/README.md")));
    files.push(file(".core", values.fill(include_str!("templates/fusesoc.core"))));
    files.push(plain("Makefile", include_str!("templates/Makefile")));
    files
}

/// Everything that the templates ask for.
fn values(core: &StreamCore, vectors: &Vectors, frames: usize, command: &str) -> Values {
    let name = core.name();
    let mut values = fill::values(core);
    bench::values(core, vectors, frames, &mut values);
    values.set("VERSION_TEXT", env!("CARGO_PKG_VERSION"));
    values.set("COMMAND", command);
    values.set("YOSYS_ARCH", yosys_arch(core));
    values.set("YOSYS_CELLS", yosys_cells(core));
    values.set("FULL_SPEED", (core.words() + 1).div_ceil(core.design.interval));
    values.set("REGISTER_TABLE", register_table(core));
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
    values.set("FRAME_RULES", if registers { FRAME_RULES } else { NO_FRAME_RULES });
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

/// The clock that the core was made for, in the format of its target's tools, if it has one that such
/// a file is known for.
fn constraints(core: &StreamCore) -> Option<File> {
    let target = core.spec.target.as_ref()?;
    let (version, name, mhz) = (env!("CARGO_PKG_VERSION"), core.name(), target.clock_mhz);
    let about = format!("# Specula {version}: the clock of {name}_ip.\n");
    let create = || {
        let period = 1e3 / mhz;
        format!("create_clock -name aclk -period {period:.3} [get_ports aclk]\n")
    };
    let (suffix, clock) = match target.name.as_str() {
        "ecp5" => (".lpf", format!("FREQUENCY PORT \"aclk\" {mhz} MHZ;\n")),
        "xilinx7" => (".xdc", create()),
        "gowin" => (".sdc", create()),
        _ => return None,
    };
    Some(File { name: format!("{name}{suffix}"), text: about + &clock })
}

/// Yosys's name for the family of the core's target; a core for any device is tried on an ECP5.
fn yosys_arch(core: &StreamCore) -> &'static str {
    match core.spec.target.as_ref().map(|target| target.name.as_str()) {
        Some("xilinx7") => "xilinx",
        Some("gowin") => "gowin",
        Some(name) if name.starts_with("ice40") => "ice40",
        _ => "ecp5",
    }
}

/// What reads the cells that a core for a target asks for by name, before it is read itself.
fn yosys_cells(core: &StreamCore) -> &'static str {
    match core.spec.target.as_ref().map(|target| target.name.as_str()) {
        Some("ecp5") => "read_verilog -lib +/ecp5/cells_sim.v +/ecp5/cells_bb.v; ",
        Some("ice40up") => "read_verilog -lib +/ice40/cells_sim.v; ",
        _ => "",
    }
}

const FRAME_RULES: &str = "\
Inputs that hold for a frame, from address 0x100 on, may be written at any time: what is written waits
for the next frame. When the first packet of a frame is whole and the last pixel of the frame before
has left the core, all of them are taken over at once, and `frames` counts on. So a host writes the
registers of the next frame when `frames` says that the one before has begun, and before it sends the
last word of its first packet.";

const NO_FRAME_RULES: &str = "\
Nothing holds for a frame in this core: lights and materials are constants in it, or part of every
packet.";

/// The registers as a table.
fn register_table(core: &StreamCore) -> String {
    let mut text =
        "| address | register | access | after reset | what it is |\n|---|---|---|---|---|\n"
            .to_owned();
    for Register { name, address, access, about, reset } in register_map(core) {
        let access = match access {
            Access::Read => "read",
            Access::ReadClear => "read, clear",
            Access::ReadWrite => "read, write",
        };
        let reset = reset.map_or_else(|| "0".to_owned(), |word| format!("0x{word:08x}"));
        // Writing to a String cannot fail, here and below.
        let _ = writeln!(text, "| 0x{address:03x} | `{name}` | {access} | {reset} | {about} |");
    }
    text
}

/// A packet, bit by bit.
fn packet_page(core: &StreamCore) -> String {
    let (version, name) = (env!("CARGO_PKG_VERSION"), core.name());
    let (bits, words, word) = (core.layout.bits, core.words(), core.word.bits());
    let mut text = format!(
        "<!-- Specula {version}: the span packet of {name}_ip. -->\n# The span packet of {name}_ip\n\n\
         A packet is a string of {bits} bits, cut into {words} words of {word} bits: bit 0 of the \
         packet is bit 0 of\nword 0. Bits behind the last field are 0. Signed fields are in two's \
         complement; the value of a field\nis its bits as a whole number times 2^-f, f being the \
         number behind the point of its format.\n\n\
         | bits | word: bits | field | format | unit | what it is | how a host computes it |\n\
         |---|---|---|---|---|---|---|\n"
    );
    let meanings = core.spec.input_meanings();
    for field in &core.layout.fields {
        let (low, high) = (field.first_bit, field.first_bit + field.format.width() - 1);
        let range = |low: u32, high: u32| {
            if low == high { low.to_string() } else { format!("{low}-{high}") }
        };
        let place = match (low / word, high / word) {
            (first, last) if first == last => {
                format!("{first}: {}", range(low % word, high % word))
            }
            (first, last) => {
                let end = range(0, high % word);
                format!("{first}: {} to {last}: {end}", range(low % word, word - 1))
            }
        };
        let (unit, what, computed) = match field.content {
            FieldContent::Pixels => ("pixels", "length of the span".into(), "at least 1".into()),
            FieldContent::Last => ("", "1 in the last span of a frame, else 0".into(), "".into()),
            FieldContent::Zero => ("", "0".into(), "".into()),
            FieldContent::X => ("pixels", "column of the first pixel".into(), "".into()),
            FieldContent::Y => ("pixels", "row of the span".into(), "".into()),
            FieldContent::Input(number) => {
                let meaning = &meanings[number];
                (meaning.unit, meaning.what.clone(), meaning.computed.clone())
            }
        };
        let _ = writeln!(
            text,
            "| {} | {place} | `{}` | {} | {unit} | {what} | {computed} |",
            range(low, high),
            field.name,
            field.format
        );
    }
    text.push_str(
        "\nValues are rounded to the nearest that the format has, ties up. V = (0, 0, 1) is the \
         direction to the\neye, L that to a light, N the normal; x is to the right, y up, z to the eye.\n",
    );
    let pixel = match core.layout.positions {
        Positions::Absent => "",
        Positions::Sent => {
            "\nPixels have their column in bits 24 to 39 and their row in bits 40 to 55.\n"
        }
    };
    text.push_str(pixel);
    text
}

/// The register map for C.
fn c_header(core: &StreamCore) -> String {
    let (version, name) = (env!("CARGO_PKG_VERSION"), core.name());
    let upper = name.to_uppercase();
    let mut text = format!(
        "// Specula {version}: the registers of {name}_ip.\n#ifndef {upper}_REGISTERS_H\n\
         #define {upper}_REGISTERS_H\n"
    );
    for Register { name, address, access, about, reset } in register_map(core) {
        let register = format!("{upper}_{}", name.to_uppercase());
        let _ = writeln!(text, "\n/* {about} */\n#define {register} 0x{address:03x}u");
        if let (Access::Read, Some(word)) = (access, reset) {
            let _ = writeln!(text, "#define {register}_VALUE 0x{word:08x}u");
        }
    }
    text.push_str("\n#endif\n");
    text
}

/// The register map as SystemRDL.
fn system_rdl(core: &StreamCore) -> String {
    let (version, name) = (env!("CARGO_PKG_VERSION"), core.name());
    let mut text = format!(
        "// Specula {version}: the registers of {name}_ip.\naddrmap {name} {{\n\
         \x20   name = \"{name}_ip\";\n    default regwidth = 32;\n"
    );
    for Register { name, address, access, about, reset } in register_map(core) {
        let (software, hardware) = match access {
            Access::Read => ("r", if reset.is_some() { "na" } else { "w" }),
            Access::ReadClear => ("rw; onwrite = wclr", "w"),
            Access::ReadWrite => ("rw", "r"),
        };
        let reset = reset.map(|word| format!(" = 32'h{word:08x}")).unwrap_or_default();
        let _ = writeln!(
            text,
            "    reg {{\n        desc = \"{about}\";\n        field {{ sw = {software}; hw = \
             {hardware}; }} value[31:0]{reset};\n    }} {name} @ 0x{address:03x};"
        );
    }
    text.push_str("};\n");
    text
}

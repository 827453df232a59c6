//! The register map as SystemRDL.
use std::fmt::Write;

use super::StreamCore;
use super::register_map::{Access, Register, register_map};

/// The register map as SystemRDL.
pub fn system_rdl(core: &StreamCore) -> String {
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

//! The register map for C.
use std::fmt::Write;

use super::StreamCore;
use super::register_map::{Access, Register, register_map};

/// The register map for C.
pub fn c_header(core: &StreamCore) -> String {
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

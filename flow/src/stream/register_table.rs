//! The registers as documents show them.
use std::fmt::Write;

use super::StreamCore;
use super::register_map::{Access, Register, register_map};

/// The registers as a table.
pub fn register_table(core: &StreamCore) -> String {
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
        // Writing to a String cannot fail.
        let _ = writeln!(text, "| 0x{address:03x} | `{name}` | {access} | {reset} | {about} |");
    }
    text
}

/// When what is written to them is taken over.
pub fn frame_rules(core: &StreamCore) -> &'static str {
    if core.has_frame_inputs() { FRAME_RULES } else { NO_FRAME_RULES }
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

//! Verilog-2001 that people want to own: one module per distinct unit, named after it, with formats
//! and latencies in comments.
mod library;
mod module;
pub mod statement;
mod unread;

use std::fmt::Write;

use crate::block::Module;

pub use crate::names::{CONTROL, module_name};
pub use library::{Library, Printed};

/// What the file says of itself, one line each, without comment marks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Header {
    /// The lines.
    pub lines: Vec<String>,
}

/// Prints a design as one Verilog file, the core first and then its units. The same design and
/// header give the same bytes.
pub fn print(core: &Module, header: &Header) -> String {
    let mut library = Library::new(&core.instance);
    let children = library.add_children(core);
    let top = module::text(core, &core.instance, &library.names(&children));
    let mut file = String::new();
    for line in &header.lines {
        // Writing to a String cannot fail.
        let _ = writeln!(file, "{}", format!("// {line}").trim_end());
    }
    let _ = write!(file, "`default_nettype none\n\n{top}");
    if !library.modules().is_empty() {
        file.push_str("\n// Units follow; they stand in the core's file so that one file is the whole design.\n");
        file.push_str("// verilator lint_off DECLFILENAME\n");
        for module in library.modules() {
            let _ = write!(file, "\n{}", module.source());
        }
        file.push_str("// verilator lint_on DECLFILENAME\n");
    }
    file.push_str("\n`default_nettype wire\n");
    file
}

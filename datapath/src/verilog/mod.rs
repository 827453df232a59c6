//! Verilog-2001 that people want to own: one module per distinct unit, named after it, with formats
//! and latencies in comments.
mod counted;
mod delay_modules;
mod delays;
mod gated_sum_modules;
mod library;
mod module;
mod multiplier_modules;
mod nets;
mod places;
pub mod statement;
mod unread;

use std::fmt::Write;

use crate::block::Module;

pub use crate::names::{CONTROL, module_name};
pub use counted::Counted;
pub use delays::{DelayLine, Delays, LongDelays};
pub use library::{Library, Printed};
pub use nets::Nets;
pub use places::{Place, places};

/// What the file says of itself, one line each, without comment marks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Header {
    /// The lines.
    pub lines: Vec<String>,
}

/// Prints a design as one Verilog file, the core first and then its units. The same design and
/// header give the same bytes.
pub fn print(core: &Module, header: &Header) -> String {
    print_with(core, header, LongDelays::Memories)
}

/// [`print()`] with a choice of what long delay lines are made of.
pub fn print_with(core: &Module, header: &Header, long_delays: LongDelays) -> String {
    let mut library = Library::new(&core.instance, long_delays);
    let (top, _) = library.text(core, &core.instance);
    let mut file = String::new();
    for line in &header.lines {
        // Writing to a String cannot fail.
        let _ = writeln!(file, "{}", format!("// {line}").trim_end());
    }
    let _ = write!(file, "`default_nettype none\n\n{top}");
    let units = library.modules().iter().map(Printed::source);
    let inner: Vec<String> = units.chain(library.primitive_modules()).collect();
    if !inner.is_empty() {
        file.push_str(
            "\n// Units follow; they stand in the core's file so that one file is the whole design.\n",
        );
        file.push_str("// verilator lint_off DECLFILENAME\n");
        for module in inner {
            let _ = write!(file, "\n{module}");
        }
        file.push_str("// verilator lint_on DECLFILENAME\n");
    }
    file.push_str("\n`default_nettype wire\n");
    file
}

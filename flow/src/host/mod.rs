//! Code for the host of a block: what computes span packets and register writes, in C99 and in
//! Python, made for that very core.
//!
//! A method's set-up is a program (`templates/methods`), written once for both languages. Of it the
//! code has what the core's packets and registers depend on, and no more (decision 0030).
mod c;
mod code;
mod example;
mod expression;
mod float_error;
mod host_values;
mod library;
mod macros;
mod method_text;
mod program;
mod python;
mod text;

pub use c::header as c_header;
pub use code::{HostCode, Place, SentInput, SentPart};
pub use example::{ExampleSpan, c_frame, c_span};
pub use float_error::float_error;
pub use host_values::host_value;
pub use program::{Given, Holder, Kind, Number, Part, Source};

use crate::stream::File;

/// The host code of a block: a header for C, a module for Python, and an example of each. The
/// module is called as the block is, since a core may have the name of a keyword or of another module.
pub fn files(code: &HostCode, example: &ExampleSpan) -> Vec<File> {
    let name = code.core.name();
    let file = |suffix: &str, text: String| File { name: format!("{name}{suffix}"), text };
    vec![
        file(".h", c::header(code)),
        file("_ip.py", python::module(code)),
        file("_host.c", example::c_program(code, example)),
        file("_host.py", example::python_program(code, example)),
    ]
}

//! Verilog-2001 that people want to own: one module per distinct unit, named after it, with formats and latencies in comments.
mod library;
mod module;
pub mod statement;
mod unread;

use std::fmt::Write;

use crate::block::Module;

pub use library::{Library, Printed};

/// What the file says of itself, one line each, without comment marks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Header {
    /// The lines.
    pub lines: Vec<String>,
}

/// Prints a design as one Verilog file, the core first and then its units. The same design and header give the same bytes.
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

/// Names of every module's control ports.
pub const CONTROL: [&str; 2] = ["clock", "reset"];

/// Words, in order, that Verilog-2001 (and SystemVerilog, which many tools read it as) keeps for itself, as far as a scene's name could be one.
const RESERVED: &[&str] = &[
    "alias",
    "always",
    "and",
    "assert",
    "assign",
    "assume",
    "automatic",
    "begin",
    "bind",
    "bit",
    "break",
    "buf",
    "byte",
    "case",
    "casex",
    "casez",
    "cell",
    "checker",
    "class",
    "clocking",
    "cmos",
    "config",
    "const",
    "constraint",
    "context",
    "continue",
    "cover",
    "cross",
    "deassign",
    "default",
    "defparam",
    "design",
    "disable",
    "dist",
    "do",
    "edge",
    "else",
    "end",
    "endcase",
    "endmodule",
    "enum",
    "event",
    "expect",
    "export",
    "extends",
    "extern",
    "final",
    "for",
    "force",
    "foreach",
    "forever",
    "fork",
    "function",
    "generate",
    "genvar",
    "global",
    "highz0",
    "highz1",
    "if",
    "iff",
    "ifnone",
    "implements",
    "implies",
    "import",
    "incdir",
    "include",
    "initial",
    "inout",
    "input",
    "inside",
    "instance",
    "int",
    "integer",
    "interface",
    "intersect",
    "join",
    "large",
    "let",
    "liblist",
    "library",
    "local",
    "localparam",
    "logic",
    "longint",
    "macromodule",
    "matches",
    "medium",
    "modport",
    "module",
    "nand",
    "negedge",
    "nettype",
    "new",
    "nexttime",
    "nmos",
    "nor",
    "noshowcancelled",
    "not",
    "notif0",
    "notif1",
    "null",
    "or",
    "output",
    "package",
    "packed",
    "parameter",
    "pmos",
    "posedge",
    "primitive",
    "priority",
    "program",
    "property",
    "protected",
    "pull0",
    "pull1",
    "pulldown",
    "pullup",
    "pure",
    "rand",
    "randc",
    "rcmos",
    "real",
    "realtime",
    "ref",
    "reg",
    "reject_on",
    "release",
    "repeat",
    "restrict",
    "return",
    "rnmos",
    "rpmos",
    "rtran",
    "scalared",
    "sequence",
    "shortint",
    "shortreal",
    "signed",
    "small",
    "soft",
    "solve",
    "specify",
    "static",
    "string",
    "strong",
    "strong0",
    "strong1",
    "struct",
    "super",
    "supply0",
    "supply1",
    "table",
    "tagged",
    "task",
    "this",
    "throughout",
    "time",
    "timeprecision",
    "timeunit",
    "tran",
    "tri",
    "tri0",
    "tri1",
    "triand",
    "trior",
    "trireg",
    "type",
    "typedef",
    "union",
    "unique",
    "unsigned",
    "until",
    "untyped",
    "use",
    "uwire",
    "var",
    "vectored",
    "virtual",
    "void",
    "wait",
    "wand",
    "weak",
    "weak0",
    "weak1",
    "while",
    "wildcard",
    "wire",
    "with",
    "within",
    "wor",
    "xnor",
    "xor",
];

/// Whether Verilog, or SystemVerilog, keeps the word for itself.
pub fn is_reserved(word: &str) -> bool {
    RESERVED.binary_search(&word).is_ok()
}

/// A legal module name from a scene's name: itself, or with `_core` behind it where Verilog keeps the word.
pub fn module_name(scene: &str) -> String {
    let legal = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' };
    let mut name: String = scene.chars().map(legal).collect();
    if !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        name.insert_str(0, "scene_");
    }
    if is_reserved(&name) || CONTROL.contains(&name.as_str()) {
        name.push_str("_core");
    }
    name
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reserved_words_are_in_order() {
        assert!(RESERVED.is_sorted());
        assert!(["bit", "always", "xor"].iter().all(|word| is_reserved(word)));
    }

    #[test]
    fn module_names_are_legal() {
        let names = ["teapot", "reg", "7up", "Stanford Bunny", "", "ünder"].map(module_name);
        assert_eq!(names, ["teapot", "reg_core", "scene_7up", "stanford_bunny", "scene_", "scene__nder"]);
    }
}

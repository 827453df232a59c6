//! The definitions at the head of a file, and the codes that stand for its variables.
use std::fmt::Write;

use specula_hdl::Design;
use specula_hdl::design::{NodeId, ScopeId};

use super::record::{Record, code};
use crate::outline::{Entry, outline};

/// The definitions of a file.
pub struct Header {
    /// Their text.
    pub text: String,
    /// The clock.
    pub clock: Record,
    /// Reset.
    pub reset: Record,
    /// The columns that are written, and how.
    pub variables: Vec<(usize, Record)>,
}

impl Header {
    /// The definitions for `nodes`.
    pub fn new(design: &Design, nodes: &[NodeId], about: &str) -> Header {
        let [clock, reset] = [0, 1].map(code);
        let mut codes = (2..).map(code);
        // A comment ends where the file says `$end`.
        let about = about.replace('$', "_");
        let mut header = Header {
            text: format!("$comment {about} $end\n$timescale 1 ns $end\n"),
            clock: Record::new(1, &clock),
            reset: Record::new(1, &reset),
            variables: vec![],
        };
        header.line(format_args!("$scope module {} $end", design.scope(ScopeId::TOP).instance));
        header.line(format_args!("$var wire 1 {clock} clock $end"));
        header.line(format_args!("$var wire 1 {reset} reset $end"));
        for entry in outline(design, nodes) {
            match entry {
                Entry::Unit(scope) => header.line(format_args!("$scope module {} $end", scope.instance)),
                Entry::Signal(column, node) => {
                    let width = node.width();
                    let bounds = if width > 1 { format!(" [{}:0]", width - 1) } else { String::new() };
                    // Codes do not come to an end before numbers of signals do.
                    let code = codes.next().unwrap_or_default();
                    header.line(format_args!("$var wire {width} {code} {}{bounds} $end", node.name));
                    header.variables.push((column, Record::new(width, &code)));
                }
                Entry::End => header.line(format_args!("$upscope $end")),
            }
        }
        header.line(format_args!("$enddefinitions $end"));
        header
    }

    fn line(&mut self, line: std::fmt::Arguments) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.text, "{line}");
    }
}

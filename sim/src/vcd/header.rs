//! The definitions at the head of a file, and the codes that stand for its variables.
use std::fmt::Write;

use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, ScopeId};

use super::record::{Record, code};
use crate::outline::{Entry, Outline};

/// The definitions of a file.
pub struct Header {
    /// Their text.
    pub text: String,
    /// The clock.
    pub clock: Record,
    /// Reset.
    pub reset: Record,
    /// The variables for which there are columns.
    pub variables: Vec<Variable>,
}

/// A variable of a file.
#[derive(Clone, Copy, Debug)]
pub struct Variable {
    /// The column of its values.
    pub column: usize,
    /// How its lines are made.
    pub record: Record,
    /// Its value at the clock before.
    pub last: i64,
}

const CLOCK: usize = 0;
const RESET: usize = 1;
/// Number of the first code that is a signal's.
const FIRST: usize = 2;

impl Header {
    /// The definitions for `nodes`.
    pub fn new(design: &Design, nodes: &[NodeId], about: &str) -> Header {
        let Outline { entries, variables } = Outline::new(design, nodes);
        let variable = |(number, variable): (usize, &crate::outline::Variable)| Variable {
            column: variable.column,
            record: Record::new(variable.width, &code(FIRST + number)),
            last: 0,
        };
        Header {
            text: text(&design.scope(ScopeId::TOP).instance, &entries, about),
            clock: Record::new(1, &code(CLOCK)),
            reset: Record::new(1, &code(RESET)),
            variables: variables.iter().enumerate().map(variable).collect(),
        }
    }
}

fn text(core: &str, entries: &[Entry], about: &str) -> String {
    // A comment ends where the file says `$end`.
    let mut text = format!(
        "$comment {} $end\n$timescale 1 ns $end\n$scope module {core} $end\n",
        about.replace('$', "_")
    );
    for (name, number) in [("clock", CLOCK), ("reset", RESET)] {
        line(&mut text, format_args!("$var wire 1 {} {name} $end", code(number)));
    }
    for entry in entries {
        match entry {
            Entry::Unit(scope) => {
                line(&mut text, format_args!("$scope module {} $end", scope.instance))
            }
            Entry::Signal(node, variable) => signal(&mut text, node, &code(FIRST + variable)),
            Entry::End => line(&mut text, format_args!("$upscope $end")),
        }
    }
    line(&mut text, format_args!("$enddefinitions $end"));
    text
}

fn signal(text: &mut String, node: &Node, code: &str) {
    let width = node.width();
    let bounds = if width > 1 { format!(" [{}:0]", width - 1) } else { String::new() };
    line(text, format_args!("$var wire {width} {code} {}{bounds} $end", node.name));
}

fn line(text: &mut String, line: std::fmt::Arguments) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{line}");
}

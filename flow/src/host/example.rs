//! Programs that make the first packet of a block's vectors, as examples of how host code is used.
use specula_scene::frame::{Frame, Span};

use super::code::HostCode;
use super::host_values::host_value;
use super::program::{Holder, Kind, Source};
use crate::stream::template::Values;

/// The span that examples are made of.
pub struct ExampleSpan<'a> {
    /// Its frame.
    pub frame: &'a Frame,
    /// The span.
    pub span: &'a Span,
    /// Whether it is the last one among the vectors.
    pub is_last: bool,
}

/// A program in C.
pub fn c_program(code: &HostCode, example: &ExampleSpan) -> String {
    let mut values = values(code, example, &C);
    values.set("FRAME", c_frame(code, example).trim_end());
    values.set("SPAN", c_span(code, example).trim_end());
    values.fill(include_str!("templates/example.c"))
}

/// The fields of a frame's struct in C, with their values.
pub fn c_frame(code: &HostCode, example: &ExampleSpan) -> String {
    values(code, example, &C).fill(include_str!("templates/frame.c"))
}

/// The fields of a span's struct in C, with their values, without its material.
pub fn c_span(code: &HostCode, example: &ExampleSpan) -> String {
    values(code, example, &C).fill(include_str!("templates/span.c"))
}

/// A program in Python.
pub fn python_program(code: &HostCode, example: &ExampleSpan) -> String {
    values(code, example, &PYTHON).fill(include_str!("templates/example.py"))
}

/// How a language writes the fields of a struct.
struct Language {
    indent: &'static str,
    before: &'static str,
    brackets: [&'static str; 2],
    /// What the value of one span is put into.
    of_spans: [&'static str; 2],
    booleans: [&'static str; 2],
    frame_argument: &'static str,
}

const C: Language = Language {
    indent: "      ",
    before: ".",
    brackets: ["{", "}"],
    of_spans: ["", ""],
    booleans: ["false", "true"],
    frame_argument: "&frame, ",
};

const PYTHON: Language = Language {
    indent: "    ",
    before: "",
    brackets: ["[", "]"],
    of_spans: ["[", "]"],
    booleans: ["[False]", "[True]"],
    frame_argument: "frame, ",
};

fn values(code: &HostCode, example: &ExampleSpan, language: &Language) -> Values {
    let mut values = code.values();
    values.set("SPAN_VALUES", fields(code, example, language, Holder::Span));
    values.set("FRAME_VALUES", fields(code, example, language, Holder::Frame));
    values.set("MATERIAL_VALUES", fields(code, example, language, Holder::Material));
    values.set("DIGITS", code.core.word.bits() / 4);
    let has_registers = !code.registers.inputs.is_empty();
    values.set("REGISTERS_TOO", if has_registers { ", and its frame's registers" } else { "" });
    let needs_frame = code.packets_need_the_frame();
    values.set("FRAME_ARGUMENT", if needs_frame { language.frame_argument } else { "" });
    values.set("PIXELS", example.span.length);
    values.set("X", example.span.x);
    values.set("Y", example.span.y);
    values.set("LAST", language.booleans[usize::from(example.is_last)]);
    values
}

/// The fields of a struct with their values, a line each.
fn fields(code: &HostCode, example: &ExampleSpan, language: &Language, holder: Holder) -> String {
    let field = |source: &&Source| {
        // Tests ask for every value of every method.
        let numbers = host_value(code.core.spec, example.frame, example.span, source)
            .expect("a frame has what host code asks for");
        let is_whole = source.kind == Kind::Whole;
        let number = |value: &f64| if is_whole { format!("{value}") } else { format!("{value:?}") };
        let all = numbers.iter().map(number).collect::<Vec<_>>().join(", ");
        let [open, close] = language.brackets;
        let value = if numbers.len() > 1 { format!("{open}{all}{close}") } else { all };
        let [open, close] = if code.is_of_spans(holder) { language.of_spans } else { ["", ""] };
        let (indent, before, name) = (language.indent, language.before, &source.name);
        let equals = if before.is_empty() { "=" } else { " = " };
        format!("{indent}{before}{name}{equals}{open}{value}{close},")
    };
    code.fields(holder).iter().map(field).collect::<Vec<_>>().join("\n")
}

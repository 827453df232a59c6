//! Host code in Python.
use std::fmt::Write;

use super::code::{HostCode, Place, SentInput, SentPart, ones};
use super::expression::{Token, tokens};
use super::library::Library;
use super::program::{Definition, Given, Holder, Kind, Number, Source};
use super::text::{commented, joined};

/// The module with everything that a host needs.
pub fn module(code: &HostCode) -> String {
    let mut values = code.values();
    let named = |text: &str| named(code, text);
    values.set("SPAN_FIELDS", fields(code, Holder::Span));
    values.set("FRAME_FIELDS", fields(code, Holder::Frame));
    values.set("MATERIAL_FIELDS", fields(code, Holder::Material));
    let of =
        |sent: &SentPart, last: String| named(&joined([loads(code, sent), statements(sent), last]));
    values.set("PACKET_BODY", of(&code.packet, puts(code)));
    values.set("REGISTERS_BODY", of(&code.registers, writes(code)));
    let functions = code.functions(&Library::python(), statements);
    values.set("FUNCTIONS", named(&functions.join("\n")));
    values.fill(include_str!("templates/module.py"))
}

/// A text with the names that functions have: those for the host alone without `_`.
fn named(code: &HostCode, text: &str) -> String {
    let piece = |token: Token| match token {
        Token::Function(name) if code.public_functions().contains(&name) => name.to_owned(),
        Token::Function(name) => format!("_{name}"),
        Token::Name(text) | Token::Literal(text) | Token::Other(text) => text.to_owned(),
    };
    tokens(text).into_iter().map(piece).collect()
}

fn fields(code: &HostCode, holder: Holder) -> String {
    let of_spans = code.is_of_spans(holder);
    let field = |source: &&Source| {
        let is_number = matches!(source.kind, Kind::Real | Kind::Whole | Kind::Steps);
        let kind = if is_number && !of_spans { "float" } else { "np.ndarray" };
        let comment = commented(&source.about, "    # ", "    # ", "");
        format!("{comment}\n    {}: {kind}", source.name)
    };
    code.fields(holder).iter().map(field).collect::<Vec<_>>().join("\n")
}

/// Statements that take values out of objects. What a frame has is the same for all spans.
fn loads(code: &HostCode, sent: &SentPart) -> String {
    let load = |source: &Source| {
        let (local, name) = (source.local(), &source.name);
        let of_spans = code.is_of_spans(source.holder);
        let holder = match source.holder {
            Holder::Span => "spans",
            Holder::Frame => "frame",
            Holder::Material if of_spans => "spans.material",
            Holder::Material => "frame.material",
        };
        let value = match (source.kind, of_spans) {
            (Kind::Steps, _) => "pixels.astype(float) - 1".to_owned(),
            (Kind::Vector | Kind::Colour, true) => format!("_components({holder}.{name})"),
            (Kind::Vector | Kind::Colour, false) => {
                format!("_components({holder}.{name}).reshape(3, 1)")
            }
            (Kind::Real | Kind::Whole, true) => format!("np.asarray({holder}.{name}, float)"),
            (Kind::Real | Kind::Whole, false) => format!("np.full(1, float({holder}.{name}))"),
        };
        format!("        {local} = {value}\n")
    };
    sent.part.sources.iter().map(load).collect()
}

fn statements(sent: &SentPart) -> String {
    let mut text = String::new();
    for statement in &sent.part.statements {
        if let Definition::Vector(value) | Definition::Real(value) = &statement.definition {
            // Writing to a String cannot fail, here and below.
            let _ = writeln!(text, "        {} = {value}", statement.name);
        }
    }
    text
}

fn raw(input: &SentInput) -> String {
    let (scale, (low, high)) = (ones(input.port.format), input.port.range);
    let number = |Number { name, component }: &Number| match component {
        None => name.clone(),
        Some(axis) => format!("{name}[{axis}]"),
    };
    match &input.given {
        Given::Rounded(value) => format!("@raw({}, {scale}, {low}, {high})", number(value)),
        Given::Difference { from, to } => {
            let (from, to) = (number(from), number(to));
            format!("@raw_difference({from}, {to}, {scale}, {low}, {high})")
        }
    }
}

/// Statements that put the words of packets together.
fn puts(code: &HostCode) -> String {
    let mut text = String::new();
    for input in &code.packet.inputs {
        let Place::Packet { first_bit, bits } = input.place else { continue };
        let _ = writeln!(text, "        # {}, {}", input.port.name, input.port.format);
        let _ = writeln!(text, "        @put(words, {}, {first_bit}, {bits})", raw(input));
    }
    if text.is_empty() { "        pass\n".to_owned() } else { text }
}

/// Statements that list the register writes of a frame.
fn writes(code: &HostCode) -> String {
    let mut text = String::new();
    for input in &code.registers.inputs {
        let Place::Registers(register) = &input.place else { continue };
        let _ = writeln!(text, "        # {}, {}", input.port.name, input.port.format);
        let _ = writeln!(text, "        raw = int({}[0])", raw(input));
        for (part, (address, _)) in register.words(0).into_iter().enumerate() {
            let value = if part == 0 { "raw" } else { "raw >> 32" };
            let word = format!("{value} & 0xffffffff");
            let _ = writeln!(text, "        writes.append((0x{address:03x}, {word}))");
        }
    }
    text
}

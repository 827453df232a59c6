//! Host code in C.
use std::fmt::Write;

use specula_spec::built_format;

use super::code::{HostCode, Place, SentInput, SentPart, ones, shifts};
use super::expression::{Token, tokens};
use super::float_error::float_error;
use super::library::Library;
use super::program::{Definition, Given, Holder, Kind, Number, Source};
use super::text::{commented, joined};

/// Functions of `<math.h>` that functions of the library call.
const OF_MATH_H: [&str; 7] = ["sqrt", "acos", "atan2", "sin", "cos", "pow", "copysign"];

/// The header with everything that a host needs.
pub fn header(code: &HostCode) -> String {
    let mut values = code.values();
    let name = code.core.name();
    values.set("SPAN_FIELDS", named(&fields(code, Holder::Span), name));
    values.set("FRAME_FIELDS", named(&fields(code, Holder::Frame), name));
    values.set("MATERIAL_FIELDS", named(&fields(code, Holder::Material), name));
    let packet = joined([loads(code, &code.packet), statements(&code.packet), packet_words(code)]);
    values.set("PACKET_BODY", named(&packet, name));
    let registers =
        joined([loads(code, &code.registers), statements(&code.registers), writes(code)]);
    values.set("REGISTERS_BODY", named(&registers, name));
    values.set("FUNCTIONS", named(&functions(code).join("\n"), name));
    let math: Vec<&str> = math(code);
    values.flag("math", !math.is_empty());
    values.set("MATH", math.join(", "));
    values.flag("float", code.has_float());
    values.fill(include_str!("templates/host.h"))
}

/// A text with the functions and types of the core's own names.
fn named(text: &str, name: &str) -> String {
    let piece = |token: Token| match token {
        Token::Function(function) => format!("{name}_{function}"),
        Token::Name(text) | Token::Literal(text) | Token::Other(text) => text.to_owned(),
    };
    tokens(text).into_iter().map(piece).collect()
}

/// The fields of a struct.
fn fields(code: &HostCode, holder: Holder) -> String {
    let field = |source: &&Source| {
        let declaration = match source.kind {
            Kind::Vector | Kind::Colour => format!("@real {}[3];", source.name),
            Kind::Real => format!("@real {};", source.name),
            Kind::Whole | Kind::Steps => format!("uint32_t {};", source.name),
        };
        format!("{}\n  {declaration}", commented(&source.about, "  /* ", "     ", " */"))
    };
    code.fields(holder).iter().map(field).collect::<Vec<_>>().join("\n")
}

/// The functions that the code calls, and those that a host needs besides.
fn functions(code: &HostCode) -> Vec<&'static str> {
    code.functions(&Library::c(), |sent| loads(code, sent) + &statements(sent))
}

/// The functions of `<math.h>` that the code calls.
fn math(code: &HostCode) -> Vec<&'static str> {
    let functions = functions(code);
    let calls = |name: &&&str| {
        functions.iter().any(|text| {
            let called = tokens(text);
            called.windows(2).any(|pair| match pair {
                [Token::Name(function), Token::Other(bracket)] => {
                    *function == **name && bracket.starts_with('(')
                }
                _ => false,
            })
        })
    };
    OF_MATH_H.iter().filter(calls).copied().collect()
}

/// Statements that take values out of structs.
fn loads(code: &HostCode, sent: &SentPart) -> String {
    let load = |source: &Source| {
        let (local, name) = (source.local(), &source.name);
        let holder = match source.holder {
            Holder::Span => "span->",
            Holder::Frame => "frame->",
            Holder::Material if code.materials_are_of_spans() => "span->material->",
            Holder::Material => "frame->material.",
        };
        match source.kind {
            Kind::Vector => format!("  const struct @vector {local} = @load({holder}{name});\n"),
            Kind::Colour => format!("  const @real *const {local} = {holder}{name};\n"),
            Kind::Real => format!("  const @real {local} = {holder}{name};\n"),
            Kind::Whole => format!("  const @real {local} = (@real){holder}{name};\n"),
            Kind::Steps => "  const @real steps = (@real)(span->pixels - 1);\n".to_owned(),
        }
    };
    sent.part.sources.iter().map(load).collect()
}

fn statements(sent: &SentPart) -> String {
    let mut text = String::new();
    for statement in &sent.part.statements {
        let name = &statement.name;
        // Writing to a String cannot fail, here and below.
        let _ = match &statement.definition {
            Definition::Vector(value) => {
                writeln!(text, "  const struct @vector {name} = {};", expression(value))
            }
            Definition::Real(value) => {
                writeln!(text, "  const @real {name} = {};", expression(value))
            }
            Definition::Difference { .. } => Ok(()),
        };
    }
    text
}

/// An expression whose numbers are of the core's type.
fn expression(text: &str) -> String {
    let piece = |token: Token| match token {
        Token::Function(function) => format!("@{function}"),
        Token::Literal(number) if number.contains('.') => format!("(@real){number}"),
        Token::Name(text) | Token::Literal(text) | Token::Other(text) => text.to_owned(),
    };
    tokens(text).into_iter().map(piece).collect()
}

/// The raw value of an input.
fn raw(input: &SentInput) -> String {
    let (scale, (low, high)) = (ones(input.port.format), input.port.range);
    let number = |Number { name, component }: &Number| match component {
        None => name.clone(),
        Some(axis) => format!("{name}.{}", ["x", "y", "z"][*axis]),
    };
    match &input.given {
        Given::Rounded(value) => {
            let value = number(value);
            format!("@raw({value}, {scale}LL, {low}LL, {high}LL)")
        }
        Given::Difference { from, to } => {
            let (from, to) = (number(from), number(to));
            format!("@raw_difference({from}, {to}, {scale}LL, {low}LL, {high}LL)")
        }
    }
}

/// Statements that put the words of a packet together.
fn packet_words(code: &HostCode) -> String {
    let (words, word) = (code.core.words(), code.core.word.bits());
    let header = if word == 32 { 1 } else { 0 };
    let mut text = "  uint64_t bits;\n".to_owned();
    for number in 0..words {
        let value = match number {
            0 => "(uint64_t)(span->pixels & 0xffffu) | (uint64_t)span->last << 16",
            _ => "0",
        };
        let _ = writeln!(text, "  uint64_t word{number} = {value};");
    }
    if code.has_positions() {
        text.push_str(
            "  bits = (uint64_t)(span->x & 0xffffu) | (uint64_t)(span->y & 0xffffu) << 16;\n",
        );
        let shift = if header == 1 { "" } else { " << 32" };
        let _ = writeln!(text, "  word{header} |= bits{shift};");
    }
    for input in &code.packet.inputs {
        let Place::Packet { first_bit, bits } = input.place else { continue };
        let mask = u64::MAX >> (u64::BITS - bits);
        let (name, format) = (&input.port.name, built_format(&input.port));
        let from = format!("{bits} bits from {first_bit} on");
        let _ = writeln!(text, "  /* {name}, {format}: {from}{} */", float(code, input));
        let _ = writeln!(text, "  bits = (uint64_t){} & 0x{mask:x}u;", raw(input));
        for (number, shift) in shifts(first_bit, bits, word) {
            let shifted = match shift {
                0 => "bits".to_owned(),
                1.. => format!("bits << {shift}"),
                _ => format!("bits >> {}", -shift),
            };
            let _ = writeln!(text, "  word{number} |= {shifted};");
        }
    }
    for number in 0..words {
        let _ = writeln!(text, "  words[{number}] = (uint{word}_t)word{number};");
    }
    text
}

/// By how much an input is off in float.
fn float(code: &HostCode, input: &SentInput) -> String {
    let error = float_error(input);
    if code.has_float() { format!("; in float {error} off at most") } else { String::new() }
}

/// Statements that list the register writes of a frame.
fn writes(code: &HostCode) -> String {
    if code.registers.inputs.is_empty() {
        return String::new();
    }
    let mut text = "  int64_t raw;\n".to_owned();
    let mut place = 0;
    for input in &code.registers.inputs {
        let Place::Registers(register) = &input.place else { continue };
        let (name, format) = (&input.port.name, input.port.format);
        let _ = writeln!(text, "  /* {name}, {format}{} */", float(code, input));
        let _ = writeln!(text, "  raw = {};", raw(input));
        for (part, (address, _)) in register.words(0).into_iter().enumerate() {
            let value = if part == 0 { "raw" } else { "(raw >> 32)" };
            let _ = writeln!(text, "  writes[{place}].address = 0x{address:03x}u;");
            let _ = writeln!(text, "  writes[{place}].word = (uint32_t){value};");
            place += 1;
        }
    }
    text
}

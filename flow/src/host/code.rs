//! What the host code of a core is made of, in whatever language.
use specula_spec::gouraud::Highlight;
use specula_spec::lyon::Normals;
use specula_spec::{FieldContent, Format, InputPort, MethodSpec, Positions, consistent};

use super::library::Library;
use super::method_text::program;
use super::program::{Given, Holder, Kind, Part, Source};
use crate::stream::template::Values;
use crate::stream::{FrameInput, HostCall, StreamCore};

/// Where the raw value of an input goes.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// Into bits of a packet, from this one on, so many.
    Packet {
        /// The lowest of them.
        first_bit: u32,
        /// How many there are.
        bits: u32,
    },
    /// Into registers.
    Registers(FrameInput),
}

/// An input that a host sends.
#[derive(Clone, Debug, PartialEq)]
pub struct SentInput {
    /// Its port, with the range that is left.
    pub port: InputPort,
    /// What it is given.
    pub given: Given,
    /// Where it goes.
    pub place: Place,
}

/// A part of the program with where its inputs go.
#[derive(Clone, Debug, PartialEq)]
pub struct SentPart {
    /// What the inputs depend on.
    pub part: Part,
    /// The inputs, in order.
    pub inputs: Vec<SentInput>,
}

/// The host code of a core.
pub struct HostCode<'a> {
    /// The core.
    pub core: &'a StreamCore<'a>,
    /// The packet of a span.
    pub packet: SentPart,
    /// The registers of a frame.
    pub registers: SentPart,
}

impl<'a> HostCode<'a> {
    /// The host code of a core.
    pub fn new(core: &'a StreamCore<'a>) -> HostCode<'a> {
        let program = program(core.spec);
        let ports = core.spec.inputs();
        let sent = |places: Vec<(usize, Place)>| {
            let names: Vec<&str> =
                places.iter().map(|(number, _)| ports[*number].name.as_str()).collect();
            // Tests look at every option of every method, with lights and eye at places, too.
            let part = program.part(&names).expect("there is a statement for every input");
            let input = |((number, place), given): ((usize, Place), &Given)| SentInput {
                port: ports[number].clone(),
                given: given.clone(),
                place,
            };
            let inputs = places.into_iter().zip(&part.given).map(input).collect();
            SentPart { part, inputs }
        };
        let fields = core.layout.fields.iter().filter_map(|field| match field.content {
            FieldContent::Input(number) => {
                let (first_bit, bits) = (field.first_bit, field.format.width());
                Some((number, Place::Packet { first_bit, bits }))
            }
            _ => None,
        });
        let registers = core.frame_inputs();
        let registers = registers.into_iter().map(|input| (input.number, Place::Registers(input)));
        HostCode { core, packet: sent(fields.collect()), registers: sent(registers.collect()) }
    }

    /// Whether pixels have a position.
    pub fn has_positions(&self) -> bool {
        self.core.layout.positions == Positions::Sent
    }

    /// The values that a struct of the host has, without those of a material within.
    pub fn fields(&self, holder: Holder) -> Vec<&Source> {
        let mut fields: Vec<&Source> = vec![];
        for source in self.packet.part.sources.iter().chain(&self.registers.part.sources) {
            let is_field = source.kind != Kind::Steps && source.holder == holder;
            if is_field && !fields.iter().any(|field| field.name == source.name) {
                fields.push(source);
            }
        }
        fields
    }

    /// The values that a frame has, its material's last.
    pub fn frame_sources(&self) -> Vec<&Source> {
        let mut sources = self.fields(Holder::Frame);
        if !self.materials_are_of_spans() {
            sources.extend(self.fields(Holder::Material));
        }
        sources
    }

    /// The values that a span has, its material's last.
    pub fn span_sources(&self) -> Vec<&Source> {
        let mut sources = self.fields(Holder::Span);
        if self.materials_are_of_spans() {
            sources.extend(self.fields(Holder::Material));
        }
        sources
    }

    /// Whether it depends on a material.
    pub fn has_material(&self) -> bool {
        !self.fields(Holder::Material).is_empty()
    }

    /// Whether what this has may differ from span to span.
    pub fn is_of_spans(&self, holder: Holder) -> bool {
        match holder {
            Holder::Span => true,
            Holder::Material => self.materials_are_of_spans(),
            Holder::Frame => false,
        }
    }

    /// Whether spans have a material each; if not, frames have one.
    pub fn materials_are_of_spans(&self) -> bool {
        self.core.spec.parameters.several_materials
    }

    /// Whether there is anything that a frame has.
    pub fn has_frame(&self) -> bool {
        let has_material = self.has_material() && !self.materials_are_of_spans();
        has_material || !self.fields(Holder::Frame).is_empty()
    }

    /// Whether packets depend on what a frame has.
    pub fn packets_need_the_frame(&self) -> bool {
        let needs = |source: &Source| !self.is_of_spans(source.holder);
        self.packet.part.sources.iter().any(needs)
    }

    /// How it is called.
    pub fn call(&self) -> HostCall {
        HostCall {
            has_frame: self.has_frame(),
            packets_need_the_frame: self.packets_need_the_frame(),
        }
    }

    /// Whether it may be computed with float: not where directions are made of nearly equal
    /// vectors, or a choice made for the whole span.
    pub fn has_float(&self) -> bool {
        match &self.core.spec.method {
            MethodSpec::Slerp(_) => false,
            MethodSpec::Lyon(lyon) => lyon.normals != Normals::Wrapped,
            _ => true,
        }
    }

    /// Register writes of a frame.
    pub fn writes(&self) -> usize {
        let words = |input: &SentInput| match &input.place {
            Place::Packet { .. } => 0,
            Place::Registers(register) => register.words(0).len(),
        };
        self.registers.inputs.iter().map(words).sum()
    }

    /// The functions of a library that the code calls, whose parts in that language `text` gives, and
    /// those that a host needs besides.
    pub fn functions(
        &self,
        library: &Library,
        text: impl Fn(&SentPart) -> String,
    ) -> Vec<&'static str> {
        let public = self.public_functions().iter().map(|name| format!("@{name}"));
        let texts: Vec<String> =
            [&self.packet, &self.registers].into_iter().map(text).chain(public).collect();
        library.called(texts.iter().map(String::as_str))
    }

    /// What templates of either language ask for.
    pub fn values(&self) -> Values {
        let mut values = Values::default();
        let core = self.core;
        values.set("NAME", core.name());
        values.set("UPPER", core.name().to_uppercase());
        values.set("VERSION", env!("CARGO_PKG_VERSION"));
        values.set("WORDS", core.words());
        values.set("WORD", core.word.bits());
        values.set("LONGEST", core.spec.parameters.longest_span);
        values.set("WRITES", self.writes());
        values.flag("positions", self.has_positions());
        values.flag("frame", self.has_frame());
        values.flag("packet_frame", self.packets_need_the_frame());
        values.flag("registers", !self.registers.inputs.is_empty());
        values.flag("material", self.has_material());
        let of_spans = self.has_material() && self.materials_are_of_spans();
        values.flag("span_material", of_spans);
        values.flag("frame_material", self.has_material() && !of_spans);
        let differs = |input: &SentInput| matches!(input.given, Given::Difference { .. });
        values.flag("difference", self.packet.inputs.iter().any(differs));
        values
    }

    /// Functions that a host needs besides, for what it interpolates.
    pub fn public_functions(&self) -> &'static [&'static str] {
        match &self.core.spec.method {
            MethodSpec::Hybrid(_) => &["interpolated", "lambert"],
            MethodSpec::Gouraud(spec) => match spec.highlight {
                Highlight::Power => &["interpolated", "lambert", "highlight"],
                Highlight::FK => &["interpolated", "lambert", "lobe"],
            },
            MethodSpec::Consistent(spec) => match spec.curve {
                consistent::Curve::Rational => &["interpolated", "rational_angle"],
                consistent::Curve::Trigonometric => &["interpolated", "trigonometric_angle"],
            },
            _ => &["interpolated"],
        }
    }
}

/// Where some bits of a packet stand: words, and how far to the left the bits go in each.
pub fn shifts(first_bit: u32, bits: u32, word_bits: u32) -> Vec<(u32, i64)> {
    let words = first_bit / word_bits..=(first_bit + bits - 1) / word_bits;
    words.map(|word| (word, i64::from(first_bit) - i64::from(word * word_bits))).collect()
}

/// What a value is multiplied by to be a raw value of a format.
pub fn ones(format: Format) -> i64 {
    1 << format.fraction_bits
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_go_into_every_word_that_they_cross() {
        assert_eq!(shifts(64, 16, 32), [(2, 0)]);
        assert_eq!(shifts(80, 17, 32), [(2, 16), (3, -16)]);
        assert_eq!(shifts(31, 34, 32), [(0, 31), (1, -1), (2, -33)]);
        assert_eq!(shifts(31, 33, 64), [(0, 31)]);
    }
}

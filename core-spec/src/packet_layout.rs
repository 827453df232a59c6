//! The span packet: the words that a host sends a core for a span, laid out once for the stream
//! top, host code, vectors and their documentation.
//!
//! A packet is a string of bits, bit 0 first: a header, the position of the first pixel where
//! pixels are to have one, and the inputs that hold for a span, in port order, each exactly the bits of
//! its format, in two's complement where that is signed, without gaps. It is cut into words, the
//! lowest bits first; what is left of the last word is 0. Inputs that hold for a frame are no part
//! of it: they are registers.
use specula_datapath::design::{Range, format_of};
use specula_datapath::{Format, Hold, InputPort};

use crate::core_spec::CoreSpec;

/// Width of a stream's words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WordWidth {
    /// 32 bits.
    Bits32,
    /// 64 bits.
    Bits64,
}

impl WordWidth {
    /// Every width.
    pub const ALL: [WordWidth; 2] = [WordWidth::Bits32, WordWidth::Bits64];

    /// Its bits.
    pub const fn bits(self) -> u32 {
        match self {
            WordWidth::Bits32 => 32,
            WordWidth::Bits64 => 64,
        }
    }
}

/// Whether packets and pixels have a position in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Positions {
    /// They have none.
    Absent,
    /// Packets have that of their first pixel, and every pixel has its own.
    Sent,
}

/// What a packet says of its span besides the core's inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SpanHeader {
    /// Pixels of the span, from 1 to the core's longest span.
    pub pixels: u32,
    /// Whether it is the last span of its frame.
    pub last: bool,
    /// Column and row of the first pixel, 0 to 65535; sent where packets have a position.
    pub position: [u32; 2],
}

/// What stands in a field of a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldContent {
    /// Pixels of the span.
    Pixels,
    /// 1 in the last span of a frame.
    Last,
    /// Nothing: 0.
    Zero,
    /// Column of the first pixel.
    X,
    /// Row of the first pixel.
    Y,
    /// The input of this number in [`CoreSpec::inputs`].
    Input(usize),
}

/// Some bits of a packet that go together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PacketField {
    /// Its name; that of its port for an input.
    pub name: String,
    /// Number of its lowest bit in the packet.
    pub first_bit: u32,
    /// Its format, which says how many bits it has.
    pub format: Format,
    /// What stands in it.
    pub content: FieldContent,
}

/// Where everything stands in the packets of a core.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PacketLayout {
    /// The fields, in order and without gaps.
    pub fields: Vec<PacketField>,
    /// Bits of a packet, without those that fill its last word.
    pub bits: u32,
    /// Whether packets have a position.
    pub positions: Positions,
}

impl PacketLayout {
    /// The layout of the packets of a core.
    pub fn of(spec: &CoreSpec, positions: Positions) -> PacketLayout {
        let mut layout = PacketLayout { fields: vec![], bits: 0, positions };
        layout.append("pixels", Format::unsigned(16, 0), FieldContent::Pixels);
        layout.append("last", Format::unsigned(1, 0), FieldContent::Last);
        layout.append("zero", Format::unsigned(15, 0), FieldContent::Zero);
        if positions == Positions::Sent {
            layout.append("x", Format::unsigned(16, 0), FieldContent::X);
            layout.append("y", Format::unsigned(16, 0), FieldContent::Y);
        }
        for (number, port) in spec.built_inputs() {
            if port.hold == Hold::Span {
                layout.append(&port.name, built_format(&port), FieldContent::Input(number));
            }
        }
        layout
    }

    fn append(&mut self, name: &str, format: Format, content: FieldContent) {
        let (name, first_bit) = (name.to_owned(), self.bits);
        self.bits += format.width();
        self.fields.push(PacketField { name, first_bit, format, content });
    }

    /// Words of a packet.
    pub fn words(&self, word: WordWidth) -> u32 {
        self.bits.div_ceil(word.bits())
    }

    /// The words of a span's packet; `inputs` are the raw values of [`CoreSpec::inputs`], as the
    /// set-up gives them.
    pub fn pack(&self, header: &SpanHeader, inputs: &[i64], word: WordWidth) -> Vec<u64> {
        let mut words = vec![0; self.words(word) as usize];
        for field in &self.fields {
            let value = match field.content {
                FieldContent::Pixels => header.pixels.into(),
                FieldContent::Last => header.last.into(),
                FieldContent::Zero => 0,
                FieldContent::X => header.position[0].into(),
                FieldContent::Y => header.position[1].into(),
                FieldContent::Input(number) => inputs[number],
            };
            put(&mut words, word.bits(), field, value);
        }
        words
    }

    /// The header in the words of a packet, and the raw values of the inputs in it with their
    /// numbers: what [`PacketLayout::pack`] was given. The position is 0 where packets have none.
    pub fn unpack(&self, words: &[u64], word: WordWidth) -> (SpanHeader, Vec<(usize, i64)>) {
        let mut header = SpanHeader { pixels: 0, last: false, position: [0; 2] };
        let mut inputs = vec![];
        for field in &self.fields {
            let bits = get(words, word.bits(), field);
            match field.content {
                FieldContent::Pixels => header.pixels = bits as u32,
                FieldContent::Last => header.last = bits == 1,
                FieldContent::Zero => {}
                FieldContent::X => header.position[0] = bits as u32,
                FieldContent::Y => header.position[1] = bits as u32,
                FieldContent::Input(number) => inputs.push((number, raw_value(field.format, bits))),
            }
        }
        (header, inputs)
    }
}

/// The raw value whose lowest bits, as many as a format has, are those of `bits`.
pub fn raw_value(format: Format, bits: u64) -> i64 {
    let above = u64::BITS - format.width();
    let highest = bits << above;
    if format.signed { highest as i64 >> above } else { (highest >> above) as i64 }
}

/// Writes the bits of a field's value into words of so many bits, which are 0 there.
fn put(words: &mut [u64], word_bits: u32, field: &PacketField, value: i64) {
    let width = field.format.width();
    // The lowest bits of a negative number are its two's complement.
    let mut rest = (value as u64) & (u64::MAX >> (u64::BITS - width));
    let (mut bit, end) = (field.first_bit, field.first_bit + width);
    while bit < end {
        let (place, shift) = (bit / word_bits, bit % word_bits);
        let taken = (word_bits - shift).min(end - bit);
        let own = rest & (u64::MAX >> (u64::BITS - taken));
        words[place as usize] |= own << shift;
        rest = rest.checked_shr(taken).unwrap_or(0);
        bit += taken;
    }
}

/// The bits of a field in words of so many bits.
fn get(words: &[u64], word_bits: u32, field: &PacketField) -> u64 {
    let bit = |number: u32| {
        let at = field.first_bit + number;
        words[(at / word_bits) as usize] >> (at % word_bits) & 1
    };
    (0..field.format.width()).fold(0, |bits, number| bits | bit(number) << number)
}

/// The format of a port as it is built: as wide as what it is given asks for.
pub fn built_format(port: &InputPort) -> Format {
    format_of(Range::new(port.range.0, port.range.1), port.format.fraction_bits)
}

impl CoreSpec {
    /// Those of [`CoreSpec::inputs`] that the hardware has, with their numbers: not constants, nor
    /// what is always the same as an earlier one that it has.
    pub fn built_inputs(&self) -> Vec<(usize, InputPort)> {
        let mut built: Vec<(usize, InputPort)> = vec![];
        for (number, port) in self.inputs().into_iter().enumerate() {
            let twin = |name: &String| built.iter().any(|(_, earlier)| earlier.name == *name);
            let is_twin = port.same_as.as_ref().is_some_and(twin);
            if !is_twin && port.range.0 != port.range.1 {
                built.push((number, port));
            }
        }
        built
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn layout(widths: &[(bool, u32)]) -> PacketLayout {
        let mut layout = PacketLayout { fields: vec![], bits: 0, positions: Positions::Absent };
        for (number, &(signed, width)) in widths.iter().enumerate() {
            let integer_bits = width - u32::from(signed);
            let format = Format { signed, integer_bits, fraction_bits: 0 };
            layout.append(&format!("input{number}"), format, FieldContent::Input(number));
        }
        layout
    }

    const HEADER: SpanHeader = SpanHeader { pixels: 1, last: false, position: [0; 2] };

    #[test]
    fn fields_follow_each_other_across_words() {
        let layout = layout(&[(false, 30), (true, 5), (false, 33), (true, 63), (false, 1)]);
        let inputs = [0x2aaa_aaab, -3, 0x1_0000_0001, i64::MIN >> 1, 1];
        let bits: Vec<bool> = layout
            .fields
            .iter()
            .zip(inputs)
            .flat_map(|(field, raw)| (0..field.format.width()).map(move |bit| raw >> bit & 1 == 1))
            .collect();
        assert_eq!(bits.len(), 132);
        for word in WordWidth::ALL {
            let words = layout.pack(&HEADER, &inputs, word);
            assert_eq!(words.len() as u32, 132_u32.div_ceil(word.bits()));
            let at = |bit: usize| {
                let bits = word.bits() as usize;
                words[bit / bits] >> (bit % bits) & 1 == 1
            };
            for bit in 0..words.len() * word.bits() as usize {
                assert_eq!(at(bit), bits.get(bit).copied().unwrap_or(false), "{word:?} {bit}");
            }
            assert!(words.iter().all(|&w| word == WordWidth::Bits64 || w < 1 << 32));
            let (header, found) = layout.unpack(&words, word);
            assert_eq!(header, SpanHeader { pixels: 0, ..HEADER });
            assert!(found.into_iter().eq(inputs.into_iter().enumerate()));
        }
    }
}

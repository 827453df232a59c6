//! The registers of a block: what there is at which address.
use specula_spec::{Format, Hold, InputMeaning, built_format};

use super::StreamCore;
use super::extent::extent;

/// What a host may do with a register.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Read it.
    Read,
    /// Read it, and write ones to what is to be cleared.
    ReadClear,
    /// Read and write it.
    ReadWrite,
}

/// A register of 32 bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Register {
    /// Its name, such as `status`.
    pub name: String,
    /// Its address, in bytes.
    pub address: u32,
    /// What a host may do with it.
    pub access: Access,
    /// What stands in it.
    pub about: String,
    /// What it has after reset; none of one that shows what happens.
    pub reset: Option<u32>,
}

/// An input that holds for a frame, and where its register is.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameInput {
    /// The number of the input in the spec's.
    pub number: usize,
    /// Its name.
    pub name: String,
    /// Its format as it is built.
    pub format: Format,
    /// What it has until it is written: of what it may be given the value nearest to 0.
    pub reset: i64,
    /// The address of its register, in bytes; one that is wider than 32 bits has another behind it.
    pub address: u32,
    /// From where to where its values reach, as text.
    pub extent: String,
    /// What it is.
    pub meaning: InputMeaning,
}

impl FrameInput {
    /// Bits of its register behind the first one, 0 if there is none.
    pub fn high_bits(&self) -> u32 {
        self.format.width().saturating_sub(32)
    }

    /// What its registers have where the input has the raw value `raw`: addresses and words.
    pub fn words(&self, raw: i64) -> Vec<(u32, u32)> {
        let mut words = vec![(self.address, raw as u32)];
        if self.high_bits() > 0 {
            words.push((self.address + 4, (raw >> 32) as u32));
        }
        words
    }
}

/// The word that tells that it is a block of this kind: `SPEC` in ASCII.
pub const IDENTITY: u32 = 0x5350_4543;
/// The version of the register map, in the upper half, and of the packet layout.
pub const VERSION: u32 = 0x0001_0001;
/// Address of the first register of an input.
const FIRST_INPUT: u32 = 0x100;

impl StreamCore<'_> {
    /// Every input that holds for a frame, in port order.
    pub fn frame_inputs(&self) -> Vec<FrameInput> {
        let meanings = self.spec.input_meanings();
        let mut address = FIRST_INPUT;
        let mut inputs = vec![];
        for (number, port) in self.spec.built_inputs() {
            if port.hold == Hold::Frame {
                let input = FrameInput {
                    number,
                    format: built_format(&port),
                    reset: 0_i64.clamp(port.range.0, port.range.1),
                    extent: extent(&port),
                    name: port.name,
                    address,
                    meaning: meanings[number].clone(),
                };
                address += if input.high_bits() > 0 { 8 } else { 4 };
                inputs.push(input);
            }
        }
        inputs
    }

    /// What the core can do, in a word.
    pub(super) fn capability(&self) -> u32 {
        let parameters = &self.spec.parameters;
        parameters.lights as u32
            | parameters.interval() << 4
            | u32::from(self.tag_bits() > 2) << 8
            | u32::from(self.word.bits() == 64) << 9
            | parameters.longest_span << 16
    }

    /// Bits of a packet, and in the upper half its words.
    pub(super) fn packet_size(&self) -> u32 {
        self.layout.bits | self.words() << 16
    }
}

/// Every register of a block, by address.
pub fn register_map(core: &StreamCore) -> Vec<Register> {
    let own = |name: &str, address: u32, reset: Option<u32>, about: &str| Register {
        name: name.to_owned(),
        address,
        access: Access::Read,
        about: about.to_owned(),
        reset,
    };
    let status = "a packet was skipped since it was too short (bit 0), too long (bit 1), or had a \
                  wrong number of pixels (bit 2); a one written to any of them clears all three. Bit \
                  8: busy";
    let capability = "bits 0 to 3: lights; 4 to 7: clocks of a pixel; 8: pixels have positions; 9: \
                      words have 64 bits; 16 to 31: pixels of the longest span";
    let version = "bits 0 to 15: version of the packet layout; 16 to 31: of this map";
    let mut map = vec![
        own("identity", 0x00, Some(IDENTITY), "SPEC in ASCII"),
        own("version", 0x04, Some(VERSION), version),
        own("core", 0x08, Some(core.identity), "CRC-32 of the core's spec.toml"),
        own("capability", 0x0c, Some(core.capability()), capability),
        own(
            "packet",
            0x10,
            Some(core.packet_size()),
            "bits 0 to 15: bits of a packet; 16 to 31: its words",
        ),
        Register { access: Access::ReadClear, ..own("status", 0x14, None, status) },
        own("frames", 0x18, None, "frames that have begun since reset, modulo 2^32"),
        own("pixels", 0x1c, None, "pixels sent since reset, modulo 2^32"),
        own("blocked", 0x20, None, "clocks in which a span waited for pixels to be taken"),
        own("starved", 0x24, None, "clocks in which there was no span to shade"),
    ];
    for input in core.frame_inputs() {
        let FrameInput { name, format, reset, extent, meaning, .. } = &input;
        let words = input.words(*reset);
        let several = words.len() > 1;
        for (place, (address, word)) in words.into_iter().enumerate() {
            let part = match (several, place) {
                (false, _) => "",
                (true, 0) => "_low",
                (true, _) => "_high",
            };
            map.push(Register {
                name: format!("{name}{part}"),
                address,
                access: Access::ReadWrite,
                about: format!("{}; {format}, {}, {extent}", meaning.what, meaning.unit),
                reset: Some(word),
            });
        }
    }
    map
}

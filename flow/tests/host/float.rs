//! Host code in float.
use specula_flow::host::{HostCode, Place, float_error};

use crate::cores::{HostResult, HostedCore};

/// Asserts that no input is off by more than is stated.
pub fn assert_near(core: &HostedCore, result: &HostResult, expected: &HostResult) {
    core.with_code(|code| {
        let per_packet = expected.words.len() / core.spans();
        let packets = result.words.chunks(per_packet).zip(expected.words.chunks(per_packet));
        for (span, (own, exact)) in packets.enumerate() {
            for (name, allowed, first_bit, bits) in fields(code) {
                let [own, exact] =
                    [own, exact].map(|words| raw(words, core.word_bits(), first_bit, bits));
                // Difference modulo the field's range, so that no sign is needed.
                let shift = u64::BITS - bits;
                let off = (own.wrapping_sub(exact) << shift) as i64 >> shift;
                assert!(off.abs() <= allowed, "{}, {span}, {name}: {off}, {allowed}", core.name);
            }
        }
    });
}

/// Name, stated error, first bit and bits of each field.
fn fields<'c>(code: &'c HostCode) -> Vec<(&'c str, i64, u32, u32)> {
    let field = |input: &'c specula_flow::host::SentInput| match input.place {
        Place::Packet { first_bit, bits } => {
            Some((input.port.name.as_str(), float_error(input), first_bit, bits))
        }
        Place::Registers(_) => None,
    };
    code.packet.inputs.iter().filter_map(field).collect()
}

/// Some bits of a packet.
fn raw(words: &[u64], word_bits: u32, first_bit: u32, bits: u32) -> u64 {
    (0..bits).rev().fold(0, |number, bit| {
        let place = first_bit + bit;
        number << 1 | words[(place / word_bits) as usize] >> (place % word_bits) & 1
    })
}

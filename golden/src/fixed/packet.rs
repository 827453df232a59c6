//! Reading packets.
use std::fmt;

use specula_spec::{Format, InputPort, SpanPacket};

use super::error::PacketError;
use super::number::Wide;
use super::span_extent::SpanExtent;
use super::vector::{Vector, dot};

/// Whether a vector that is interpolated along the span is no longer than `longest` at both ends,
/// but for rounding into `format`.
pub(super) fn check_ends(
    name: fmt::Arguments<'_>,
    (start, delta): (&Vector, &Vector),
    longest: Wide,
    format: Format,
) -> Result<(), PacketError> {
    let end = std::array::from_fn(|c| start[c] + delta[c]);
    check_length(format_args!("{name} at the first pixel"), start, longest, format)?;
    check_length(format_args!("{name} at the last pixel"), &end, longest, format)
}

/// Whether a vector is no longer than `longest`, but for rounding into `format`, which moves it by
/// √3/2 units of the last place at most.
pub(super) fn check_length(
    name: fmt::Arguments<'_>,
    vector: &Vector,
    longest: Wide,
    format: Format,
) -> Result<(), PacketError> {
    check_no_longer(name, vector, longest + (Wide::ONE >> format.fraction_bits))
}

/// Whether a vector is no longer than `longest`.
pub(super) fn check_no_longer(
    name: fmt::Arguments<'_>,
    vector: &Vector,
    longest: Wide,
) -> Result<(), PacketError> {
    let squared = dot(vector, vector);
    if squared <= longest * longest {
        return Ok(());
    }
    Err(PacketError::LongVector {
        name: name.to_string(),
        length: squared.to_num::<f64>().sqrt(),
        longest: longest.to_num(),
    })
}

/// Whether a packet is one for these ports, and how far its span goes.
pub(super) fn check(
    packet: &SpanPacket,
    ports: &[InputPort],
    longest: u32,
) -> Result<SpanExtent, PacketError> {
    if !(1..=longest).contains(&packet.length) {
        return Err(PacketError::Length { length: packet.length, longest });
    }
    if packet.inputs.len() != ports.len() {
        return Err(PacketError::InputCount { given: packet.inputs.len(), wanted: ports.len() });
    }
    ports.iter().zip(&packet.inputs).try_for_each(|(port, &raw)| check_range(port, raw))?;
    ports
        .iter()
        .zip(&packet.inputs)
        .try_for_each(|(port, &raw)| check_twin(port, raw, packet, ports))?;
    Ok(SpanExtent { length: packet.length, longest })
}

fn check_twin(
    port: &InputPort,
    raw: i64,
    packet: &SpanPacket,
    ports: &[InputPort],
) -> Result<(), PacketError> {
    let Some(twin) = &port.same_as else { return Ok(()) };
    let given = ports
        .iter()
        .zip(&packet.inputs)
        .find(|(other, _)| other.name == *twin)
        .map(|(_, &raw)| raw);
    if given == Some(raw) {
        Ok(())
    } else {
        Err(PacketError::Differs { name: port.name.clone(), twin: twin.clone(), raw })
    }
}

fn check_range(port: &InputPort, raw: i64) -> Result<(), PacketError> {
    let (low, high) = port.range;
    if (low..=high).contains(&raw) {
        Ok(())
    } else {
        Err(PacketError::OutOfRange { name: port.name.clone(), raw, low, high })
    }
}

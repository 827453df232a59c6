//! Reading packets.
use std::fmt;

use specula_scene::spec::InputPort;
use specula_scene::{Format, SpanPacket};

use super::course::Course;
use super::number::Wide;
use super::vector::{Vector, dot};

/// Why a packet does not fit a core.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PacketError {
    /// It was set up for another core.
    #[error("the packet has {given} inputs and the core {wanted}")]
    InputCount {
        /// Inputs in the packet.
        given: usize,
        /// Inputs of the core.
        wanted: usize,
    },
    /// An input is outside the range that the core is built for.
    #[error("input `{name}` is {raw}, outside {low} to {high}")]
    OutOfRange {
        /// The port.
        name: String,
        /// The raw value given.
        raw: i64,
        /// Smallest raw value.
        low: i64,
        /// Largest raw value.
        high: i64,
    },
    /// An input that the core does not take, since it always has another's value, has another
    /// value.
    #[error("input `{name}` is {raw}, and not what `{twin}` is")]
    Differs {
        /// The input.
        name: String,
        /// The one whose value it should have.
        twin: String,
        /// The raw value given.
        raw: i64,
    },
    /// The span is empty or longer than the core takes.
    #[error("the span has {length} pixels, and the core takes 1 to {longest}")]
    Length {
        /// Pixels of the span.
        length: u32,
        /// Pixels of the longest span.
        longest: u32,
    },
    /// A vector is longer than one there can be.
    #[error("{name} is a vector of length {length}, and no longer than {longest} is taken")]
    LongVector {
        /// The vector, and at which end of the span if it changes.
        name: String,
        /// Its length.
        length: f64,
        /// What a rounded vector may have.
        longest: f64,
    },
    /// What grows along the span by steps leaves its limits: the steps belong to a shorter span, or
    /// to none.
    #[error("`{name}` grows to {value} at pixel {pixel}, outside {low} to {high}")]
    Outgrown {
        /// What grows.
        name: String,
        /// The pixel, counted from 0.
        pixel: u32,
        /// Its value there.
        value: f64,
        /// The lower limit.
        low: f64,
        /// The upper limit.
        high: f64,
    },
    /// Cosine and sine of the angle from pixel to pixel are no rotation.
    #[error("the turn from pixel to pixel makes normals longer")]
    Turn,
    /// The span has no such pixel.
    #[error("there is no pixel {pixel} in a span of {length}")]
    NoSuchPixel {
        /// The pixel asked for, counted from 0.
        pixel: u32,
        /// Pixels of the span.
        length: u32,
    },
}

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
    let longest = longest + (Wide::ONE >> format.fraction_bits);
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
) -> Result<Course, PacketError> {
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
    Ok(Course { length: packet.length, longest })
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

//! Reading packets.
use specula_scene::SpanPacket;
use specula_scene::spec::InputPort;

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
    /// An input that the core does not take, since it always has another's value, has another value.
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
    /// A vector at the end of a span is not a unit vector, nor shorter.
    #[error("a vector at the end of the span is too long")]
    LongVector,
    /// Weight steps do not end at 1: 1/S is too coarse in the accumulator's format, or belongs to a shorter span.
    #[error("the weight of the last normal grows to {weight} along the span, past 1")]
    Weight {
        /// The weight at the last pixel.
        weight: f64,
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

/// The largest |N|² of a vector at the end of a span. A unit vector in `S1.4`, the coarsest format, comes to (1 + √3/32)² = 1.112 at most.
const LONGEST_SQUARED: Wide = Wide::lit("1.25");
/// The largest weight at the last pixel; 1, and what the rounding of 1/S adds to it.
const LARGEST_WEIGHT: Wide = Wide::lit("1.0625");

/// Whether a vector that is interpolated along the span is no longer than `longest` at both ends, but for rounding.
pub(super) fn check_ends(start: &Vector, delta: &Vector, longest: u32) -> Result<(), PacketError> {
    let limit = LONGEST_SQUARED * Wide::from_num(longest * longest);
    let end: Vector = std::array::from_fn(|c| start[c] + delta[c]);
    let too_long = |vector: &Vector| dot(vector, vector) > limit;
    if too_long(start) || too_long(&end) { Err(PacketError::LongVector) } else { Ok(()) }
}

/// Whether the weight ends at 1.
pub(super) fn check_weight(step: Wide, length: u32) -> Result<(), PacketError> {
    let weight = step * Wide::from_num(length - 1);
    if weight > LARGEST_WEIGHT { Err(PacketError::Weight { weight: weight.to_num() }) } else { Ok(()) }
}

/// Whether a packet is one for these ports.
pub(super) fn check(packet: &SpanPacket, ports: &[InputPort], longest: u32) -> Result<(), PacketError> {
    if !(1..=longest).contains(&packet.length) {
        return Err(PacketError::Length { length: packet.length, longest });
    }
    if packet.inputs.len() != ports.len() {
        return Err(PacketError::InputCount { given: packet.inputs.len(), wanted: ports.len() });
    }
    ports.iter().zip(&packet.inputs).try_for_each(|(port, &raw)| check_range(port, raw))?;
    ports.iter().zip(&packet.inputs).try_for_each(|(port, &raw)| check_twin(port, raw, packet, ports))
}

fn check_twin(port: &InputPort, raw: i64, packet: &SpanPacket, ports: &[InputPort]) -> Result<(), PacketError> {
    let Some(twin) = &port.same_as else { return Ok(()) };
    let given = ports.iter().zip(&packet.inputs).find(|(other, _)| other.name == *twin).map(|(_, &raw)| raw);
    if given == Some(raw) { Ok(()) } else { Err(PacketError::Differs { name: port.name.clone(), twin: twin.clone(), raw }) }
}

fn check_range(port: &InputPort, raw: i64) -> Result<(), PacketError> {
    let (low, high) = port.range;
    if (low..=high).contains(&raw) { Ok(()) } else { Err(PacketError::OutOfRange { name: port.name.clone(), raw, low, high }) }
}

//! Packets that do not fit a core.

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

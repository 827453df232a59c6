//! What a host sends a design for one span.

/// What a design is given of one span.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpanPacket {
    /// Pixels of the span; its inputs are held for as long as they go in.
    pub length: u32,
    /// Raw values of the data inputs, in the order in which they were opened.
    pub inputs: Vec<i64>,
}

impl SpanPacket {
    /// A pixel that is a span of its own.
    pub fn pixel(inputs: Vec<i64>) -> SpanPacket {
        SpanPacket { length: 1, inputs }
    }
}

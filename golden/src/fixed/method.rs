//! What methods have in common.
use specula_scene::SpanPacket;
use specula_scene::spec::InputPort;

use super::course::Course;
use super::number::{Wide, from_raw};
use super::observer::Observer;
use super::packet::PacketError;

/// A method in the formats of one core.
pub(super) trait Method {
    /// A span's inputs, by name.
    type Inputs;

    /// Names a packet's inputs. The packet has one for each port.
    fn read(&self, values: Values<'_>) -> Self::Inputs;

    /// Whether inputs within their ports' ranges can be computed together.
    fn check(&self, inputs: &Self::Inputs, course: Course) -> Result<(), PacketError>;

    /// The code of pixel `i`.
    fn pixel(&self, inputs: &Self::Inputs, i: u32, observer: &mut impl Observer) -> [u8; 3];
}

/// The raw values of a packet in port order.
pub(super) struct Values<'a>(std::slice::Iter<'a, i64>);

impl<'a> Values<'a> {
    pub fn new(packet: &'a SpanPacket) -> Self {
        Values(packet.inputs.iter())
    }

    /// The next value, which is this port's.
    pub fn next(&mut self, port: &InputPort) -> Wide {
        let raw = self.0.next().expect("packet::check has counted the inputs");
        from_raw(*raw, port.format)
    }
}

//! What methods have in common.
use specula_spec::{InputPort, SpanPacket};

use super::course::Course;
use super::error::PacketError;
use super::number::{Wide, from_raw};
use super::observer::Observer;

/// A method in the formats of one core.
pub(super) trait Method {
    /// A span's inputs, by name.
    type Inputs;
    /// What a pixel leaves to the one after it: registers that are fed back. `()` where pixels do
    /// not depend on one another.
    type State: Copy + Default;

    /// Names a packet's inputs. The packet has one for each port.
    fn read(&self, values: Values<'_>) -> Self::Inputs;

    /// Whether inputs within their ports' ranges can be computed together.
    fn check(&self, inputs: &Self::Inputs, course: Course) -> Result<(), PacketError>;

    /// The state at pixel `i`, from that at the pixel before; `None` before the first pixel.
    fn state(
        &self,
        _inputs: &Self::Inputs,
        _before: Option<Self::State>,
        _i: u32,
        _observer: &mut impl Observer,
    ) -> Self::State {
        Self::State::default()
    }

    /// The code of pixel `i`, at which the state is `state`.
    fn pixel(
        &self,
        inputs: &Self::Inputs,
        state: Self::State,
        i: u32,
        observer: &mut impl Observer,
    ) -> [u8; 3];
}

/// The code of pixel `i`, where `state` is what the pixel before has left; it is then what this one
/// leaves.
pub(super) fn next_pixel<M: Method>(
    method: &M,
    inputs: &M::Inputs,
    state: &mut Option<M::State>,
    i: u32,
    observer: &mut impl Observer,
) -> [u8; 3] {
    let at_pixel = method.state(inputs, *state, i, observer);
    *state = Some(at_pixel);
    method.pixel(inputs, at_pixel, i, observer)
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

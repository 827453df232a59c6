//! `NAME_axis` as a whole.
use std::collections::VecDeque;

use specula_spec::SpanHeader;

use super::super::StreamCore;
use super::packet_buffer::PacketBuffer;
use super::pixel_memory::{Pixel, PixelMemory, Places};
use super::span_stage::{Pace, SpanStage};

/// The stream top.
pub struct StreamTop {
    packets: PacketBuffer,
    span: SpanStage,
    places: Places,
    pixels: PixelMemory,
    /// Whether a pixel completes, for each clock that it takes through the core.
    core: VecDeque<bool>,
}

/// What comes from outside in a clock.
#[derive(Clone, Copy, Debug)]
pub struct TopInputs {
    /// The word at `s_axis`, if any is offered.
    pub word: Option<u64>,
    /// `m_axis_tready`.
    pub ready: bool,
}

/// What stands in a packet: its header, and raw values of inputs with their numbers.
pub type Packet = (SpanHeader, Vec<(usize, i64)>);

/// What happens in a clock.
pub struct TopEvents {
    /// The word that is offered is taken.
    pub word_taken: bool,
    /// A time slot goes into the core.
    pub enter: bool,
    /// A frame begins.
    pub frame: bool,
    /// What stands in the packet whose span is shaded from the next clock on.
    pub loaded: Option<Packet>,
    /// The pixel that is taken at `m_axis`.
    pub sent: Option<Pixel>,
}

impl StreamTop {
    /// The top of a core after reset.
    pub fn new(core: &StreamCore) -> StreamTop {
        let depth = core.design.depth();
        let settling = core.has_frame_inputs().then(|| core.design.settling());
        let pace = Pace { interval: core.design.interval, depth, settling };
        StreamTop {
            packets: PacketBuffer::new(core.words() as usize),
            span: SpanStage::new(pace),
            places: Places::new(core.log2_depth()),
            pixels: PixelMemory::new(core.log2_depth()),
            core: vec![false; depth as usize].into(),
        }
    }

    /// Whether a packet is waiting or shaded, or a pixel not wholly sent.
    pub fn is_busy(&self) -> bool {
        let waiting = self.packets.packet().is_some() || self.pixels.shown().is_some();
        waiting || self.span.is_shading() || !self.places.are_free()
    }

    /// Goes on by a clock. `unpack` tells what the words of a packet say.
    pub fn clock(&mut self, inputs: TopInputs, unpack: impl FnOnce(&[u64]) -> Packet) -> TopEvents {
        let packet = self.packets.packet();
        let signals = self.span.signals(packet.is_some(), self.places.room);
        let loaded = packet.filter(|_| signals.load).map(unpack);
        let events = TopEvents {
            word_taken: inputs.word.is_some() && self.packets.takes(),
            enter: signals.enter,
            frame: signals.frame,
            sent: self.pixels.shown().filter(|_| inputs.ready),
            loaded,
        };
        self.core.push_back(signals.complete);
        // One was put in the line before.
        let leaves = self.core.pop_front().unwrap_or(false);
        self.places.clock(signals.spend, self.pixels.freed());
        let enters = signals.spend.then(|| self.span.tag());
        self.pixels.clock(enters, leaves, inputs.ready);
        self.span.clock(&signals, events.loaded.as_ref().map(|(header, _)| *header));
        self.packets.clock(inputs.word, signals.load);
        events
    }
}

//! The span that is shaded: which of its pixels enters when, and when the next packet or the next frame
//! is taken over.
use specula_spec::SpanHeader;

use super::pixel_memory::Tag;

/// What there is of time slots, frames and clocks in a core.
#[derive(Clone, Copy)]
pub struct Pace {
    /// Clocks of a pixel.
    pub interval: u32,
    /// Clocks from a pixel's last time slot to its exit.
    pub depth: u32,
    /// If inputs hold for a frame: clocks in which they settle.
    pub settling: Option<u32>,
}

/// What happens in a clock.
pub struct SpanSignals {
    /// A time slot goes in.
    pub enter: bool,
    /// It is a pixel's first.
    pub spend: bool,
    /// It is a pixel's last.
    pub complete: bool,
    /// The packet is taken over.
    pub load: bool,
    /// A frame begins.
    pub frame: bool,
}

/// The span that is shaded.
pub struct SpanStage {
    pace: Pace,
    shading: bool,
    /// Column and row of the next pixel.
    position: [u32; 2],
    /// Pixels that have not entered.
    left: u32,
    /// Whether the next span begins a frame.
    at_frame: bool,
    /// Whether the next pixel begins a frame.
    of_frame: bool,
    /// The number of the next time slot of its pixel.
    slot: u32,
    /// Whether the inputs of the next span's frame have been taken over.
    taken: bool,
    /// Clocks until the last pixel has left, or inputs have settled.
    drain: u32,
}

impl SpanStage {
    /// One without a span.
    pub fn new(pace: Pace) -> SpanStage {
        SpanStage {
            pace,
            shading: false,
            position: [0; 2],
            left: 0,
            at_frame: true,
            of_frame: false,
            slot: 0,
            taken: false,
            drain: 0,
        }
    }

    /// Whether a span is shaded.
    pub fn is_shading(&self) -> bool {
        self.shading
    }

    /// What the pixel that enters next has besides its colour.
    pub fn tag(&self) -> Tag {
        Tag { position: self.position, first: self.of_frame, last: self.left == 1 }
    }

    /// What happens in this clock, where a packet is whole, and a pixel may enter if there is room.
    pub fn signals(&self, full: bool, room: bool) -> SpanSignals {
        let first_slot = self.slot == 0;
        let enter = self.shading && (room || !first_slot);
        let complete = enter && self.slot + 1 == self.pace.interval;
        let free = !self.shading || (complete && self.left == 1);
        let (load, frame) = match self.pace.settling {
            None => {
                let load = full && free;
                (load, load && self.at_frame)
            }
            Some(_) => {
                let drained = self.drain == 0;
                let load = full && (!self.at_frame || (self.taken && drained)) && free;
                (load, full && self.at_frame && !self.taken && !self.shading && drained)
            }
        };
        SpanSignals { enter, spend: enter && first_slot, complete, load, frame }
    }

    /// Ends a clock in which that happens; `packet` is the header of what is loaded.
    pub fn clock(&mut self, signals: &SpanSignals, packet: Option<SpanHeader>) {
        self.clock_frame(signals);
        if signals.enter {
            self.slot = (self.slot + 1) % self.pace.interval;
        }
        if let Some(SpanHeader { pixels, last, position }) = packet {
            self.shading = true;
            (self.position, self.left, self.slot) = (position, pixels, 0);
            self.of_frame = self.at_frame;
            self.at_frame = last;
        } else if signals.complete {
            self.shading = self.left > 1;
            self.position[0] += 1;
            self.left -= 1;
            self.of_frame = false;
        }
    }

    fn clock_frame(&mut self, signals: &SpanSignals) {
        let Some(settling) = self.pace.settling else { return };
        if signals.frame || signals.load {
            self.taken = signals.frame;
        }
        self.drain = if signals.enter {
            self.pace.depth - 1
        } else if signals.frame {
            settling
        } else {
            self.drain.saturating_sub(1)
        };
    }
}

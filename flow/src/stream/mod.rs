//! A core as a block for a design: AXI4-Stream in and out, registers behind AXI4-Lite, with the
//! vectors, the bench and the files that an engineer needs to use them.
//!
//! The texts are templates written by hand (`templates/`), in which a core's widths, ports and
//! constants are filled in.
mod bench;
mod c_header;
mod constraints;
mod data_sheet;
mod extent;
mod files;
mod fill;
mod formal;
mod handshake;
mod model;
mod packet_table;
mod record;
mod register_map;
mod register_table;
mod simulator;
mod synthesis;
mod system_rdl;
pub(crate) mod template;
mod vectors;
mod waveform;

use specula_datapath::Design;
use specula_datapath::design::ScopeId;
use specula_spec::{CoreSpec, Hold, PacketLayout, Positions, WordWidth};

pub use files::{File, HostCall, bench_files, files};
pub use handshake::Handshake;
pub use model::{StreamRun, Stuck};
pub use record::{SentPixel, StreamDifference, StreamRecord};
pub use register_map::{FrameInput, Register, register_map};
pub use simulator::{BlockRun, BlockSimulator};
pub use vectors::{FrameVectors, SpanVector, Vectors};
pub use waveform::{Row, Window};

/// The shape of a core's streams.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StreamShape {
    /// Width of a packet's words.
    pub word: WordWidth,
    /// Whether packets and pixels have positions.
    pub positions: Positions,
}

/// A core with streams and registers around it.
pub struct StreamCore<'a> {
    /// The core's spec.
    pub spec: &'a CoreSpec,
    /// The core.
    pub design: &'a Design,
    /// Where everything stands in a packet.
    pub layout: PacketLayout,
    /// Width of a packet's words.
    pub word: WordWidth,
    /// What tells this core from others: a checksum of its spec, which hosts read from a register.
    pub identity: u32,
}

impl<'a> StreamCore<'a> {
    /// The block of a core whose spec is the text `spec_text`.
    pub fn new(
        spec: &'a CoreSpec,
        design: &'a Design,
        shape: StreamShape,
        spec_text: &str,
    ) -> StreamCore<'a> {
        StreamCore {
            spec,
            design,
            layout: PacketLayout::of(spec, shape.positions),
            word: shape.word,
            identity: crc32fast::hash(spec_text.as_bytes()),
        }
    }

    /// The name of the core's module, with which all names of the block begin.
    pub fn name(&self) -> &str {
        &self.design.scope(ScopeId::TOP).instance
    }

    /// Words of a packet.
    pub fn words(&self) -> u32 {
        self.layout.words(self.word)
    }

    /// Bits of a pixel in the stream.
    pub fn pixel_bits(&self) -> u32 {
        24 + self.tag_bits() - 2
    }

    /// Bits that a pixel has beside its colour: its position, and whether it is the first one of a
    /// frame and the last one of a span.
    fn tag_bits(&self) -> u32 {
        match self.layout.positions {
            Positions::Absent => 2,
            Positions::Sent => 34,
        }
    }

    /// Whether inputs hold for a frame, so that they are registers.
    pub fn has_frame_inputs(&self) -> bool {
        self.spec.built_inputs().iter().any(|(_, port)| port.hold == Hold::Frame)
    }

    /// Pixels that have to be under way for full speed: from when one enters until its place is free
    /// again.
    fn depth_needed(&self) -> u32 {
        let clocks = self.design.latency() + 3;
        clocks.div_ceil(self.design.interval) + 1
    }

    /// Of the memory for pixels the base-2 logarithm of its places, one of which is not used.
    fn log2_depth(&self) -> u32 {
        (self.depth_needed() + 1).next_power_of_two().ilog2().max(2)
    }
}

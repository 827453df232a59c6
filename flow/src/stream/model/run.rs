//! A run of the bench, the stream top in it.
use specula_spec::SpanPacket;

use super::super::record::{SentPixel, StreamRecord};
use super::super::{FrameVectors, SpanVector, StreamCore};
use super::bench::Bench;
use super::pixel_memory::Pixel;
use super::registers::Registers;
use super::top::{StreamTop, TopEvents};

/// What goes into a core behind its stream top, and when, and what comes out of the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StreamRun {
    /// The spans, with the inputs that the top takes from their packets and from registers.
    pub packets: Vec<SpanPacket>,
    /// The clock in which each time slot goes in.
    pub entries: Vec<u64>,
    /// The clock in which the first word is taken.
    pub first_word: u64,
    /// The pixels that are taken at `m_axis`, with the clock of each.
    sent: Vec<(u64, Pixel)>,
}

/// Nothing moves any more, though not all pixels have come out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error, miette::Diagnostic)]
#[error(
    "the stream top stands still from clock {clock} on, when {sent} of {pixels} pixels have been taken"
)]
#[diagnostic(
    code(specula::stream::stuck),
    help("this is a fault of Specula's: please report it with the scene")
)]
pub struct Stuck {
    /// The last clock in which something moved.
    pub clock: u64,
    /// Pixels that have come out.
    pub sent: usize,
    /// Pixels that were to come out.
    pub pixels: usize,
}

/// Clocks without any transfer after which the bench gives up.
const PATIENCE: u64 = 100_000;

impl StreamRun {
    /// Sends frames through the stream top of a core, with random pauses on both sides where `seed`
    /// is not 0: those of the bench with `+seed`.
    ///
    /// # Errors
    /// [`Stuck`] if it comes to no end.
    pub fn new(core: &StreamCore, frames: &[FrameVectors], seed: u32) -> Result<StreamRun, Stuck> {
        let spans: Vec<&SpanVector> = frames.iter().flat_map(|frame| &frame.spans).collect();
        let pixels = spans.iter().map(|span| span.codes.len()).sum();
        let mut top = StreamTop::new(core);
        let mut bench = Bench::new(core, frames, seed);
        let mut registers = Registers::new(core);
        let mut run = StreamRun { packets: vec![], entries: vec![], first_word: 0, sent: vec![] };
        let (mut moved, mut clock) = (0, 0);
        while !bench.is_done() || top.is_busy() {
            let unpack = |words: &[u64]| core.layout.unpack(words, core.word);
            let events = top.clock(bench.inputs(), unpack);
            if events.word_taken || events.sent.is_some() {
                moved = clock;
            } else if clock - moved > PATIENCE {
                return Err(Stuck { clock: moved, sent: run.sent.len(), pixels });
            }
            run.note(clock, &events, &registers, &spans);
            bench.clock(events.word_taken, &mut registers);
            if events.frame {
                registers.begin_frame();
            }
            clock += 1;
        }
        Ok(run)
    }

    /// Notes what happens in a clock.
    fn note(
        &mut self,
        clock: u64,
        events: &TopEvents,
        registers: &Registers,
        spans: &[&SpanVector],
    ) {
        if events.word_taken && self.first_word == 0 {
            self.first_word = clock;
        }
        if let Some((header, found)) = &events.loaded {
            // Inputs that are constants, or the same as another, are in no packet.
            let mut inputs = spans[self.packets.len()].inputs.clone();
            for (number, raw) in found.iter().copied().chain(registers.held()) {
                inputs[number] = raw;
            }
            self.packets.push(SpanPacket { length: header.pixels, inputs });
        }
        self.entries.extend(events.enter.then_some(clock));
        self.sent.extend(events.sent.map(|pixel| (clock, pixel)));
    }

    /// What comes out at `m_axis` where a core gives these codes, one for each pixel in the order in
    /// which they leave it.
    pub fn record(&self, core: &StreamCore, codes: &[[u8; 3]]) -> StreamRecord {
        let pixel = |&(clock, Pixel { tag, colour }): &(u64, Pixel)| {
            let word = core.pixel_word(codes[colour], tag.position);
            SentPixel { clock, bits: core.marked(word, tag.first, tag.last) }
        };
        StreamRecord { pixels: self.sent.iter().map(pixel).collect() }
    }
}

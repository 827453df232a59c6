//! The bench `NAME_tb` around the block: what it offers at `s_axis` and takes at `m_axis`.
use super::super::{FrameVectors, StreamCore, Vectors};
use super::random::Pauses;
use super::register_host::RegisterHost;
use super::registers::Registers;
use super::top::TopInputs;

/// A word that is sent.
struct Word {
    bits: u64,
    /// Whether it is the first one of its frame, before which the frame's inputs are written.
    begins: bool,
}

/// The bench.
pub struct Bench {
    words: Vec<Word>,
    next: usize,
    begun: usize,
    inputs: TopInputs,
    packets: Option<Pauses>,
    pixels: Option<Pauses>,
    host: RegisterHost,
}

impl Bench {
    /// The bench after reset, with frames for a core. A seed that is not 0 makes it pause at random on
    /// both sides.
    pub fn new(core: &StreamCore, frames: &[FrameVectors], seed: u32) -> Bench {
        let spans = |frame: &FrameVectors| {
            let words = frame.spans.iter().flat_map(|span| core.packet(span));
            words.enumerate().map(|(place, bits)| Word { bits, begins: place == 0 }).collect()
        };
        let words: Vec<Vec<Word>> = frames.iter().map(spans).collect();
        let vectors = Vectors::new(core, frames);
        let writes = (0..frames.len()).map(|frame| vectors.frame_writes(frame)).collect();
        Bench {
            words: words.into_iter().flatten().collect(),
            next: 0,
            begun: 0,
            inputs: TopInputs { word: None, ready: false },
            packets: Pauses::of_packets(seed),
            pixels: Pauses::of_pixels(seed),
            host: RegisterHost::new(writes),
        }
    }

    /// Whether all words have been taken.
    pub fn is_done(&self) -> bool {
        self.next == self.words.len() && self.inputs.word.is_none()
    }

    /// What the bench gives the stream top in this clock.
    pub fn inputs(&self) -> TopInputs {
        self.inputs
    }

    /// Ends a clock in which the word that is offered is taken, or is not.
    pub fn clock(&mut self, word_taken: bool, registers: &mut Registers) {
        if self.inputs.word.is_none() || word_taken {
            self.inputs.word = self.next_word();
        }
        self.inputs.ready = !self.pixels.as_ref().is_some_and(Pauses::rests);
        for pauses in [&mut self.packets, &mut self.pixels].into_iter().flatten() {
            pauses.clock();
        }
        self.host.clock(registers);
    }

    fn next_word(&mut self) -> Option<u64> {
        let word = self.words.get(self.next)?;
        let waits = word.begins && self.begun >= self.host.written();
        if waits || self.packets.as_ref().is_some_and(Pauses::rests) {
            return None;
        }
        self.next += 1;
        self.begun += usize::from(word.begins);
        Some(word.bits)
    }
}

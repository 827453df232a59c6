//! Vectors for simulators: words of packets, register writes and expected pixels, as `$readmemh`
//! reads them.
use std::fmt::Write;

use specula_scene::Span;
use specula_sim::SpanSource;
use specula_spec::{Positions, SpanHeader};

use super::StreamCore;

/// A span that goes in, and what has to come out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpanVector {
    /// Its pixels, its place, and whether it is the last one of its frame.
    pub header: SpanHeader,
    /// Raw values of the spec's inputs.
    pub inputs: Vec<i64>,
    /// Red, green and blue of each pixel.
    pub codes: Vec<[u8; 3]>,
}

/// The spans of a frame, of which there is at least one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameVectors {
    /// The spans. All have the same values of inputs that hold for a frame.
    pub spans: Vec<SpanVector>,
}

impl FrameVectors {
    /// The vectors of the first spans of a frame, `source`'s packets of which a core has to make
    /// `codes`, one for each pixel.
    pub fn new(spans: &[Span], source: &dyn SpanSource, codes: &[[u8; 3]]) -> FrameVectors {
        let mut rest = codes;
        let vector = |(index, span): (usize, &Span)| {
            let (own, later) = rest.split_at((span.length as usize).min(rest.len()));
            rest = later;
            let mut inputs = vec![];
            source.append_inputs(index, &mut inputs);
            let last = index + 1 == spans.len();
            let header = SpanHeader { pixels: span.length, last, position: [span.x, span.y] };
            SpanVector { header, inputs, codes: own.to_vec() }
        };
        FrameVectors { spans: spans.iter().enumerate().map(vector).collect() }
    }
}

/// Frames one after the other.
pub struct Vectors<'a> {
    core: &'a StreamCore<'a>,
    frames: &'a [FrameVectors],
}

impl<'a> Vectors<'a> {
    /// The vectors of some frames.
    pub fn new(core: &'a StreamCore<'a>, frames: &'a [FrameVectors]) -> Vectors<'a> {
        Vectors { core, frames }
    }

    /// How many words, pixels and register writes there are.
    pub fn counts(&self) -> [usize; 3] {
        let spans = || self.frames.iter().flat_map(|frame| &frame.spans);
        let pixels = spans().map(|span| span.codes.len()).sum();
        let writes = (0..self.frames.len()).map(|frame| self.frame_writes(frame).len()).sum();
        [spans().count() * self.core.words() as usize, pixels, writes]
    }

    /// The words of all packets. Above each word stand `tlast` and, in the first word of a frame, a
    /// bit that says so.
    pub fn packets(&self) -> String {
        let bits = self.core.word.bits();
        let digits = (bits as usize + 2).div_ceil(4);
        let mut text = self.head("words of packets: the first of a frame, tlast, word");
        for frame in self.frames {
            for (number, span) in frame.spans.iter().enumerate() {
                let words = self.core.packet(span);
                let SpanHeader { pixels, position: [x, y], .. } = span.header;
                // Writing to a String cannot fail, here and below.
                let _ = writeln!(text, "// {pixels} pixels from {x}, {y} on");
                for (place, word) in words.iter().enumerate() {
                    let ends = u128::from(place + 1 == words.len());
                    let begins = u128::from(number == 0 && place == 0);
                    let line = u128::from(*word) | ends << bits | begins << (bits + 1);
                    let _ = writeln!(text, "{line:0digits$x}");
                }
            }
        }
        text
    }

    /// The pixels that have to come out. Above each stand `tuser` and `tlast`.
    pub fn pixels(&self) -> String {
        let digits = (self.core.pixel_bits() as usize + 2).div_ceil(4);
        let mut text =
            self.head("pixels: tuser, tlast, row and column where they are sent, b, g, r");
        for line in self.marked_pixels() {
            let _ = writeln!(text, "{line:0digits$x}");
        }
        text
    }

    /// The same pixels as numbers.
    pub fn marked_pixels(&self) -> Vec<u64> {
        let mut pixels = vec![];
        for frame in self.frames {
            for (number, span) in frame.spans.iter().enumerate() {
                for (i, pixel) in self.core.pixel_words(span).into_iter().enumerate() {
                    let ends = i + 1 == span.codes.len();
                    pixels.push(self.core.marked(pixel, number == 0 && i == 0, ends));
                }
            }
        }
        pixels
    }

    /// What is written to registers before each frame: number of the frame, address, word.
    pub fn registers(&self) -> String {
        let mut text = self.head("register writes: frame, address, word");
        for frame in 0..self.frames.len() {
            for (address, word) in self.frame_writes(frame) {
                let _ = writeln!(text, "{frame:04x}{address:04x}{word:08x}");
            }
        }
        text
    }

    /// Addresses and words of what is written before a frame.
    pub(super) fn frame_writes(&self, frame: usize) -> Vec<(u32, u32)> {
        let first = self.frames[frame].spans.first();
        let words = |span: &SpanVector| {
            let inputs = self.core.frame_inputs();
            inputs.iter().flat_map(|input| input.words(span.inputs[input.number])).collect()
        };
        first.map(words).unwrap_or_default()
    }

    fn head(&self, what: &str) -> String {
        let (version, name) = (env!("CARGO_PKG_VERSION"), self.core.name());
        format!("// Specula {version}: vectors of {name}_ip. {what}.\n")
    }
}

impl StreamCore<'_> {
    /// The words of a span's packet.
    pub(super) fn packet(&self, span: &SpanVector) -> Vec<u64> {
        self.layout.pack(&span.header, &span.inputs, self.word)
    }

    /// The pixels of a span as they stand in the stream.
    pub(super) fn pixel_words(&self, span: &SpanVector) -> Vec<u64> {
        let [x, y] = span.header.position;
        (x..).zip(&span.codes).map(|(x, &code)| self.pixel_word(code, [x, y])).collect()
    }

    /// A pixel as it stands in the stream.
    pub(super) fn pixel_word(&self, [red, green, blue]: [u8; 3], position: [u32; 2]) -> u64 {
        let colour = u64::from(u32::from_le_bytes([red, green, blue, 0]));
        let [x, y] = position.map(u64::from);
        match self.layout.positions {
            Positions::Absent => colour,
            Positions::Sent => colour | x << 24 | y << 40,
        }
    }

    /// A pixel with its marks above it: whether it is the first one of its frame, `tuser`, and the
    /// last one of its span, `tlast`.
    pub(super) fn marked(&self, pixel: u64, first: bool, last: bool) -> u64 {
        let bits = self.pixel_bits();
        pixel | u64::from(last) << bits | u64::from(first) << (bits + 1)
    }
}

//! A packet and its pixels clock by clock, as the data sheet draws them. Values are computed from
//! latency and interval alone; a test compares them with Icarus.
use super::StreamCore;
use super::files::File;
use super::vectors::{FrameVectors, SpanVector};
use super::waveform::{Row, Window};

/// A span of a frame's vectors that goes in alone, after the registers have been written. The next
/// packet stands behind its last word. When its second pixel comes, `m_axis_tready` falls for two
/// clocks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Handshake {
    /// `s_axis` from the first word until the next packet begins.
    pub packet: Window,
    /// `m_axis` from the clock before the first pixel.
    pub pixels: Window,
    /// Clocks in which `m_axis_tready` is low.
    pub refused: [u32; 2],
}

/// Fewest pixels of a span that shows how pixels follow each other, and most that are shown.
const PIXELS: usize = 4;

impl StreamCore<'_> {
    /// Clocks from that in which the last word of a packet is taken to that in which its first
    /// pixel is at the output, of a block that has nothing else to do.
    pub(super) fn first_pixel(&self) -> u32 {
        self.loading() + self.design.latency() + 4
    }

    /// Clocks from that in which the last word of a packet is taken until the packet is, in a block
    /// that has nothing else to do and in which a frame begins: it is whole in the next clock, and
    /// inputs that hold for a frame settle first.
    fn loading(&self) -> u32 {
        if self.has_frame_inputs() { 2 + self.design.settling() } else { 1 }
    }
}

impl Handshake {
    /// That of the first span with enough pixels, or else of the longest; none if there is no span.
    pub fn new(core: &StreamCore, frames: &[FrameVectors]) -> Option<Handshake> {
        let spans = || frames.iter().flat_map(|frame| &frame.spans);
        let long = spans().find(|span| span.codes.len() >= PIXELS);
        let span = long.or_else(|| spans().max_by_key(|span| span.codes.len()))?;
        let taken = core.words() - 1 + core.loading();
        let places = Places::new(core, span.codes.len());
        Some(Handshake {
            packet: packet(core, span, taken),
            pixels: pixels(core, span, &places),
            refused: places.refused,
        })
    }

    /// Drawings of both windows.
    pub fn drawings(&self, name: &str) -> [File; 2] {
        let about =
            format!("<!-- Specula {}: a handshake of {name}_ip. -->\n", env!("CARGO_PKG_VERSION"));
        [("packet", &self.packet), ("pixels", &self.pixels)].map(|(which, window)| File {
            name: format!("{name}_{which}.svg"),
            text: format!("{about}{}", window.svg()),
        })
    }
}

/// `s_axis` until the next packet's first word has been taken, the clock after `taken`.
fn packet(core: &StreamCore, span: &SpanVector, taken: u32) -> Window {
    let words = core.layout.pack(&span.header, &span.inputs, core.word);
    let count = words.len() as u32;
    let each =
        |value: &dyn Fn(u32) -> u64| (0..taken + 2).map(|clock| Some(value(clock))).collect();
    let word = |clock: u32| words.get(clock as usize).copied().unwrap_or(words[0]);
    let row = |signal, bits, values| Row { signal, bits, values };
    Window {
        title: format!("A packet of {count} words goes in, and the next one waits"),
        first: 0,
        rows: vec![
            row("s_axis_tdata", core.word.bits(), each(&word)),
            row("s_axis_tvalid", 1, each(&|_| 1)),
            row("s_axis_tready", 1, each(&|clock| u64::from(clock < count || clock > taken))),
            row("s_axis_tlast", 1, each(&|clock| u64::from(clock + 1 == count || count == 1))),
        ],
    }
}

/// When pixels are at the output, from the first clock of each to that in which it is taken.
struct Places {
    shown: Vec<[u32; 2]>,
    refused: [u32; 2],
}

impl Places {
    /// Those of a span's first pixels.
    fn new(core: &StreamCore, pixels: usize) -> Places {
        let first = core.words() - 1 + core.first_pixel();
        let ready = |number: u32| first + number * core.design.interval;
        let stalled = u32::from(pixels > 1);
        let refused = [ready(stalled), ready(stalled) + 1];
        let mut shown: Vec<[u32; 2]> = vec![];
        for number in 0..pixels.min(PIXELS) as u32 {
            let free = shown.last().map_or(0, |[_, taken]| taken + 1);
            let begins = ready(number).max(free);
            let ends = if refused.contains(&begins) { refused[1] + 1 } else { begins };
            shown.push([begins, ends]);
        }
        Places { shown, refused }
    }
}

/// `m_axis` while the first pixels go out.
fn pixels(core: &StreamCore, span: &SpanVector, places: &Places) -> Window {
    let words = core.pixel_words(span);
    let first = places.shown.first().map_or(0, |[begins, _]| begins - 1);
    let last = places.shown.last().map_or(0, |[_, ends]| *ends);
    let at = |clock: u32| {
        let here = |[begins, ends]: &[u32; 2]| (*begins..=*ends).contains(&clock);
        places.shown.iter().position(here)
    };
    let clocks = || first..=last;
    let of_pixel = |value: &dyn Fn(usize) -> u64| {
        clocks().map(|clock| at(clock).map(value)).collect::<Vec<_>>()
    };
    let bit =
        |value: &dyn Fn(u32) -> bool| clocks().map(|clock| Some(value(clock).into())).collect();
    let row = |signal, bits, values| Row { signal, bits, values };
    Window {
        title: format!(
            "Its first pixels come out, {} clocks after its last word was taken",
            core.first_pixel()
        ),
        first,
        rows: vec![
            row("m_axis_tdata", core.pixel_bits(), of_pixel(&|number| words[number])),
            row("m_axis_tvalid", 1, bit(&|clock| at(clock).is_some())),
            row("m_axis_tready", 1, bit(&|clock| !places.refused.contains(&clock))),
            row("m_axis_tuser", 1, of_pixel(&|number| u64::from(number == 0))),
            row("m_axis_tlast", 1, of_pixel(&|number| u64::from(number + 1 == span.codes.len()))),
        ],
    }
}

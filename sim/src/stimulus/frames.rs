//! Frames of a run: between them, inputs that hold for a frame change.
use std::sync::Arc;

use specula_datapath::Design;

use super::SpanSource;

/// The frames of a run, and what a design asks for between them.
#[derive(Clone, Debug)]
pub(crate) struct Frames {
    /// The spans, in order, that begin a frame; the first span apart.
    begins: Arc<[usize]>,
    /// Clocks from the entry of a pixel to its exit.
    depth: u64,
    /// Clocks for which inputs that hold for a frame stand before its first pixel enters.
    settling: u64,
}

impl Frames {
    /// The frames of a source, as a design sees them: one, if none of its inputs holds for a frame.
    pub fn of(spans: &dyn SpanSource, design: &Design) -> Frames {
        let inputs = design.frame_inputs();
        let others = if inputs.is_empty() { 0..0 } else { 1..spans.count() };
        Frames {
            begins: others.filter(|&span| spans.begins_frame(span, &inputs)).collect(),
            depth: design.depth().into(),
            settling: design.settling().into(),
        }
    }

    /// Whether there are several.
    pub fn are_several(&self) -> bool {
        !self.begins.is_empty()
    }

    /// Whether a span begins a frame that is not the first.
    pub fn begin_with(&self, span: usize) -> bool {
        self.begins.binary_search(&span).is_ok()
    }

    /// Clocks without a pixel before span number `span`, from which the first pixel of a frame needs
    /// some: until the last pixel before has left, and until the frame's inputs have settled.
    pub fn wait_for(&self, span: usize) -> u64 {
        match span {
            0 => self.settling,
            _ if self.begin_with(span) => self.depth + self.settling,
            _ => 0,
        }
    }

    /// Whether a pixel that entered at `entry` has left before `clock`.
    pub fn have_drained(&self, entry: u64, clock: u64) -> bool {
        entry + self.depth < clock
    }
}

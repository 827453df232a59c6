//! A frame's spans, set up for a core.
use specula_scene::spec::SetUp;
use specula_scene::{CoreSpec, Frame, SpanPacket};
use specula_sim::SpanSource;

/// The spans of a frame as a core takes them.
pub struct FrameSpans<'a> {
    frame: &'a Frame,
    set_up: SetUp<'a>,
}

impl<'a> FrameSpans<'a> {
    /// The spans of `frame` for the core of `spec`.
    pub fn new(frame: &'a Frame, spec: &'a CoreSpec) -> FrameSpans<'a> {
        FrameSpans { frame, set_up: SetUp::new(spec, frame) }
    }
}

impl FrameSpans<'_> {
    /// Span `index`, set up.
    pub fn packet(&self, index: usize) -> SpanPacket {
        self.set_up.packet(&self.frame.spans[index])
    }
}

impl SpanSource for FrameSpans<'_> {
    fn count(&self) -> usize {
        self.frame.spans.len()
    }

    fn length(&self, index: usize) -> u32 {
        self.frame.spans[index].length
    }

    fn append_inputs(&self, index: usize, inputs: &mut Vec<i64>) {
        inputs.extend(self.packet(index).inputs);
    }
}

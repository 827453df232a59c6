//! A frame's spans, set up for a core.
use rayon::prelude::*;
use specula_scene::Frame;
use specula_sim::SpanSource;
use specula_spec::{CoreSpec, SetUp, SpanPacket};

/// The spans of a frame as a core takes them, each set up whenever it is asked for.
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
        self.set_up.append(&self.frame.spans[index], inputs);
    }
}

/// The spans of a source, each set up once and kept: 8 bytes for each input of a span, and 8 more.
pub struct KeptSpans {
    lengths: Vec<u32>,
    /// [`BLOCK`] spans each, but for the last.
    blocks: Vec<Block>,
}

/// Spans that are set up together.
const BLOCK: usize = 1024;

/// Spans one behind the other.
struct Block {
    inputs: Vec<i64>,
    /// Where each span's inputs end.
    ends: Vec<u32>,
}

impl KeptSpans {
    /// Sets up every span of a source.
    pub fn of(source: &dyn SpanSource) -> KeptSpans {
        let count = source.count();
        let block = |first: usize| {
            let (mut inputs, mut ends) = (Vec::new(), Vec::new());
            for index in first..count.min(first + BLOCK) {
                source.append_inputs(index, &mut inputs);
                ends.push(inputs.len() as u32);
            }
            inputs.shrink_to_fit();
            Block { inputs, ends }
        };
        KeptSpans {
            lengths: (0..count).map(|index| source.length(index)).collect(),
            blocks: (0..count.div_ceil(BLOCK))
                .into_par_iter()
                .map(|number| block(number * BLOCK))
                .collect(),
        }
    }

    /// Raw inputs of span `index`, in port order.
    pub fn inputs(&self, index: usize) -> &[i64] {
        let (Block { inputs, ends }, own) = (&self.blocks[index / BLOCK], index % BLOCK);
        let begin = own.checked_sub(1).map_or(0, |before| ends[before]);
        &inputs[begin as usize..ends[own] as usize]
    }
}

impl SpanSource for KeptSpans {
    fn count(&self) -> usize {
        self.lengths.len()
    }

    fn length(&self, index: usize) -> u32 {
        self.lengths[index]
    }

    fn append_inputs(&self, index: usize, inputs: &mut Vec<i64>) {
        inputs.extend_from_slice(self.inputs(index));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_span_keeps_its_inputs() {
        let packets: Vec<SpanPacket> = (0..2 * BLOCK as i64 + 7)
            .map(|i| SpanPacket {
                length: 1 + i as u32,
                inputs: (0..i % 5).map(|j| i + j).collect(),
            })
            .collect();
        for count in [0, 1, BLOCK, packets.len()] {
            let packets = packets[..count].to_vec();
            let kept = KeptSpans::of(&packets);
            assert_eq!(kept.count(), count);
            for (index, packet) in packets.iter().enumerate() {
                assert_eq!(kept.length(index), packet.length);
                assert_eq!(kept.inputs(index), packet.inputs);
            }
        }
    }
}

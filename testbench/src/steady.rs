//! Inputs that hold for a frame, looked at in every clock of a stimulus: whether they stand still
//! while pixels are under way, and early enough before.
use specula_datapath::Design;
use specula_sim::Stimulus;

/// An input that holds for a frame and did not stand still.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MovedInput {
    /// Full name of the input.
    pub port: String,
    /// The span with whose inputs it changed.
    pub span: usize,
    /// The clock in which it did.
    pub clock: u64,
    /// What was wrong with that.
    pub wrong: Wrong,
}

/// What is wrong with the clock of a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wrong {
    /// A pixel was under way.
    UnderWay {
        /// The clock in which the last such pixel leaves.
        leaves: u64,
    },
    /// The next pixel came too early.
    Unsettled {
        /// The clock in which that entered.
        enters: u64,
        /// The clocks for which the input had to stand before.
        settling: u32,
    },
}

impl MovedInput {
    /// In words.
    pub fn in_words(&self) -> String {
        let MovedInput { port, span, clock, wrong } = self;
        let wrong = match wrong {
            Wrong::UnderWay { leaves } => {
                format!("while pixels are under way, the last of which leaves in cycle {leaves}")
            }
            Wrong::Unsettled { enters, settling } => format!(
                "and a pixel enters in cycle {enters}, before it has stood for {settling} cycles"
            ),
        };
        format!(
            "input {port} holds for a frame, but changes in cycle {clock} (span {span}), {wrong}"
        )
    }
}

/// The first input that holds for a frame and does not stand still over a whole run.
pub fn moved_input(design: &Design, stimulus: &Stimulus) -> Option<MovedInput> {
    let mut watch = Watch::of(design)?;
    stimulus.holds().find_map(|hold| {
        let span = hold.span?;
        let changed = watch.change((hold.clocks.start, span), hold.inputs);
        let early = hold.valid.then(|| watch.enter(hold.clocks)).flatten();
        changed.or(early)
    })
}

/// What has been seen so far.
struct Watch<'a> {
    design: &'a Design,
    /// The numbers of inputs that hold for a frame.
    frame_inputs: Vec<usize>,
    /// The inputs of the last clock.
    inputs: Vec<i64>,
    /// The last change: which input, the clock and its span.
    change: Option<(usize, u64, usize)>,
    /// The clock in which the last pixel entered.
    entered: Option<u64>,
}

impl Watch<'_> {
    /// That of a design, if any of its inputs holds for a frame.
    fn of(design: &Design) -> Option<Watch<'_>> {
        let frame_inputs = design.frame_inputs();
        let some = !frame_inputs.is_empty();
        let (inputs, change, entered) = (vec![], None, None);
        some.then_some(Watch { design, frame_inputs, inputs, change, entered })
    }

    /// Inputs of a clock and its span; a fault if what holds for a frame changes too early. Those of
    /// the first clock count as changed.
    fn change(&mut self, (clock, span): (u64, usize), inputs: Vec<i64>) -> Option<MovedInput> {
        let before = std::mem::replace(&mut self.inputs, inputs);
        let differs = |input: &&usize| before.get(**input) != Some(&self.inputs[**input]);
        let input = *self.frame_inputs.iter().find(differs)?;
        self.change = Some((input, clock, span));
        let leaves = self.entered? + u64::from(self.design.depth());
        (leaves >= clock).then(|| self.moved(Wrong::UnderWay { leaves })).flatten()
    }

    /// Pixels that enter in these clocks; a fault if the last change was too late for the first.
    fn enter(&mut self, clocks: std::ops::Range<u64>) -> Option<MovedInput> {
        self.entered = Some(clocks.end - 1);
        let (enters, settling) = (clocks.start, self.design.settling());
        let (_, changed, _) = self.change?;
        let early = enters < changed + u64::from(settling);
        early.then(|| self.moved(Wrong::Unsettled { enters, settling })).flatten()
    }

    /// The last change as a fault.
    fn moved(&self, wrong: Wrong) -> Option<MovedInput> {
        let (input, clock, span) = self.change?;
        let port = self.design.full_name(self.design.inputs[input]?);
        Some(MovedInput { port, span, clock, wrong })
    }
}

#[cfg(test)]
mod tests {

    use specula_datapath::{Builder, Format, Hold, InputPort, SpanPacket};
    use specula_sim::SpanSource;

    use super::*;

    /// x·c^(2^`squarings`), where c holds for a frame.
    fn design(squarings: u32) -> Design {
        let builder = Builder::new("core", "x c^2^k");
        let control = builder.control();
        let port = |name| InputPort::whole(name, Format::unsigned(2, 0));
        let x = builder.input(&port("x"));
        let c = builder.input(&InputPort { hold: Hold::Frame, ..port("c") });
        let power = (0..squarings).fold(c, |power, _| power.squared());
        builder.finish(&control.valid, &[("out", x * power)]).expect("it can be built")
    }

    fn packets(frames: &[i64]) -> Vec<SpanPacket> {
        frames.iter().map(|&c| SpanPacket { length: 3, inputs: vec![1, c] }).collect()
    }

    /// A source that says its spans are of one frame, whatever they are.
    struct OneFrame(Vec<SpanPacket>);

    impl SpanSource for OneFrame {
        fn count(&self) -> usize {
            self.0.len()
        }

        fn length(&self, index: usize) -> u32 {
            self.0[index].length
        }

        fn append_inputs(&self, index: usize, inputs: &mut Vec<i64>) {
            inputs.extend_from_slice(&self.0[index].inputs);
        }
    }

    #[test]
    fn inputs_change_between_frames() {
        for design in [0, 1, 3].map(design) {
            let packets = packets(&[1, 1, 2, 3, 3, 1]);
            let stimulus = Stimulus::whole(&packets, &design);
            assert_eq!(moved_input(&design, &stimulus), None);
            for seed in 0..20 {
                let paused = Stimulus::whole(&packets, &design).with_bubbles(seed);
                assert_eq!(moved_input(&design, &paused), None);
            }
        }
    }

    #[test]
    fn an_input_that_changes_within_a_frame_is_told() {
        let design = design(1);
        let source = OneFrame(packets(&[1, 1, 2, 3]));
        let moved = moved_input(&design, &Stimulus::whole(&source, &design)).expect("it moves");
        let first = u64::from(design.settling());
        let clock = first + 6;
        let leaves = clock - 1 + u64::from(design.depth());
        let wrong = Wrong::UnderWay { leaves };
        assert_eq!(moved, MovedInput { port: "core.c".into(), span: 2, clock, wrong });
        assert_eq!(
            moved.in_words(),
            "input core.c holds for a frame, but changes in cycle 7 (span 2), while pixels are under way, \
             the last of which leaves in cycle 7"
        );
    }

    /// What is right for a design in which the input settles at once is too early for another.
    #[test]
    fn a_pixel_that_does_not_wait_is_told() {
        let (quick, slow) = (design(0), design(3));
        assert_eq!((quick.settling(), slow.settling()), (0, 3));
        assert_eq!((quick.depth(), slow.depth()), (1, 1));
        let packets = packets(&[1, 2]);
        let moved = moved_input(&slow, &Stimulus::whole(&packets, &quick)).expect("it is early");
        let wrong = Wrong::Unsettled { enters: 0, settling: 3 };
        assert_eq!(moved, MovedInput { port: "core.c".into(), span: 0, clock: 0, wrong });
        assert_eq!(
            moved.in_words(),
            "input core.c holds for a frame, but changes in cycle 0 (span 0), and a pixel enters in \
             cycle 0, before it has stood for 3 cycles"
        );
    }
}

//! The values that the inputs of a core are given.
use specula_datapath::InputPort;
use specula_scene::Frame;
use specula_scene::frame::Span;

use crate::core_spec::CoreSpec;
use crate::frames::Frames;
use crate::set_up::SetUp;
use crate::specialisation::Given;

/// The values that the inputs of a core are given over frames.
#[derive(Clone)]
pub(crate) struct GivenValues {
    /// Smallest and largest raw value of each; none without spans.
    ranges: Option<Vec<(i64, i64)>>,
    /// For each the earlier ones of its format that always had its value.
    twins: Vec<Vec<usize>>,
}

impl GivenValues {
    /// Those of inputs with these ports, before they are given any.
    pub fn none(ports: &[InputPort]) -> GivenValues {
        let earlier = |own: usize| {
            (0..own).filter(|&other| ports[other].format == ports[own].format).collect()
        };
        GivenValues { ranges: None, twins: (0..ports.len()).map(earlier).collect() }
    }

    /// Sets up every span of the frames.
    pub fn of_frames(core: &CoreSpec, ports: &[InputPort], frames: Frames) -> GivenValues {
        let mut values = GivenValues::none(ports);
        for frame in frames.iter() {
            values.add_frame(core, frame);
        }
        values.add_examples(core, frames.iter().next());
        values
    }

    /// Adds what inputs may be given besides, as the core's specialisation says.
    pub fn add_examples(&mut self, core: &CoreSpec, frame: Option<&Frame>) {
        let examples = frame.map(|frame| core.specialisation.kept().examples(frame));
        for example in examples.iter().flatten() {
            self.add_frame(core, example);
        }
    }

    /// Sets up every span of a frame, and tells which of them brought something new: no other span
    /// has to be set up for the same values.
    pub fn add_frame<'f>(&mut self, core: &CoreSpec, frame: &'f Frame) -> Vec<&'f Span> {
        let set_up = SetUp::new(core, frame);
        let mut inputs = Vec::with_capacity(self.twins.len());
        let news = |span: &&Span| {
            inputs.clear();
            set_up.append(span, &mut inputs);
            self.add(&inputs)
        };
        frame.spans.iter().filter(news).collect()
    }

    /// Whether the inputs of a span extend a range or are the first that are not alike.
    fn add(&mut self, inputs: &[i64]) -> bool {
        let is_first = self.ranges.is_none();
        let ranges =
            self.ranges.get_or_insert_with(|| inputs.iter().map(|&raw| (raw, raw)).collect());
        let mut is_new = is_first;
        for (range, &raw) in ranges.iter_mut().zip(inputs) {
            is_new |= raw < range.0 || range.1 < raw;
            *range = (range.0.min(raw), range.1.max(raw));
        }
        for (twins, &raw) in self.twins.iter_mut().zip(inputs) {
            let before = twins.len();
            twins.retain(|&other| inputs[other] == raw);
            is_new |= twins.len() < before;
        }
        is_new
    }

    /// Smallest and largest raw value of an input; none without spans.
    pub fn range(&self, input: usize) -> Option<(i64, i64)> {
        self.ranges.as_ref().map(|ranges| ranges[input])
    }

    /// Earlier inputs that always had the value of this one.
    pub fn twins(&self, input: usize) -> &[usize] {
        &self.twins[input]
    }

    /// What an input was given, if that is less than its port takes; nothing of one that is free to
    /// take everything later, and no input is the same as such a one.
    pub fn given(&self, input: usize, ports: &[InputPort], is_free: &[bool]) -> Option<Given> {
        let range = self.range(input).filter(|_| !is_free[input])?;
        // An input that never changes needs no twin.
        let twins = || self.twins[input].iter().find(|&&twin| !is_free[twin]);
        let twin = if range.0 == range.1 { None } else { twins() };
        let same = twin.map(|&other| Given::SameAs(ports[other].name.clone()));
        same.or((range != ports[input].range).then_some(Given::Between([range.0, range.1])))
    }
}

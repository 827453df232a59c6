//! What a sequence gives a core's inputs, and the spans that say so.
use specula_scene::frame::Span;
use specula_scene::{Frame, SceneError, Sequence};

use crate::core_spec::CoreSpec;
use crate::given_values::GivenValues;

/// What a sequence gives a core's inputs.
#[derive(Clone, Debug)]
pub struct Survey {
    /// The core for this sequence alone.
    pub core: CoreSpec,
    /// The sequence's frames, each with those spans alone that are needed for the same core: a few
    /// of them stand for all. Frames that bring nothing new are not among them.
    pub witnesses: Vec<Frame>,
}

/// A survey that has been made, among the findings of its sequence.
struct Made {
    /// The general core that it was made for.
    general: CoreSpec,
    survey: Survey,
}

impl CoreSpec {
    /// Sets up every span of a sequence for this core, frames side by side. What has been found out
    /// for one core is remembered for all that are given the same.
    ///
    /// # Errors
    /// [`SceneError::Picture`] if a frame cannot be drawn.
    pub fn survey(&self, sequence: &Sequence) -> Result<Survey, SceneError> {
        let general = self.general();
        let is_given_the_same = |made: &Made| {
            made.general.specialisation == general.specialisation
                && general.is_given_what(&made.general)
        };
        if let Some(made) = sequence.findings().find(is_given_the_same) {
            let Survey { core, witnesses } = made.survey.clone();
            let core = CoreSpec { specialisation: core.specialisation, ..general };
            return Ok(Survey { core, witnesses });
        }
        let survey = general.surveyed(sequence)?;
        sequence.findings().add(Made { general, survey: survey.clone() });
        Ok(survey)
    }

    /// Makes the survey of this general core.
    fn surveyed(&self, sequence: &Sequence) -> Result<Survey, SceneError> {
        let ports = self.inputs();
        // Each frame is looked at by itself, so that the result does not depend on which is ready
        // first; what it has left is small enough to go through one after the other.
        let of_its_own = sequence.map(|_, frame| {
            let mut values = GivenValues::none(&ports);
            Ok::<_, SceneError>(reduced(&mut values, self, &frame))
        })?;
        let mut values = GivenValues::none(&ports);
        let witnesses = of_its_own.iter().map(|frame| reduced(&mut values, self, frame));
        let witnesses = witnesses.filter(|frame| !frame.spans.is_empty());
        let witnesses: Vec<Frame> = witnesses.collect();
        values.add_examples(self, witnesses.first());
        Ok(Survey { core: self.clone().given(&ports, &values), witnesses })
    }
}

/// The frame with those spans alone that give the inputs something new.
fn reduced(values: &mut GivenValues, core: &CoreSpec, frame: &Frame) -> Frame {
    let news = values.add_frame(core, frame);
    let mut kept: Vec<usize> = news.iter().map(|span| span.triangle).collect();
    kept.sort_unstable();
    kept.dedup();
    let span = |span: &&Span| {
        // Every span's triangle is among those that are kept.
        let triangle = kept.partition_point(|&index| index < span.triangle);
        Span { triangle, ..(*span).clone() }
    };
    Frame {
        spans: news.iter().map(span).collect(),
        triangles: kept.iter().map(|&index| frame.triangles[index].clone()).collect(),
        lights: frame.lights.clone(),
        local_lights: frame.local_lights.clone(),
        materials: frame.materials.clone(),
        ..*frame
    }
}

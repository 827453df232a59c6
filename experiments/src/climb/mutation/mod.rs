//! Small changes to a scene and its core.
mod core;
mod light;
mod operator;
mod span;
mod vector;

use super::genome::Genome;
use super::random::happens;
use crate::stress::draw::Draw;

use operator::Operator;

/// The subjects of changes, formats first. An ascent leaves some of them unchanged, so that not all
/// ascents end on the same peak.
const SUBJECTS: [&[Operator]; 5] =
    [core::FORMATS, span::SHAPE, span::MATERIAL, light::OPERATORS, core::OPTIONS];

/// Probability that an ascent changes a subject.
const SHARE_OF_SUBJECTS: f64 = 0.75;
/// Probability of one more change.
const ONE_MORE: f64 = 0.4;

/// The changes of an ascent: those of some subjects, at least one.
pub(super) struct Mutation(Vec<&'static [Operator]>);

impl Mutation {
    /// Draws the subjects.
    pub fn new(draw: &mut Draw) -> Mutation {
        Mutation::among(&SUBJECTS, draw)
    }

    /// Draws the subjects, except formats, which stay as they are.
    pub fn without_formats(draw: &mut Draw) -> Mutation {
        Mutation::among(&SUBJECTS[1..], draw)
    }

    fn among(all: &[&'static [Operator]], draw: &mut Draw) -> Mutation {
        let mut subjects: Vec<&[Operator]> =
            all.iter().copied().filter(|_| happens(draw, SHARE_OF_SUBJECTS)).collect();
        if subjects.is_empty() {
            subjects.push(draw.one_of(all));
        }
        Mutation(subjects)
    }

    /// The genome with one or a few changes; `None` if no core can be repaired to fit it.
    pub fn apply(&self, genome: &Genome, draw: &mut Draw) -> Option<Genome> {
        let mut changed = genome.clone();
        loop {
            let subject = draw.one_of(&self.0);
            draw.one_of(subject)(&mut changed, draw);
            if !happens(draw, ONE_MORE) {
                return changed.repaired();
            }
        }
    }
}

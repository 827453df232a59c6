//! Small changes to a scene and its core.
mod core;
mod light;
mod span;
mod vector;

use super::genome::Genome;
use super::random::happens;
use crate::stress::draw::Draw;

/// A change; it may leave everything as it is.
pub(super) type Operator = fn(&mut Genome, &mut Draw);

/// What changes are about. An ascent leaves some of these as they are, so that not all end on the
/// same peak.
const SUBJECTS: [&[Operator]; 5] =
    [span::SHAPE, span::MATERIAL, light::OPERATORS, core::FORMATS, core::OPTIONS];

/// How likely a subject is changed in an ascent.
const SHARE_OF_SUBJECTS: f64 = 0.75;
/// How likely one more change follows.
const ONE_MORE: f64 = 0.4;

/// The changes of an ascent: those of some subjects, of one at least.
pub(super) struct Mutation(Vec<&'static [Operator]>);

impl Mutation {
    /// Draws the subjects.
    pub fn new(draw: &mut Draw) -> Mutation {
        let mut subjects: Vec<&[Operator]> =
            SUBJECTS.into_iter().filter(|_| happens(draw, SHARE_OF_SUBJECTS)).collect();
        if subjects.is_empty() {
            subjects.push(draw.one_of(&SUBJECTS));
        }
        Mutation(subjects)
    }

    /// The genome with one change or a few; none where no core can be brought into line with it.
    pub fn of(&self, genome: &Genome, draw: &mut Draw) -> Option<Genome> {
        let mut changed = genome.clone();
        loop {
            let subject = draw.one_of(&self.0);
            draw.one_of(subject)(&mut changed, draw);
            if !happens(draw, ONE_MORE) {
                return changed.settled();
            }
        }
    }
}

/// An element of what may be empty.
fn any<'a, T>(elements: &'a mut [T], draw: &mut Draw) -> Option<&'a mut T> {
    let last = elements.len().checked_sub(1)?;
    elements.get_mut(draw.between(0, last as i64) as usize)
}

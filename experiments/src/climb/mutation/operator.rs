//! What all changes have in common.
use crate::climb::genome::Genome;
use crate::stress::draw::Draw;

/// A change; it may leave the genome as it is.
pub(super) type Operator = fn(&mut Genome, &mut Draw);

/// A random element of a slice, which may be empty.
pub(super) fn any<'a, T>(elements: &'a mut [T], draw: &mut Draw) -> Option<&'a mut T> {
    let last = elements.len().checked_sub(1)?;
    elements.get_mut(draw.between(0, last as i64) as usize)
}

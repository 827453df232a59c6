//! What every method's spec says of itself.
use super::set_up::SetUpSpan;
use super::{CoreSpec, InputPort, NarrowingPoint, SpecError};
use crate::frame::Frame;
use crate::needs::Needs;

/// A method's options and formats.
pub trait Describe {
    /// The ports of a core with this method, in the order in which packets hold their values.
    fn ports(&self, core: &CoreSpec) -> Vec<InputPort>;

    /// Every place where values are rounded, in the order of the data. `span_bits` number the pixels of the longest span.
    fn narrowing_points(&self, span_bits: u32) -> Vec<NarrowingPoint>;

    /// What else the spec says: names and values, for people to read.
    fn options(&self) -> Vec<(&'static str, String)> {
        Vec::new()
    }

    /// Whether options are within what can be built.
    ///
    /// # Errors
    /// [`SpecError`] names the first that is not.
    fn check_options(&self) -> Result<(), SpecError> {
        Ok(())
    }

    /// Whether a scene with these needs can be shaded.
    ///
    /// # Errors
    /// [`SpecError`] says what it needs and does not have.
    fn check_serves(&self, _needs: &Needs) -> Result<(), SpecError> {
        Ok(())
    }

    /// Whether lights and the eye may be at places.
    fn shades_from_places(&self) -> bool {
        false
    }

    /// The set-up of a frame's spans for a core with this method.
    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a>;
}

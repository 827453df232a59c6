//! What every method says of itself.
use serde::Serialize;
use specula_scene::frame::Frame;
use specula_scene::needs::Needs;

use crate::error::SpecError;
use crate::method_set_up::SetUpSpan;
use crate::narrowing::NarrowingPoint;

/// Where directions to lights and the eye at places are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Viewpoint {
    /// At every pixel.
    Pixel,
    /// At the vertices.
    Vertex,
    /// In the middle of each span, by the host: along the span they are the same.
    Span,
}

/// An option of a method, and what it may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OptionDomain {
    /// Its key in the method's table.
    pub key: &'static str,
    /// Its values, as TOML writes them.
    pub values: &'static [&'static str],
}

/// A direction that leaves a core beside a pixel's colour: three ports, `NAME_x` to `NAME_z`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DirectionOutput {
    /// Its name.
    pub name: &'static str,
    /// What it is.
    pub meaning: &'static str,
}

/// A method's options and formats.
pub trait ShadingMethod {
    /// Every place where values are rounded, in the order of the data. `span_bits` number the
    /// pixels of the longest span.
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
    fn check_compatible(&self, _needs: &Needs) -> Result<(), SpecError> {
        Ok(())
    }

    /// Where lights and the eye at places are seen from.
    fn places_seen_from(&self) -> Viewpoint {
        Viewpoint::Span
    }

    /// The directions that leave the core beside a pixel's colour, in the order of their ports.
    fn direction_outputs(&self) -> &'static [DirectionOutput] {
        &[]
    }

    /// The set-up of a frame's spans for a core with this method.
    fn set_up<'a>(&'a self, frame: &'a Frame) -> Box<dyn SetUpSpan + 'a>;
}

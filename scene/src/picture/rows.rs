//! Spans that are given as they are, one to a row, instead of being cut from objects.
use glam::DVec3;

use super::Light;
use super::project::{PictureError, View};
use crate::{Colour, Frame, Material, Span, Triangle};

/// A span and its triangle, whose material is its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The span, as it stands in the frame.
    pub span: Span,
    /// Its triangle.
    pub triangle: Triangle,
    /// How it answers light.
    pub material: Material,
}

/// A picture of spans. World and view space are one.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// 8-bit colour of pixels behind the end of a span.
    pub background: [u8; 3],
    /// Colour of the ambient light.
    pub ambient: Colour,
    /// Lights.
    pub lights: Vec<Light>,
    /// Where the eye is that sees highlights, if it is at a place.
    pub eye: Option<DVec3>,
    /// The spans, from the top.
    pub rows: Vec<Row>,
}

impl Rows {
    /// The frame: as wide as the longest span, as high as there are spans.
    ///
    /// # Errors
    /// [`PictureError::NothingVisible`] without spans.
    pub fn frame(&self) -> Result<Frame, PictureError> {
        let spans: Vec<Span> = self.rows.iter().map(|row| row.span.clone()).collect();
        let width =
            spans.iter().map(|span| span.length).max().ok_or(PictureError::NothingVisible)?;
        Ok(Frame {
            width,
            height: spans.len() as u32,
            background: self.background,
            ambient: self.ambient,
            lights: self.lights.iter().filter_map(|light| light.at_infinity(View::NONE)).collect(),
            local_lights: self
                .lights
                .iter()
                .filter_map(|light| light.at_a_place(View::NONE))
                .collect(),
            eye: self.eye,
            materials: self.rows.iter().map(|row| row.material.clone()).collect(),
            triangles: self.rows.iter().map(|row| row.triangle.clone()).collect(),
            spans,
        })
    }
}

//! Spans that are given directly, one in each row, instead of being cut from objects.
use glam::DVec3;

use super::Light;
use super::project::PictureError;
use super::view_transform::ViewTransform;
use crate::{Colour, Frame, Material, Span, Triangle};

/// A span and its triangle, with a material of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct SpanRow {
    /// The span, as it is in the frame.
    pub span: Span,
    /// Its triangle.
    pub triangle: Triangle,
    /// Its material.
    pub material: Material,
}

/// A picture of spans. World and view space are the same.
#[derive(Clone, Debug, PartialEq)]
pub struct SpanRows {
    /// 8-bit colour of pixels behind the end of a span.
    pub background: [u8; 3],
    /// Colour of the ambient light.
    pub ambient: Colour,
    /// Lights.
    pub lights: Vec<Light>,
    /// The position of the eye that sees highlights, if it is not at infinity.
    pub eye: Option<DVec3>,
    /// The spans, from the top.
    pub rows: Vec<SpanRow>,
}

impl SpanRows {
    /// The frame: as wide as the longest span, and as high as there are spans.
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
            lights: self
                .lights
                .iter()
                .filter_map(|light| light.at_infinity(ViewTransform::NONE))
                .collect(),
            local_lights: self
                .lights
                .iter()
                .filter_map(|light| light.at_a_place(ViewTransform::NONE))
                .collect(),
            eye: self.eye,
            materials: self.rows.iter().map(|row| row.material.clone()).collect(),
            triangles: self.rows.iter().map(|row| row.triangle.clone()).collect(),
            spans,
        })
    }
}

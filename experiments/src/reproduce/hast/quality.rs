//! Figures 1 to 3: hybrid shading, and Phong shading and reflection shading with highlights by eq. 34,
//! drawn by cores.
use specula_scene::Frame;
use specula_spec::Method;

use super::super::drawn::{Drawn, drawn};
use specula_testbench::statistics::Sums;
use specula_testbench::{BenchError, ErrorFigures};

/// A mesh that three cores have drawn.
#[derive(Clone, Debug)]
pub struct Quality {
    /// Figure 1: `hybrid`.
    pub hybrid: Drawn,
    /// Figure 2: `duff` with eq. 34.
    pub phong: Drawn,
    /// Figure 3: `reflection` with eq. 34, wrapped around the polygon's normal.
    pub reflection: Drawn,
    /// Differences between the codes of figures 2 and 3.
    pub difference: ErrorFigures,
    /// Difference of each pixel, the largest over its channels; negative where nothing is shaded.
    pub map: Vec<f32>,
    /// Share of the shaded pixels in which a channel differs by more than one code.
    pub share: f64,
}

/// Draws a frame with the three cores.
///
/// # Errors
/// [`BenchError`] if a core cannot be built for the frame, or does not agree with its model.
pub fn quality(frame: &Frame) -> Result<Quality, BenchError> {
    let hybrid = drawn(frame, Method::Hybrid, "")?;
    let phong = drawn(frame, Method::Duff, "duff.specular = \"eq34\"")?;
    let reflection = drawn(
        frame,
        Method::Reflection,
        "reflection.specular = \"eq34\"\nreflection.bisector = \"triangle\"",
    )?;
    let mut map = vec![-1.0; phong.image.pixels.len()];
    let (mut sums, mut off) = (Sums::default(), 0);
    for (pixel, place) in
        frame.spans.iter().flat_map(|span| (0..span.length).map(move |i| (span, i)))
    {
        let at = pixel.y as usize * frame.width as usize + (pixel.x + place) as usize;
        let (one, other) = (phong.image.pixels[at], reflection.image.pixels[at]);
        one.iter().zip(other).for_each(|(&one, other)| sums.add(f64::from(other) - f64::from(one)));
        let largest =
            one.iter().zip(other).map(|(one, other)| one.abs_diff(other)).max().unwrap_or(0);
        map[at] = f32::from(largest);
        off += u64::from(largest > 1);
    }
    let share = off as f64 / frame.shaded_pixels().max(1) as f64;
    Ok(Quality { hybrid, phong, reflection, difference: sums.figures(), map, share })
}

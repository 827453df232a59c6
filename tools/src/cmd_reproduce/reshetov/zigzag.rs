//! Figure 8: α modulated by curvature.
use specula_experiments::reproduce::reshetov::curvature::{zigzag, zigzag_pictures};
use specula_testbench::Image;

use crate::cmd_reproduce::pictured_mesh::SIZE;
use crate::cmd_reproduce::section::Section;
use crate::error::ToolError;
use crate::picture::{Panel, side_by_side};

/// Adds the zigzag's pictures, with their contrasts.
pub fn add(section: &mut Section) -> Result<(), ToolError> {
    section.heading(3, "Figure 8: angles modulated by curvature");
    section.paragraph(
        "A sheet folded by 40 degrees up and down, all of its vertex normals equal, drawn by cores. The paper has no formula for the modulation; \
         here a vertex's angle goes towards 90 degrees by a share that is the largest convex angle between two faces at it, over 90 degrees. No \
         angle becomes smaller, so no ray enters the surface. Angles are an input of the core, set up by the host: nothing is new in hardware.",
    );
    let frame = zigzag(SIZE)?;
    let drawn = zigzag_pictures(&frame)?;
    let panels: Vec<Panel> =
        drawn.iter().map(|(name, drawn)| Panel::new(*name, &drawn.image)).collect();
    section.picture("The zigzag of figure 8", "reshetov_figure8", side_by_side(&panels));
    let rows = drawn.each_ref().map(|(name, drawn)| {
        [(*name).to_owned(), contrast(&drawn.image, frame.background).to_string()]
    });
    section.table(["normals", "darkest to brightest pixel, LSB"], &rows);
    Ok(())
}

/// The difference between the brightest and the darkest pixel that is shaded.
fn contrast(image: &Image, background: [u8; 3]) -> u8 {
    let codes = || image.pixels.iter().filter(|pixel| **pixel != background).map(|pixel| pixel[1]);
    codes().max().unwrap_or(0) - codes().min().unwrap_or(0)
}

//! Figures 9 and 13: a light at the camera.
use specula_experiments::reproduce::reshetov::headlight::{
    Display, DotProducts, SPHERES, alone, dot_products_of, headlight,
};

use crate::cmd_reproduce::pictured_mesh::{PicturedMesh, SIZE};
use crate::cmd_reproduce::section::{Section, written};
use crate::error::ToolError;
use crate::picture::{Panel, side_by_side};

/// Adds the pictures, with how many dot products are below 0.
pub fn add(section: &mut Section, mesh: &PicturedMesh) -> Result<(), ToolError> {
    section.heading(3, "Figures 9 and 13: a light at the camera");
    section.paragraph(
        "N·V and N_c·V in f64, red where N·V is below 0. Figure 9 has spheres of more and more triangles. Figure 13 has the Tiny model, which \
         cannot be had; this is another mesh, its dot products marked (a), clamped and with ambient light (b), on a texture (c), and with \
         consistent normals (d, e). No N_c·V is below 0, so nothing has to be clamped.",
    );
    let mut rows = vec![];
    let mut panels = vec![];
    for (name, sphere) in SPHERES {
        let frame = alone(sphere, SIZE)?;
        rows.push(row(name, &dot_products_of(&frame)));
        panels.extend([Display::Marked, Display::Consistent].map(|display| {
            Panel::new(format!("{name}, {}", display.name()), &headlight(&frame, display))
        }));
    }
    section.picture("Reshetov's figure 9", "reshetov_figure9", side_by_side(&panels));
    let panels =
        Display::ALL.map(|display| Panel::new(display.name(), &headlight(&mesh.frame, display)));
    section.picture("Reshetov's figure 13", "reshetov_figure13", side_by_side(&panels));
    rows.push(row(&mesh.name, &dot_products_of(&mesh.frame)));
    section.table(
        ["mesh", "pixels", "N·V < 0", "N_c·V < 0", "mean difference of both, clamped, LSB"],
        &rows,
    );
    Ok(())
}

fn row(name: &str, counted: &DotProducts) -> [String; 5] {
    [
        name.to_owned(),
        counted.pixels.to_string(),
        counted.below.to_string(),
        counted.consistent_below.to_string(),
        written(counted.change),
    ]
}

//! The parts of Hast's paper besides claims: operations, figures 1 to 3, and the
//! axes that normals are wrapped around.
use specula_experiments::reproduce::hast::axes::{Axis, wrapped_picture};
use specula_experiments::reproduce::hast::operations::{Scheme, schemes};
use specula_experiments::reproduce::hast::quality::quality;
use specula_scene::{Frame, load};
use specula_testbench::ErrorFigures;

use super::pictured_mesh::{PicturedMesh, SIZE};
use super::section::{Section, written};
use crate::error::ToolError;
use crate::picture::{Panel, error_map, side_by_side};

/// Adds these parts to the section.
pub fn add(section: &mut Section, mesh: &PicturedMesh) -> Result<(), ToolError> {
    operations(section)?;
    pictures(section, mesh)?;
    wrapped_axes(section)
}

fn wrapped_axes(section: &mut Section) -> Result<(), ToolError> {
    section.heading(3, "What a normal is wrapped around");
    section.paragraph(
        "The icosahedron in f64, its normals wrapped around the polygon's normal and around L and V, which the paper calls bad: *off* is against \
         exact Phong shading.",
    );
    let frame = load("icosahedron", Some(SIZE))?.frame;
    let drawn = Axis::ALL.map(|axis| (axis, wrapped_picture(&frame, axis)));
    let panels: Vec<Panel> =
        drawn.iter().map(|(axis, (image, _))| Panel::new(axis.name(), image)).collect();
    section.picture("Normals wrapped around three axes", "hast_axes", side_by_side(&panels));
    let rows: Vec<[String; 3]> = drawn
        .iter()
        .map(|(axis, (_, error))| {
            [axis.name().to_owned(), written(error.max_lsb), written(error.rms_lsb)]
        })
        .collect();
    section.table(["axis", "largest off, LSB", "rms, LSB"], &rows);
    section.paragraph(
        "The warning holds: by rms the polygon's normal is nearest. It is not the same on both sides of an edge, so that edges are seen and \
         highlights torn there, which L and V, the same everywhere, do not do. Normals are wrapped here at every pixel, as they are interpolated between vertices, and come out shorter \
         than those of figure 3's core, which makes the ends of each span unit vectors first: hence it is less off.",
    );
    Ok(())
}

fn operations(section: &mut Section) -> Result<(), ToolError> {
    section.heading(3, "Operations per pixel");
    section.paragraph(
        "As printed, in the inner loop, and in the core for one light: accumulators, products, dividers, units for 1/√. The power and the \
         materials' products are left out, as the paper does. [operations.md](operations.md) explains the products that are more.",
    );
    let rows: Vec<[String; 5]> =
        schemes(&load("teapot", Some((160, 120)))?.frame)?.iter().map(row).collect();
    section
        .table(["scheme", "paper: + − × ÷ √", "inner loop", "core: acc × ÷ 1/√", "verdict"], &rows);
    Ok(())
}

fn row(scheme: &Scheme) -> [String; 5] {
    let numbers = |o: &specula_experiments::reproduce::hast::operations::Operations| {
        [o.adds, o.subtractions, o.multiplies, o.divisions, o.square_roots]
            .map(|n| n.to_string())
            .join(" ")
    };
    let core = [
        scheme.core.accumulators,
        scheme.core.multipliers,
        scheme.core.dividers,
        scheme.core.reciprocal_roots,
    ];
    let verdict =
        match (scheme.counted == scheme.printed && scheme.core_agrees(), scheme.further_products) {
            (false, _) => "does not hold: the core does others".to_owned(),
            (true, 0) => "holds".to_owned(),
            (true, further) => format!("holds within {further} product in place of a division"),
        };
    [
        scheme.source.to_owned(),
        numbers(&scheme.printed),
        numbers(&scheme.counted),
        core.map(|n| n.to_string()).join(" "),
        verdict,
    ]
}

fn pictures(section: &mut Section, mesh: &PicturedMesh) -> Result<(), ToolError> {
    section.heading(3, "Figures 1 to 3: hybrid, Phong and reflection shading");
    section.paragraph(
        "By simulated cores: figure 1 by `hybrid`, figure 2 by `duff` (Phong shading without normalisation), figure 3 by `reflection`, normals wrapped around the \
         polygon's; highlights of both by eq. 34. The paper's statue, of 1416 triangles, cannot be had; `--mesh` takes any. It has small \
         polygons, as the first mesh has; the second is coarse.",
    );
    compare(section, &mesh.name, &mesh.frame)?;
    compare(section, "icosahedron", &load("icosahedron", Some(SIZE))?.frame)
}

fn compare(section: &mut Section, name: &str, frame: &Frame) -> Result<(), ToolError> {
    let drawn = quality(frame)?;
    let title = format!("Hast's figures 1 to 3 on the {name}");
    section.picture(
        &title,
        &format!("hast_figures_1_to_3_{name}"),
        side_by_side(&[
            Panel::new("Figure 1: hybrid shaded", &drawn.hybrid.image),
            Panel::new("Figure 2: Phong shaded (duff)", &drawn.phong.image),
            Panel::new("Figure 3: reflection shaded", &drawn.reflection.image),
        ]),
    );
    let map = error_map(
        "|figure 3 - figure 2|, in LSB",
        (frame.width, frame.height),
        &drawn.map,
        &drawn.difference,
    );
    section.picture(
        &format!("Their difference on the {name}"),
        &format!("hast_difference_{name}"),
        map,
    );
    let row = |name: &str, figures: &ErrorFigures| {
        [
            name.to_owned(),
            written(figures.max_lsb),
            written(figures.rms_lsb),
            figures.psnr_db.map_or("–".to_owned(), |db| format!("{db:.1}")),
        ]
    };
    section.table(
        ["codes against", "largest, LSB", "rms, LSB", "PSNR, dB"],
        &[
            row("figure 1 against exact Phong shading", &drawn.hybrid.error),
            row("figure 2 against exact Phong shading", &drawn.phong.error),
            row("figure 3 against exact Phong shading", &drawn.reflection.error),
            row("figure 3 against figure 2", &drawn.difference),
        ],
    );
    let verdict = match &drawn.difference {
        figures if figures.max_lsb <= 1.0 => "holds".to_owned(),
        figures if figures.rms_lsb < 0.5 => format!("holds within {} LSB", figures.max_lsb),
        _ => "does not hold: on coarse polygons normals are wrapped too near to the polygon's, and highlights move".to_owned(),
    };
    section.paragraph(&format!(
        "\"It is very hard for the human eye to distinguish any differences\": {verdict}. More than an LSB: {:.2} % of the pixels.",
        100.0 * drawn.share
    ));
    Ok(())
}

//! The parts of Reshetov's paper besides claims and plots: reflections that enter meshes, and the
//! cost of consistent normals.
mod headlight;
mod mirrors;
mod zigzag;

use specula_datapath::design::Size;
use specula_experiments::reproduce::reshetov::inward::{self, Inward};
use specula_experiments::reproduce::reshetov::marked_pictures::{MarkedPictures, marked_pictures};
use specula_experiments::reproduce::reshetov::size::{SizedCore, sizes};
use specula_scene::{Frame, load, parse};

use super::pictured_mesh::{PicturedMesh, SIZE};
use super::section::{Section, written};
use crate::error::ToolError;
use crate::picture::{Panel, side_by_side};

/// Adds these parts to the section.
pub fn add(section: &mut Section, mesh: &PicturedMesh) -> Result<(), ToolError> {
    meshes(section, mesh);
    pictures(section, mesh)?;
    mirrors::add(section, mesh);
    zigzag::add(section)?;
    headlight::add(section, mesh)?;
    cost(section)
}

fn meshes(section: &mut Section, mesh: &PicturedMesh) {
    section.heading(3, "Reflections into meshes");
    section.paragraph("As many rays for each face, about 200 000 in all, from everywhere before it, anywhere on it; in f64.");
    let built_in =
        inward::MESHES.iter().map(|(name, shape)| row(name, &inward::count(&shape.mesh())));
    let given = (mesh.name != "teapot").then(|| row(&mesh.name, &inward::count(&mesh.mesh)));
    section.table(
        [
            "mesh",
            "triangles",
            "widest angle, degrees",
            "Phong: into the face",
            "Phong: N·I < 0",
            "q: into the face",
            "q~: into the face",
            "q~: least n·r",
            "mean change of N·I, LSB",
        ],
        &built_in.chain(given).collect::<Vec<_>>(),
    );
}

fn row(name: &str, inward: &Inward) -> [String; 9] {
    let percent = |share: f64| format!("{:.1} %", 100.0 * share);
    [
        name.to_owned(),
        inward.triangles.to_string(),
        format!("{:.1}", inward.widest),
        percent(inward.phong),
        percent(inward.behind),
        percent(inward.trigonometric),
        percent(inward.rational),
        format!("{:.3}", inward.least),
        format!("{:.0}", inward.change),
    ]
}

/// A sphere of 8 by 4 cells.
const COARSE_SPHERE: &str =
    "[[object]]\nprimitive = \"sphere\"\nlevel = 2\n[object.material]\nshininess = 16\n";

fn pictures(section: &mut Section, mesh: &PicturedMesh) -> Result<(), ToolError> {
    section.paragraph(
        "Seen from the eye, pixel by pixel; pink where the eye's ray is reflected into the surface (black or green in figure 1). Left with Phong's normals, \
         in f64; right the core's reflection.",
    );
    let scenes: [(&str, Frame); 3] = [
        (&mesh.name, mesh.frame.clone()),
        ("icosahedron", load("icosahedron", Some(SIZE))?.frame),
        (
            "coarse_sphere",
            parse("sphere.toml", format!("size = [{}, {}]\n{COARSE_SPHERE}", SIZE.0, SIZE.1))?
                .frame,
        ),
    ];
    let mut rows = vec![];
    for (name, frame) in &scenes {
        let seen = marked_pictures(frame)?;
        rows.push(counts(name, &seen));
        let panels = [
            Panel::new("Phong's normals", &seen.phong),
            Panel::new("consistent normals (core)", &seen.consistent),
        ];
        section.picture(
            &format!("Reflections into the {name}"),
            &format!("reshetov_inward_{name}"),
            side_by_side(&panels),
        );
    }
    section.table(
        ["picture", "pixels", "Phong: into the surface", "core: into the surface", "verdict"],
        &rows,
    );
    Ok(())
}

fn counts(name: &str, seen: &MarkedPictures) -> [String; 5] {
    let [phong, core] = seen.inward;
    let share = |count: usize| {
        format!("{count} ({:.2} %)", 100.0 * count as f64 / seen.pixels.max(1) as f64)
    };
    let verdict = if core == 0 { "holds: none is left" } else { "does not hold: some are left" };
    [name.to_owned(), seen.pixels.to_string(), share(phong), share(core), verdict.to_owned()]
}

fn cost(section: &mut Section) -> Result<(), ToolError> {
    section.heading(3, "What consistent normals cost in hardware");
    section.paragraph(
        "Table 1 has about 1 % of the frames a second on GPUs. Cores for the teapot, one light; *of these* are the units that consistent normals \
         add: q of the interpolated angle, and the reflection by it.",
    );
    let cores = sizes(&load("teapot", Some((640, 480)))?.frame)?;
    let rows: Vec<[String; 6]> = cores.iter().map(size_row).collect();
    section.table(
        ["core", "latency", "multipliers", "their bits", "adder bits", "register bits"],
        &rows,
    );
    let share = |core: &SizedCore| {
        100.0 * core.share.multiplier_bits as f64 / core.design.size().multiplier_bits as f64
    };
    let shares: Vec<String> =
        cores.iter().skip(1).map(|core| format!("{} %", written(share(core).round()))).collect();
    section.paragraph(&format!(
        "In a pipeline nothing is free: the rational curve takes {} of its core's multiplier bits, the trigonometric one {}. Table 1 does not \
         hold for hardware of its own: a GPU that waits for memory has arithmetic to spare, a pipeline for one method has not.",
        shares.first().map_or("", String::as_str),
        shares.last().map_or("", String::as_str),
    ));
    Ok(())
}

fn size_row(core: &SizedCore) -> [String; 6] {
    let size = core.design.size();
    let of = |count: fn(&Size) -> u64| match count(&core.share) {
        0 => count(&size).to_string(),
        part => format!("{}, of these {part}", count(&size)),
    };
    [
        core.name.to_owned(),
        core.design.latency().to_string(),
        of(|size| size.multipliers as u64),
        of(|size| size.multiplier_bits),
        of(|size| size.adder_bits),
        of(|size| size.register_bits),
    ]
}

//! The parts of the lecture besides claims: figure 5, and its programming project.
use specula_experiments::reproduce::lecture::increments::{IncrementCost, costs};
use specula_experiments::reproduce::lecture::quadrilateral::{Shading, pictures};
use specula_scene::{Needs, load};
use specula_spec::{CoreSpec, Increments, Method};
use specula_testbench::BenchError;

use super::section::Section;
use crate::error::ToolError;
use crate::picture::{Panel, side_by_side};

/// The algorithms whose speeds the project compares.
const ALGORITHMS: [(&str, Method); 4] = [
    ("Gouraud shading", Method::Gouraud),
    ("naive Phong shading", Method::Phong),
    ("fast Phong shading", Method::Direct),
    ("Phong shading by slerp", Method::Slerp),
];

/// Adds these parts to the section.
pub fn add(section: &mut Section) -> Result<(), ToolError> {
    square(section);
    project(section)?;
    increments(section)
}

fn square(section: &mut Section) {
    section.heading(3, "Figure 5: a square and the scan lines");
    section.paragraph(
        "Three corners of the square are white and the lower one is grey. Interpolated along edges and scan lines, the upper half is white; with \
         the scan lines turned by 90 degrees (the picture is turned back) the same half is grey. Phong shading has it too, with normals.",
    );
    let panels: Vec<Panel> = [Shading::Gouraud, Shading::Phong]
        .into_iter()
        .flat_map(pictures)
        .map(|(title, picture)| Panel::new(title, &picture))
        .collect();
    section.picture("The lecture's figure 5", "lecture_figure5", side_by_side(&panels));
}

/// How the project's software is timed.
const TIMED: &str = "`specula reproduce project` times the algorithms in software, with Hast's and Reshetov's beside them: [project.md](project.md).";

fn project(section: &mut Section) -> Result<(), ToolError> {
    section.heading(3, "The project: relative speeds in software");
    section.paragraph(TIMED);
    section.heading(3, "The project: relative speeds, in hardware");
    section.paragraph(
        "Cores for the teapot, one light. All take a pixel in every clock, whatever the algorithm: what is slow in software is large in hardware.",
    );
    let frame = load("teapot", Some((640, 480)))?.frame;
    let needs = Needs::of(&frame);
    let row = |(name, method): (&str, Method)| -> Result<[String; 6], BenchError> {
        let spec = CoreSpec::for_scene(&needs, None, Some(method))?.specialised(&frame);
        let design = specula_hdl::elaborate(&spec, "core")?;
        let size = design.size();
        Ok([
            name.to_owned(),
            format!("`{}`", method.name()),
            "1".to_owned(),
            design.latency().to_string(),
            format!("{} ({} bits)", size.multipliers, size.multiplier_bits),
            size.register_bits.to_string(),
        ])
    };
    let rows: Vec<[String; 6]> = ALGORITHMS.into_iter().map(row).collect::<Result<_, _>>()?;
    section.table(
        ["algorithm", "core", "cycles a pixel", "latency", "multipliers", "register bits"],
        &rows,
    );
    Ok(())
}

fn increments(section: &mut Section) -> Result<(), ToolError> {
    section.heading(3, "Increments, multiplied and added");
    section.paragraph(
        "The papers add increments: N ← N + ΔN, J ← J + ΔJ. A core may multiply them by a weight that all values of a span share instead. Cores \
         for the teapot at 640 x 480 on an ECP5 at 250 MHz, each in the cheapest formats found for which it is faithful; cells are this \
         program's own estimate, without synthesis. `direct` adds J and K, and makes N·N of the weight; `duff`, the same formulas, adds that \
         too, by second differences.",
    );
    let costs = costs(&load("teapot", Some((640, 480)))?.frame)?;
    let rows: Vec<[String; 10]> = costs.iter().map(increment_row).collect();
    section.table(
        [
            "core",
            "increments",
            "blocks",
            "look-up tables",
            "flip-flops",
            "register bits",
            "latency",
            "packet, bits",
            "bound, LSB",
            "measured, LSB",
        ],
        &rows,
    );
    Ok(())
}

fn increment_row(cost: &IncrementCost) -> [String; 10] {
    let increments = match cost.increments {
        Increments::Multiplied => "multiplied",
        Increments::Added => "added",
    };
    [
        format!("`{}`", cost.method.name()),
        increments.to_owned(),
        cost.resources.blocks.to_string(),
        cost.resources.luts.to_string(),
        cost.resources.flip_flops.to_string(),
        cost.register_bits.to_string(),
        cost.latency.to_string(),
        cost.packet_bits.to_string(),
        format!("{:.3}", cost.bound),
        format!("{:.3}", cost.quantisation_lsb),
    ]
}

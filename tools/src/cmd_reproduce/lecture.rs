//! The part of the lecture besides claims: the hardware of its programming project.
use specula_scene::{Needs, load};
use specula_spec::{CoreSpec, Method};
use specula_testbench::BenchError;

use super::section::Section;
use crate::error::ToolError;

/// The algorithms whose speeds the project compares.
const ALGORITHMS: [(&str, Method); 4] = [
    ("Gouraud shading", Method::Gouraud),
    ("naive Phong shading", Method::Phong),
    ("fast Phong shading", Method::Direct),
    ("Phong shading by slerp", Method::Slerp),
];

/// Adds this part to the section.
pub fn add(section: &mut Section) -> Result<(), ToolError> {
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

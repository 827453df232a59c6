//! `specula reproduce`: the claims and figures of the papers, computed.
mod document;
mod figure9;
mod figures;
mod gates;
mod hast;
mod lecture;
mod page;
mod pictured_mesh;
mod project;
mod reshetov;
mod section;

use std::io::Write;
use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Subcommand};
use specula_experiments::reproduce::Paper;

use crate::error::ToolError;
use crate::output::Interrupts;
use crate::verdict::Verdict;
use page::Page;
use pictured_mesh::PicturedMesh;
use section::Section;

const EXAMPLE: &str = "\
Evaluates the papers' claims with this program's own exact shading and with its cores, compares the \
numbers with the project's independent measurements, and says whether each claim holds; draws the \
papers' figures and pictures. Writes DIR/reproduction.md and DIR/images/. `specula reproduce figure9` \
shades Lyon's figure 9 with a core for each of its twelve rows, in a folder of its own; `specula \
reproduce project` times the papers' loops; `specula reproduce gates` counts the gates of Lyon's \
datapaths and of standard Phong shading.

Exit status: 0 if every number is the one measured before, 1 if not.

Example: specula reproduce hast --mesh venus.ply -o out/reproduce";

/// Arguments of `reproduce`.
#[derive(Clone, Debug, Args)]
#[command(
    after_help = EXAMPLE,
    args_conflicts_with_subcommands = true,
    disable_help_subcommand = true
)]
pub struct Arguments {
    #[command(subcommand)]
    part: Option<Part>,
    /// The paper [default: all of them]
    #[arg(value_parser = paper_parser())]
    paper: Option<Paper>,
    /// Mesh for Hast's pictures, and an additional one for Reshetov's (.obj, .ply, .stl, .glb)
    /// [default: the teapot]
    #[arg(long, value_name = "FILE")]
    mesh: Option<PathBuf>,
    /// Folder to write into, in addition to printing the text
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// What takes longer or has options of its own.
#[derive(Clone, Debug, Subcommand)]
enum Part {
    /// Shade Lyon's figure 9 with twelve cores, one for each of its rows
    Figure9(figure9::Arguments),
    /// Time the papers' loops on three models, as the lecture's project 1 asks
    Project(project::Arguments),
    /// Count the gates and cells of Lyon's datapaths and of standard Phong shading at equal error
    Gates(gates::Arguments),
}

fn paper_parser() -> impl TypedValueParser<Value = Paper> {
    PossibleValuesParser::new(Paper::ALL.map(Paper::name)).try_map(|name| {
        Paper::ALL.into_iter().find(|paper| paper.name() == name).ok_or("there is no such paper")
    })
}

/// Computes, writes and prints the papers' claims, or shades a figure.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    match &arguments.part {
        Some(Part::Figure9(figure)) => figure9::execute(figure, stdout, interrupts),
        Some(Part::Project(project)) => project::execute(project, stdout, interrupts),
        Some(Part::Gates(gates)) => gates::execute(gates, stdout, interrupts),
        None => claims(arguments, stdout, interrupts),
    }
}

fn claims(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let mesh = PicturedMesh::load(arguments.mesh.as_deref())?;
    let papers: Vec<Paper> = arguments.paper.map_or(Paper::ALL.into(), |paper| vec![paper]);
    let sections: Vec<Section> =
        papers.into_iter().map(|paper| section(paper, &mesh)).collect::<Result<_, _>>()?;
    let page = Page {
        name: document::NAME,
        head: document::HEAD,
        text: document::text(&sections),
        pictures: sections.iter().flat_map(|section| &section.files).collect(),
    };
    page.give(arguments.output.as_deref(), stdout, interrupts)?;
    Ok(if sections.iter().all(|section| section.as_expected) {
        Verdict::Done
    } else {
        Verdict::Disagrees
    })
}

/// What the section about Lyon's report says besides claims and plots.
const LYON: &str = "`specula reproduce figure9` shades figure 9, the twelve formulations on five spheres, with a core for each row: [figure9.md](figure9.md). `specula reproduce gates` counts what his datapaths and standard Phong shading take in gates, look-up tables and blocks at equal error: [gates.md](gates.md).";

fn section(paper: Paper, mesh: &PicturedMesh) -> Result<Section, ToolError> {
    let mut section = Section::of(paper)?;
    match paper {
        Paper::Lyon => section.paragraph(LYON),
        Paper::Hast => hast::add(&mut section, mesh)?,
        Paper::Lecture => lecture::add(&mut section)?,
        Paper::Reshetov => reshetov::add(&mut section, mesh)?,
    }
    Ok(section)
}

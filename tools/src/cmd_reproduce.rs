//! `specula reproduce`: the claims and figures of the papers, computed.
mod document;
mod figure9;
mod figures;
mod hast;
mod lecture;
mod pictured_mesh;
mod reshetov;
mod section;

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Subcommand};
use specula_experiments::reproduce::Paper;
use specula_scene::regular::read_regular;

use crate::error::ToolError;
use crate::output::{Interrupts, OutputError, write_file};
use crate::verdict::Verdict;
use pictured_mesh::PicturedMesh;
use section::Section;

const EXAMPLE: &str = "\
Evaluates the papers' claims with this program's own exact shading and with its cores, compares the \
numbers with the project's independent measurements, and says whether each claim holds; draws the \
papers' figures and pictures. Writes DIR/reproduction.md and DIR/images/. `specula reproduce figure9` \
shades Lyon's figure 9 with a core for each of its twelve rows, in a folder of its own.

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
    figure: Option<Figure>,
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

/// Figures that cores shade, each with its own options.
#[derive(Clone, Debug, Subcommand)]
enum Figure {
    /// Shade Lyon's figure 9 with twelve cores, one for each of its rows
    Figure9(figure9::Arguments),
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
    match &arguments.figure {
        Some(Figure::Figure9(figure)) => figure9::execute(figure, stdout, interrupts),
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
    let text = document::text(&sections);
    if let Some(folder) = &arguments.output {
        write_files(folder, &sections, &text, interrupts)?;
    }
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(if sections.iter().all(|section| section.as_expected) {
        Verdict::Done
    } else {
        Verdict::Disagrees
    })
}

/// Name of the file with the text.
const TEXT: &str = "reproduction.md";
/// Largest file, in bytes, that may be a text of this command's.
const LONGEST_TEXT: u64 = 16 << 20;

fn write_files(
    folder: &Path,
    sections: &[Section],
    text: &str,
    interrupts: &Interrupts,
) -> Result<(), ToolError> {
    let pictures = || sections.iter().flat_map(|section| &section.files);
    let place = |file: &section::File| Path::new(section::IMAGES).join(&file.name);
    refuse_foreign(folder, pictures().map(place).chain([PathBuf::from(TEXT)]))?;
    // The text is written last, so that it shows no picture that is missing.
    for file in pictures() {
        write_file(&folder.join(place(file)), interrupts, |path| file.write(path))?;
    }
    Ok(write_file(&folder.join(TEXT), interrupts, |path| std::fs::write(path, text))?)
}

/// Refuses to replace files of these names unless a text that this command wrote is there too.
fn refuse_foreign(
    folder: &Path,
    mut names: impl Iterator<Item = PathBuf>,
) -> Result<(), OutputError> {
    let earlier = read_regular(&folder.join(TEXT), LONGEST_TEXT);
    if earlier.is_ok_and(|text| text.starts_with(document::HEAD.as_bytes())) {
        return Ok(());
    }
    match names.find(|name| folder.join(name).symlink_metadata().is_ok()) {
        Some(name) => Err(OutputError::InTheWay {
            folder: folder.to_owned(),
            name: name.display().to_string(),
        }),
        None => Ok(()),
    }
}

/// What the section about Lyon's report says besides claims and plots.
const LYON: &str = "`specula reproduce figure9` shades figure 9, the twelve formulations on five spheres, with a core for each row: [figure9.md](figure9.md).";

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

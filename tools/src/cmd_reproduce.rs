//! `specula reproduce`: what the papers claim and show, computed.
mod document;
mod figure9;
mod figures;
mod hast;
mod lecture;
mod lyon;
mod reshetov;
mod section;
mod subject;

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Subcommand};
use specula_experiments::reproduce::Paper;
use specula_scene::regular::read_regular;

use crate::error::ToolError;
use crate::output::{Interrupts, OutputError, write_file};
use crate::verdict::Verdict;
use section::Section;
use subject::Subject;

const EXAMPLE: &str = "\
Computes what the papers claim with this program's own exact shading and with its cores, compares \
it with the project's independent measurements, and says of each claim whether it holds; draws the \
papers' figures and pictures. Writes DIR/reproduction.md and DIR/images/. `specula reproduce figure9` \
shades Lyon's figure 9 with a core for each of its twelve rows, in a folder of its own.

Exit status: 0 if every number is as measured before, 1 if not.

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
    /// The mesh of Hast's pictures, and one more of Reshetov's (.obj, .ply, .stl, .glb) [default:
    /// the teapot]
    #[arg(long, value_name = "FILE")]
    mesh: Option<PathBuf>,
    /// Folder to write into, besides printing the text
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Figures that cores shade, each with options of its own.
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

/// Computes, writes and prints what papers claim, or shades a figure.
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
    let subject = Subject::load(arguments.mesh.as_deref())?;
    let papers: Vec<Paper> = arguments.paper.map_or(Paper::ALL.into(), |paper| vec![paper]);
    let sections: Vec<Section> =
        papers.into_iter().map(|paper| section(paper, &subject)).collect::<Result<_, _>>()?;
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

/// The text's file.
const TEXT: &str = "reproduction.md";
/// The longest text that is taken for one of ours, in bytes.
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
    // The text last: it shows no picture that is not there.
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

fn section(paper: Paper, subject: &Subject) -> Result<Section, ToolError> {
    let mut section = Section::of(paper)?;
    match paper {
        Paper::Lyon => lyon::add(&mut section),
        Paper::Hast => hast::add(&mut section, subject)?,
        Paper::Lecture => lecture::add(&mut section)?,
        Paper::Reshetov => reshetov::add(&mut section, subject)?,
    }
    Ok(section)
}

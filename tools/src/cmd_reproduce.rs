//! `specula reproduce`: what the papers claim and show, computed.
mod document;
mod figures;
mod hast;
mod lecture;
mod lyon;
mod reshetov;
mod section;
mod subject;

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use specula_testbench::reproduce::Paper;

use crate::cli::Verdict;
use crate::error::ToolError;
use crate::output::write_file;
use section::Section;
use subject::Subject;

const EXAMPLE: &str = "\
Computes what the papers claim with this program's own exact shading and with its cores, compares
it with the project's independent measurements, and says of each claim whether it holds; draws the
papers' figures and pictures. Writes DIR/reproduction.md and DIR/images/.

Exit status: 0 if every number is as measured before, 1 if not.

Example: specula reproduce hast --mesh venus.ply -o out/reproduce";

/// Arguments of `reproduce`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// The paper [default: all of them]
    #[arg(value_parser = paper_parser())]
    paper: Option<Paper>,
    /// The mesh of Hast's pictures, and one more of Reshetov's (.obj, .ply, .stl, .glb) [default: the teapot]
    #[arg(long, value_name = "FILE")]
    mesh: Option<PathBuf>,
    /// Folder to write into, beside printing the text
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

fn paper_parser() -> impl TypedValueParser<Value = Paper> {
    PossibleValuesParser::new(Paper::ALL.map(Paper::name))
        .try_map(|name| Paper::ALL.into_iter().find(|paper| paper.name() == name).ok_or("there is no such paper"))
}

/// Computes, writes and prints.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let subject = Subject::load(arguments.mesh.as_deref())?;
    let papers: Vec<Paper> = arguments.paper.map_or(Paper::ALL.into(), |paper| vec![paper]);
    let sections: Vec<Section> = papers.into_iter().map(|paper| section(paper, &subject)).collect::<Result<_, _>>()?;
    let text = document::text(&sections);
    if let Some(folder) = &arguments.output {
        // The text last: it shows no picture that is not there.
        for file in sections.iter().flat_map(|section| &section.files) {
            write_file(&folder.join(section::IMAGES).join(&file.name), |path| file.write(path))?;
        }
        write_file(&folder.join("reproduction.md"), |path| std::fs::write(path, &text))?;
    }
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(if sections.iter().all(|section| section.as_expected) { Verdict::Done } else { Verdict::Disagrees })
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

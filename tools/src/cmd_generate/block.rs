//! `--ip`: the core as a block for a design, with streams, registers, vectors and a bench.
use std::convert::Infallible;

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use specula_datapath::Design;
use specula_flow::host::{self, ExampleSpan, HostCode};
use specula_flow::stream::{self, File, StreamShape};
use specula_spec::{Positions, WordWidth};

use crate::error::ToolError;
use crate::frame_vectors::frame_vectors;
use crate::html::{self, ReportFiles};
use crate::job::Job;
use crate::stream_top::stream_core;

/// Arguments of a block.
#[derive(Clone, Debug, Args)]
pub struct BlockArguments {
    /// Write a block for a design: AXI4-Stream and AXI4-Lite around the core, vectors, a bench
    #[arg(long)]
    pub ip: bool,
    /// Bits of a packet's words [default: 32]
    #[arg(long, value_name = "BITS", requires = "ip", value_parser = word_parser())]
    word: Option<WordWidth>,
    /// Packets and pixels have their position in the picture
    #[arg(long, requires = "ip")]
    positions: bool,
    /// Vectors of the first N spans only [default: the whole frame]
    #[arg(long, value_name = "N", requires = "ip", value_parser = clap::value_parser!(u32).range(1..))]
    spans: Option<u32>,
    /// The scene whose spans are the vectors of a core that a spec.toml describes
    #[arg(long, value_name = "SCENE", requires = "ip")]
    pub vectors: Option<String>,
}

fn word_parser() -> impl TypedValueParser<Value = WordWidth> {
    PossibleValuesParser::new(["32", "64"])
        .map(|bits| if bits == "32" { WordWidth::Bits32 } else { WordWidth::Bits64 })
}

impl BlockArguments {
    /// Names and texts of the block's files, without the core's own.
    ///
    /// # Errors
    /// [`ToolError::NoVectors`] if the scene has no spans, and as [`stream_core`].
    pub fn files(&self, job: &Job, design: &Design) -> Result<Vec<(String, String)>, ToolError> {
        let core = stream_core(job, design, self.shape())?;
        let command = format!("{} --ip{}", job.origin.command, self.in_words());
        let asked = self.spans.map_or(usize::MAX, |spans| spans as usize);
        let vectors = frame_vectors(job, asked)?;
        let frame = &job.scene.frame;
        let is_last = vectors.spans.len() == 1;
        let example = ExampleSpan { frame, span: &frame.spans[0], is_last };
        let code = HostCode::new(&core);
        let mut files = stream::files(&core, &[vectors], &command, code.call());
        files.extend(host::files(&code, &example));
        let page = data_sheet(core.name(), &files);
        Ok(files.into_iter().chain([page]).map(|file| (file.name, file.text)).collect())
    }

    fn shape(&self) -> StreamShape {
        let positions = if self.positions { Positions::Sent } else { Positions::Absent };
        StreamShape { word: self.word.unwrap_or(WordWidth::Bits32), positions }
    }

    /// The arguments as words of a command, but for the scene of vectors.
    fn in_words(&self) -> String {
        let word = self.word.map(|word| format!(" --word {}", word.bits())).unwrap_or_default();
        let positions = if self.positions { " --positions" } else { "" };
        let spans = self.spans.map(|spans| format!(" --spans {spans}")).unwrap_or_default();
        format!("{word}{positions}{spans}")
    }
}

/// The data sheet for browsers, with its drawings embedded.
fn data_sheet(core: &str, files: &[File]) -> File {
    let markdown = files.iter().find(|file| file.name == format!("{core}.md"));
    let text = markdown.map_or("", |file| &file.text);
    // The comment in its first line tells whose file it is, which the page does itself.
    let (about, text) = text.split_once('\n').unwrap_or_default();
    let Ok(body) = html::render(text, &InMemory(files));
    let page = html::page(&format!("{core}_ip"), &body);
    File { name: format!("{core}.html"), text: format!("{about}\n{page}") }
}

/// Files that have not been written yet.
struct InMemory<'a>(&'a [File]);

impl ReportFiles for InMemory<'_> {
    type Error = Infallible;

    fn content(&self, name: &str) -> Result<Option<Vec<u8>>, Infallible> {
        let file = self.0.iter().find(|file| file.name == name);
        Ok(file.map(|file| file.text.clone().into_bytes()))
    }
}

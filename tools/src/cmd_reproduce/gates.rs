//! `specula reproduce gates`: Lyon's conclusion, that his reformulation leads to simpler hardware
//! [Lyon, TR 43], counted.
mod counted;
mod text;

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use specula_flow::synth;
use specula_spec::Specialise;

use super::page::Page;
use crate::arguments::{PictureArguments, SceneArguments, parse_error, specialise_parser};
use crate::error::ToolError;
use crate::output::Interrupts;
use crate::verdict::Verdict;
use counted::Wanted;

const EXAMPLE: &str = "\
Makes cores for standard Phong shading and for Lyon's figures, each in the coarsest formats that keep \
its quantisation error within the same limit at every pixel of the scene, for any scene and for this \
one alone. Yosys maps them to two-input gates, to look-up tables without blocks, and to an ECP5 with \
its blocks: some minutes a core. Says of each claim about their size whether it holds. Writes \
DIR/gates.md.

Example: specula reproduce gates -o out/gates";

/// Arguments of `reproduce gates`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// A built-in scene (see `specula scenes`), a scene file (.toml), or a mesh (.obj, .ply, .stl,
    /// .glb)
    #[arg(default_value = "teapot")]
    scene: String,
    #[command(flatten)]
    picture: PictureArguments,
    /// Largest quantisation error of every core at every pixel, in LSBs
    #[arg(long, value_name = "LSB", default_value = "1lsb", allow_hyphen_values = true, value_parser = parse_error)]
    max_quantisation: f64,
    /// Cores for this scene alone, or general ones [default: both]
    #[arg(long, value_name = "FOR", value_parser = specialise_parser())]
    specialise: Option<Specialise>,
    /// An exponent of all materials, 1 to 8191, with which general cores are made too; may be given
    /// several times
    #[arg(long, value_name = "N", default_value = "1000", value_parser = clap::value_parser!(u32).range(1..=8191))]
    exponent: Vec<u32>,
    /// Folder to write into, in addition to printing the text
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// Counts every core in every case, writes the page and prints it.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    // Before minutes go by.
    let synthesiser = synth::synthesiser()?;
    let scene =
        SceneArguments { scene: arguments.scene.clone(), picture: arguments.picture.clone() };
    let scene = scene.load_frame()?;
    let wanted = Wanted {
        most: arguments.max_quantisation,
        specialise: arguments.specialise,
        exponents: &arguments.exponent,
    };
    let cases = wanted.cases(&scene.frame)?;
    let text = text::of(&scene.name, arguments.max_quantisation, &cases, &synthesiser);
    let page = Page { name: NAME, head: text::HEAD, text, pictures: vec![] };
    page.give(arguments.output.as_deref(), stdout, interrupts)?;
    Ok(Verdict::Done)
}

/// Name of the page's file.
const NAME: &str = "gates.md";

//! `specula generate`: a core's Verilog without simulating it.
mod block;

use std::io::Write;
use std::path::Path;

use clap::Args;
use specula_spec::SpecFile;
use specula_testbench::BenchError;

use crate::arguments::{NameArguments, OutputArguments};
use crate::error::ToolError;
use crate::job::{Job, SceneOrSpec};
use crate::output::{Interrupts, write_core};
use crate::verdict::Verdict;
use crate::verilog::{self, Origin};
use block::BlockArguments;

const EXAMPLE: &str = "\
Writes DIR/NAME.v, Verilog-2001 with one module per unit, and DIR/spec.toml, from which the same \
core can be made again. Other files in DIR stay. `-o -` writes only the Verilog, to standard \
output.

With `--ip` the folder has a block for a design besides: NAME_ip.v with AXI4-Stream for packets and \
pixels and AXI4-Lite for registers, a data sheet, a self-checking bench and a cocotb test with the \
scene's spans and expected pixels, files for FuseSoC, Vivado, LiteX and make, and README.md, which \
says how to begin.

Examples:
  specula generate teapot --method hybrid --name shader -o rtl
  specula generate teapot --ip --word 64 --positions -o block";

/// Arguments of `generate`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    #[command(flatten)]
    core: SceneOrSpec,
    #[command(flatten)]
    output: OutputArguments,
    #[command(flatten)]
    name: NameArguments,
    #[command(flatten)]
    block: BlockArguments,
}

/// The argument of `--output` that stands for standard output.
const STANDARD_OUTPUT: &str = "-";

/// Writes the core and prints where it is.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let made = arguments.core.file(&arguments.name)?;
    let job = arguments.shown(&made)?;
    let (file, origin) = match &job {
        Some(job) => (job.file.clone(), job.origin.clone()),
        None => made,
    };
    let module = specula_hdl::module_name(&file.name, &file.spec);
    let design = specula_hdl::elaborate(&file.spec, &module).map_err(BenchError::from)?;
    arguments.core.made_for().fitted(&file.spec, &design)?;
    let text = verilog::text(&origin, &file.spec, &design);
    let folder = arguments.output.folder(&file.name);
    if folder == Path::new(STANDARD_OUTPUT) {
        if arguments.block.ip {
            return Err(ToolError::FolderNeeded);
        }
        write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
        return Ok(Verdict::Done);
    }
    let mut texts = vec![(verilog::file_name(&module), text)];
    if !arguments.is_spec_of(&folder) {
        texts.push((SpecFile::NAME.to_owned(), file.text()));
    }
    if let Some(job) = &job {
        texts.extend(arguments.block.files(job, &design)?);
    }
    for path in write_core(&folder, &texts, interrupts)? {
        writeln!(stdout, "{}", path.display()).map_err(ToolError::Print)?;
    }
    Ok(Verdict::Done)
}

impl Arguments {
    /// The core with the scene that its bench shows, if there is to be one.
    fn shown(&self, made: &(SpecFile, Origin)) -> Result<Option<Job>, ToolError> {
        let BlockArguments { ip, vectors, .. } = &self.block;
        ip.then(|| self.core.job(made.clone(), vectors.as_deref())).transpose()
    }

    /// Whether the given spec is the one in `folder`, which then stays as the user wrote it.
    fn is_spec_of(&self, folder: &Path) -> bool {
        let place = |path: &Path| path.canonicalize().ok();
        self.core
            .spec
            .as_ref()
            .is_some_and(|spec| place(spec) == place(&folder.join(SpecFile::NAME)))
    }
}

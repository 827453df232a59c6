//! `specula generate`: a core's Verilog without simulating it.
use std::io::Write;

use clap::Args;
use specula_testbench::Bench;

use crate::arguments::SceneArguments;
use crate::cli::Verdict;
use crate::error::ToolError;
use crate::header::Origin;
use crate::output::write_verilog;
use crate::verilog;

const EXAMPLE: &str = "\
Writes DIR/NAME.v alone: Verilog-2001, one module per unit. Other files in DIR stay.

Example: specula generate teapot --method hybrid -o rtl";

/// Arguments of `generate`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
}

/// Writes the Verilog and says where.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let (scene, spec) = arguments.scene.load()?;
    let module = specula_hdl::verilog::module_name(&scene.name);
    let bench = Bench::new(&scene.frame, &spec, &module)?;
    let text = verilog::text(&Origin::new(&arguments.scene, &spec), &spec, &bench.design);
    let path = write_verilog(&arguments.scene.folder(&scene), &verilog::file_name(&module), &text)?;
    writeln!(stdout, "{}", path.display()).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}

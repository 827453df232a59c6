//! `specula scenes`: the built-in scenes.
use std::io::Write;

use clap::Args;
use clap::builder::PossibleValuesParser;
use specula_scene::{builtin_names, builtin_text};

use crate::error::ToolError;
use crate::table;
use crate::verdict::Verdict;

const EXAMPLE: &str = "\
Example: specula scenes --show lamps > mine.toml";

/// Arguments of `scenes`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// Print the scene file of this scene
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(builtin_names()))]
    show: Option<String>,
}

/// Prints a line for each built-in scene, or the file of one.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let shown = arguments.show.as_deref().and_then(builtin_text);
    let text = shown.map_or_else(lines, str::to_owned);
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}

fn lines() -> String {
    let row = |name: &&str| [(*name).to_owned(), description(name).to_owned()];
    let rows: Vec<[String; 2]> = builtin_names().iter().map(row).collect();
    table::shown(&rows)
}

/// A description of a built-in scene.
fn description(name: &str) -> &'static str {
    match name {
        "teapot" => "Newell's teapot, one light",
        "spheres" => "the balls of Lyon's figure 9, with exponents 1 to 256, two lights",
        "torus" => "a torus, two lights; normals turn fast around its tube",
        "lamps" => "a teapot under a distant light, a lamp and a spot, seen from close by",
        "icosahedron" => {
            "twenty faces with shared normals; ends of spans are up to 63 degrees apart"
        }
        "turntable" => "the teapot, once around in 72 frames, shaded by one core",
        "sunrise" => "a torus under a light that rises, crosses it and sets, in 48 frames",
        _ => "",
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_built_in_scene_is_described() {
        for name in specula_scene::builtin_names() {
            assert!(!super::description(name).is_empty(), "{name}");
        }
    }
}

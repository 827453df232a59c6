//! `specula scenes`: the built-in scenes.
use std::io::Write;

use crate::error::ToolError;
use crate::table;
use crate::verdict::Verdict;

/// Prints a line for each built-in scene.
pub fn execute(stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let row = |name: &&str| [(*name).to_owned(), description(name).to_owned()];
    let rows: Vec<[String; 2]> = specula_scene::builtin_names().iter().map(row).collect();
    write!(stdout, "{}", table::shown(&rows)).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
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

//! What data sheets say.
use std::collections::BTreeSet;
use std::fs;

use specula_fixtures::each_method;
use specula_spec::Method;

use crate::block::{Block, core, frames, shapes};

/// The ports of the data sheet are those of the Verilog, as wide and as directed, and no place of a
/// template is left.
fn ports_are_those_of_the_verilog(method: Method) {
    let frames = frames(21);
    for (number, shape) in shapes().into_iter().enumerate() {
        let spec = core(method, &frames, number % 2 == 1);
        for spec in [spec.specialised(&frames[0]), spec] {
            let block = Block::new(&spec, &frames[..1], shape);
            let text = |name: &str| fs::read_to_string(block.path(name)).expect("it is there");
            let (sheet, verilog) = (text("shader.md"), text("shader_ip.v"));
            let told: BTreeSet<Port> = section(&sheet, "Ports").lines().filter_map(told).collect();
            let built: BTreeSet<Port> = verilog.lines().filter_map(built).collect();
            assert_eq!(told, built);
            assert_eq!(built.len(), 28);
            for name in block.names() {
                let text = text(&name);
                let place = text.split('@').skip(1).find(|word| is_place(word));
                assert!(place.is_none(), "{name}: @{}", place.unwrap_or_default());
            }
        }
    }
}

each_method!(ports_are_those_of_the_verilog);

/// Name, direction and width.
type Port = (String, String, u32);

/// The text of a chapter.
fn section<'t>(sheet: &'t str, title: &str) -> &'t str {
    let begin = sheet.find(&format!("\n## {title}\n")).expect("there is such a chapter");
    let rest = &sheet[begin + 1..];
    rest.find("\n## ").map_or(rest, |end| &rest[..end])
}

/// The port of a table's row.
fn told(line: &str) -> Option<Port> {
    let cells: Vec<&str> = line.strip_prefix("| `")?.split(" | ").collect();
    let bits = cells[2].parse().expect("bits are a number");
    Some((cells[0].trim_end_matches('`').to_owned(), cells[1].to_owned(), bits))
}

/// The port of a line of Verilog.
fn built(line: &str) -> Option<Port> {
    let (direction, rest) = line.strip_prefix("    ")?.split_once("put ")?;
    let rest = rest.trim_start().strip_prefix("wire")?;
    let rest = rest.split("//").next()?.trim().trim_end_matches(',');
    let (bits, name) = match rest.strip_prefix('[') {
        Some(vector) => {
            let (top, name) = vector.split_once(":0]")?;
            (top.parse::<u32>().ok()? + 1, name)
        }
        None => (1, rest),
    };
    Some((name.trim().to_owned(), direction.to_owned(), bits))
}

/// Whether words behind an `@` are a name that should have been filled in.
fn is_place(words: &str) -> bool {
    let name = words.trim_end_matches(char::is_whitespace);
    name.len() > 1 && name.chars().all(|c| c.is_ascii_uppercase() || c == '_' || c.is_ascii_digit())
}

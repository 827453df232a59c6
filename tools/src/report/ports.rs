//! The table of a core's ports.
use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_spec::CoreSpec;

/// Rows of name, direction, width, format and meaning: control, the inputs of a span, and the
/// output pixel.
pub fn rows(spec: &CoreSpec, design: &Design) -> Vec<[String; 5]> {
    let control = |name: &str, direction: &str, meaning: &str| {
        [name.to_owned(), direction.to_owned(), "1".to_owned(), String::new(), meaning.to_owned()]
    };
    let name = |node: NodeId| code(&design.node(node).name);
    let mut rows = vec![
        control("`clock`", "in", "rising edge"),
        control("`reset`", "in", "synchronous; clears validity"),
        control(&name(design.valid), "in", "a pixel enters"),
        control(&name(design.start), "in", "it is the first of its span"),
    ];
    let built = spec
        .inputs()
        .into_iter()
        .zip(&design.inputs)
        .filter_map(|(port, node)| node.map(|node| (port, node)));
    rows.extend(built.map(|(port, node)| {
        let range =
            format!("{} to {}", port.format.value(port.range.0), port.format.value(port.range.1));
        let held = if design.node(node).still { "; holds for the frame" } else { "" };
        data(design, node, "in", format!("{range}{held}"))
    }));
    rows.push(control(&name(design.valid_out), "out", "a pixel leaves"));
    rows.extend(
        design.outputs.iter().map(|&node| data(design, node, "out", "8-bit code".to_owned())),
    );
    rows
}

fn data(design: &Design, node: NodeId, direction: &str, meaning: String) -> [String; 5] {
    let node = design.node(node);
    [
        code(&node.name),
        direction.to_owned(),
        node.width().to_string(),
        node.format().to_string(),
        meaning,
    ]
}

fn code(name: &str) -> String {
    format!("`{name}`")
}

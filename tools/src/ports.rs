//! A core's ports: what each is, and how a host computes what goes in.
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_spec::{CoreSpec, InputMeaning, InputPort};

/// A port of a core. It serialises as an entry of `report.json`.
#[derive(Clone, Debug, Serialize)]
pub struct Port {
    /// Its name.
    pub name: String,
    /// `in` or `out`.
    pub direction: &'static str,
    /// Its width.
    pub bits: u32,
    /// Its format; none of a single bit that is no number.
    pub format: Option<String>,
    /// Smallest and largest value that it is given, or that it gives; none of a single bit that is
    /// no number.
    pub range: Option<[f64; 2]>,
    /// `clock`, `span` or `frame`: for how long it stands still.
    pub held_for: &'static str,
    /// Unit of the value; `1` of a number without one.
    pub unit: &'static str,
    /// What it is.
    pub meaning: String,
    /// How the host computes it, before it is rounded to the format; none of what it does not
    /// compute.
    pub computed: Option<String>,
}

/// The ports of a core: control, the inputs of a frame or a span, and the pixel that leaves with
/// its directions.
pub fn ports(spec: &CoreSpec, design: &Design) -> Vec<Port> {
    let name = |node: NodeId| design.node(node).name.as_str();
    let mut ports = vec![
        control("clock", "in", "rising edge"),
        control("reset", "in", "synchronous; clears validity"),
        control(name(design.valid), "in", "a pixel enters"),
        control(name(design.start), "in", "it is the first of its span"),
    ];
    ports.extend(inputs(spec, design));
    ports.push(control(name(design.valid_out), "out", "a pixel leaves"));
    let codes = [("LSB", "8-bit code"); 3];
    let directions = spec.direction_outputs().iter().flat_map(|output| [("1", output.meaning); 3]);
    let about = codes.into_iter().chain(directions);
    ports.extend(design.outputs.iter().zip(about).map(|(&id, about)| output(design, id, about)));
    ports
}

/// The data inputs that the hardware has.
pub fn inputs(spec: &CoreSpec, design: &Design) -> Vec<Port> {
    let all = spec.inputs().into_iter().zip(spec.input_meanings()).zip(&design.inputs);
    let built = all.filter_map(|(of_spec, node)| node.map(|node| (of_spec, node)));
    built.map(|((port, meaning), node)| input(design, node, &port, meaning)).collect()
}

fn input(design: &Design, node: NodeId, port: &InputPort, meaning: InputMeaning) -> Port {
    let node = design.node(node);
    Port {
        name: node.name.clone(),
        direction: "in",
        bits: node.width(),
        format: Some(node.format().to_string()),
        range: Some([port.format.value(port.range.0), port.format.value(port.range.1)]),
        held_for: if node.still { "frame" } else { "span" },
        unit: meaning.unit,
        meaning: meaning.what.into_owned(),
        computed: Some(meaning.computed.into_owned()),
    }
}

fn output(design: &Design, node: NodeId, (unit, meaning): (&'static str, &str)) -> Port {
    let node = design.node(node);
    Port {
        name: node.name.clone(),
        direction: "out",
        bits: node.width(),
        format: Some(node.format().to_string()),
        range: Some([node.format().value(node.range.low), node.format().value(node.range.high)]),
        held_for: "clock",
        unit,
        meaning: meaning.to_owned(),
        computed: None,
    }
}

fn control(name: &str, direction: &'static str, meaning: &str) -> Port {
    Port {
        name: name.to_owned(),
        direction,
        bits: 1,
        format: None,
        range: None,
        held_for: "clock",
        unit: "",
        meaning: meaning.to_owned(),
        computed: None,
    }
}

impl Port {
    /// Titles of [`Port::row`].
    pub const TITLES: [&'static str; 9] = [
        "port",
        "direction",
        "bits",
        "format",
        "range",
        "held for",
        "unit",
        "meaning",
        "computed by the host as",
    ];

    /// A row of a table for people.
    pub fn row(&self) -> [String; 9] {
        [
            format!("`{}`", self.name),
            self.direction.to_owned(),
            self.bits.to_string(),
            self.format.clone().unwrap_or_default(),
            self.range.map(|[low, high]| format!("{low} to {high}")).unwrap_or_default(),
            format!("a {}", self.held_for),
            self.unit.to_owned(),
            self.meaning.clone(),
            self.computed.clone().unwrap_or_default(),
        ]
    }
}

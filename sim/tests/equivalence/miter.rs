//! A core for one scene beside the general one, in one module that says whether they agree.
use std::fmt::Write;

use specula_hdl::Design;
use specula_hdl::design::NodeId;
use specula_hdl::verilog::{self, Header};
use specula_scene::CoreSpec;
use specula_scene::spec::Given;

/// Both cores, and what inputs are given.
pub struct Miter<'a> {
    spec: &'a CoreSpec,
    general: Design,
    special: Design,
    /// What holds of inputs beside the ranges that the spec gives, as Verilog.
    facts: &'a str,
}

/// Pixels of the span that both are given.
const PIXELS: u32 = 3;

impl<'a> Miter<'a> {
    pub fn new(spec: &'a CoreSpec, facts: &'a str) -> Miter<'a> {
        let [general, special] = [("general", &spec.general()), ("special", spec)]
            .map(|(name, spec)| specula_hdl::elaborate(spec, name).expect("widths are small"));
        assert!(special.latency() <= general.latency());
        Miter { spec, general, special, facts }
    }

    /// Files by name: both cores, the miter, and the script that proves it.
    pub fn files(&self, given: &[String]) -> [(&'static str, String); 4] {
        let print = |design: &Design| verilog::print(&design.to_block(), &Header { lines: vec!["A core.".into()] });
        let files = [("general.v", print(&self.general)), ("special.v", print(&self.special))];
        let [general, special] = files;
        [general, special, ("miter.v", self.module(given)), ("prove.ys", self.script())]
    }

    /// What the spec says of inputs, as Verilog.
    pub fn given(&self) -> Vec<String> {
        let of = |(name, given): (String, &Given)| match given {
            Given::Between([low, high]) => format!("{name} >= {low} && {name} <= {high}"),
            Given::SameAs(twin) => format!("{name} == {twin}"),
        };
        let ports = self.spec.inputs().into_iter();
        let known = ports.filter_map(|port| Some((port.name.clone(), self.spec.specialisation.of(&port.name)?)));
        known.map(of).chain((!self.facts.is_empty()).then(|| self.facts.to_owned())).collect()
    }

    /// What comes in with the first clock is anything, and is kept; a span of it goes in from then on.
    fn module(&self, given: &[String]) -> String {
        let ports: Vec<_> = self.general.inputs.iter().flatten().map(|&id| port(&self.general, id)).collect();
        let whole: String = ports.iter().map(|(name, width, _)| format!(", input [{}:0] {name}_given", width - 1)).collect();
        let mut text = format!("module miter(input clock{whole}, output holds);\n");
        text += "  reg first = 1;\n  always @(posedge clock) first <= 0;\n";
        for (name, width, sign) in ports {
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "  reg [{0}:0] {name}_kept;\n  wire {sign}[{0}:0] {name} = first ? {name}_given : {name}_kept;\n  \
                 always @(posedge clock) {name}_kept <= {name};",
                width - 1
            );
        }
        let wait = self.general.latency() - self.special.latency();
        for (k, colour) in ["red", "green", "blue"].into_iter().enumerate() {
            let (_, width, _) = port(&self.special, self.special.outputs[k]);
            let _ = writeln!(text, "  wire [7:0] general_{colour};\n  wire [{}:0] {colour}_0;", width - 1);
            for clock in 1..=wait {
                let before = clock - 1;
                let _ = writeln!(
                    text,
                    "  reg [7:0] {colour}_{clock};\n  always @(posedge clock) {colour}_{clock} <= {colour}_{before};"
                );
            }
        }
        text += &instance(&self.general, "general", |colour| format!("general_{colour}"));
        text += &instance(&self.special, "special", |colour| format!("{colour}_0"));
        let given: String = given.iter().map(|fact| format!(" && ({fact})")).collect();
        let equal = ["red", "green", "blue"].map(|colour| format!("general_{colour} == {colour}_{wait}")).join(" && ");
        let _ = writeln!(text, "  wire given = 1{given};\n  assign holds = !given || ({equal});\nendmodule");
        text
    }

    /// Before the span goes in registers hold anything. What leaves behind the latency is the span.
    fn script(&self) -> String {
        let read = |core: &str| format!("read_verilog {core}.v\nprep -flatten -top {core}\ndesign -stash {core}\n");
        let latency = self.general.latency();
        format!(
            "{}{}design -copy-from general general\ndesign -copy-from special special\nread_verilog miter.v\n\
             prep -flatten -top miter\nopt -full\n\
             sat -seq {} -prove-skip {latency} -prove holds 1 -set-init first 1 -verify miter\n",
            read("general"),
            read("special"),
            latency + PIXELS
        )
    }
}

/// Name, width and `signed` of a port.
fn port(design: &Design, id: NodeId) -> (&str, u32, &'static str) {
    let node = design.node(id);
    (&node.name, node.width(), if node.range.signed() { "signed " } else { "" })
}

/// A core whose inputs and codes are called as they are, codes but for `code`.
fn instance(design: &Design, core: &str, code: impl Fn(&str) -> String) -> String {
    let inputs = design.inputs.iter().flatten().map(|&id| design.node(id));
    // A port may be narrower than the register it reads, whose other bits are then 0 or copies of the sign.
    let inputs = inputs.map(|node| format!(".{0}({0}[{1}:0])", node.name, node.width() - 1));
    let codes = ["red", "green", "blue"].map(|colour| format!(".{colour}({})", code(colour)));
    let ports: Vec<String> = inputs.chain(codes).collect();
    format!("  {core} {core}_core(.clock(clock), .reset(1'b0), .valid(1'b1), .start(first), {});\n", ports.join(", "))
}

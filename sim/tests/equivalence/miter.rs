//! A core for one scene beside the general one, in one module that says whether they agree.
use std::fmt::Write;

use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_datapath::verilog::{self, Header, LongDelays};
use specula_spec::{CoreSpec, Given};

/// Both cores, and what inputs are given.
pub struct Miter<'a> {
    spec: &'a CoreSpec,
    general: Design,
    special: Design,
    /// What holds of inputs beside the ranges that the spec gives, as Verilog.
    facts: &'a str,
}

/// Pixels of the span that both are given, where there is feedback.
const PIXELS: u32 = 3;

/// Seconds after which Yosys gives up: no proof.
const SECONDS: u32 = 100;

/// A register for Yosys's `techmap` that is a wire.
const WIRE: &str = "\
(* techmap_celltype = \"$dff\" *)
module wire_for_register #(parameter WIDTH = 1, parameter CLK_POLARITY = 1) (input CLK, input [WIDTH-1:0] D, output [WIDTH-1:0] Q);
  assign Q = D;
endmodule
";

impl<'a> Miter<'a> {
    pub fn new(spec: &'a CoreSpec, facts: &'a str) -> Miter<'a> {
        let [general, special] = [("general", &spec.general()), ("special", spec)]
            .map(|(name, spec)| specula_hdl::elaborate(spec, name).expect("widths are small"));
        assert!(special.latency() <= general.latency());
        Miter { spec, general, special, facts }
    }

    /// Files by name: both cores, the miter, the register that is a wire, and the script that
    /// proves it.
    pub fn files(&self, given: &[String]) -> [(&'static str, String); 5] {
        let print = |design: &Design| {
            let header = Header { lines: vec!["A core.".into()] };
            // A memory has an address, which depends on itself, and no proof has so many clocks.
            verilog::print_with(&design.to_block(), &header, LongDelays::ShiftRegisters)
        };
        let files = [("general.v", print(&self.general)), ("special.v", print(&self.special))];
        let [general, special] = files;
        [
            general,
            special,
            ("miter.v", self.module(given)),
            ("wire.v", WIRE.into()),
            ("prove.ys", self.script()),
        ]
    }

    /// Whether a register of either core depends on itself. Where none does, and inputs stay as
    /// they are, each comes to hold what goes into it, so registers are wires to the proof, and it
    /// has one clock.
    fn has_feedback(&self) -> bool {
        let depends = |design: &Design| {
            design.iter().any(|(id, node)| node.op.operands().any(|operand| operand.0 >= id.0))
        };
        [&self.general, &self.special].into_iter().any(depends)
    }

    /// Clocks after which the codes of a pixel leave the general core, and the special one, in the
    /// proof.
    fn latencies(&self) -> [u32; 2] {
        [&self.general, &self.special]
            .map(|design| if self.has_feedback() { design.latency() } else { 0 })
    }

    /// What the spec says of inputs, as Verilog.
    pub fn given(&self) -> Vec<String> {
        let of = |(name, given): (String, &Given)| match given {
            Given::Between([low, high]) => format!("{name} >= {low} && {name} <= {high}"),
            Given::SameAs(twin) => format!("{name} == {twin}"),
        };
        let ports = self.spec.inputs().into_iter();
        let known = ports.filter_map(|port| {
            Some((port.name.clone(), self.spec.specialisation.given(&port.name)?))
        });
        known.map(of).chain((!self.facts.is_empty()).then(|| self.facts.to_owned())).collect()
    }

    /// What comes in with the first clock is anything, and is kept; a span of it goes in from then
    /// on.
    fn module(&self, given: &[String]) -> String {
        let ports: Vec<_> =
            self.general.inputs.iter().flatten().map(|&id| port(&self.general, id)).collect();
        let whole: String = ports
            .iter()
            .map(|(name, width, _)| format!(", input [{}:0] {name}_given", width - 1))
            .collect();
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
        let [general, special] = self.latencies();
        let wait = general - special;
        for (k, colour) in ["red", "green", "blue"].into_iter().enumerate() {
            let (_, width, _) = port(&self.special, self.special.outputs[k]);
            let _ = writeln!(
                text,
                "  wire [7:0] general_{colour};\n  wire [{}:0] {colour}_0;",
                width - 1
            );
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
        let equal = ["red", "green", "blue"]
            .map(|colour| format!("general_{colour} == {colour}_{wait}"))
            .join(" && ");
        let _ = writeln!(
            text,
            "  wire given = 1{given};\n  assign holds = !given || ({equal});\nendmodule"
        );
        text
    }

    /// Before the span goes in registers hold anything. What leaves behind the latency is the span.
    /// Wires that make a loop are refused.
    fn script(&self) -> String {
        let [latency, _] = self.latencies();
        let (registers, clocks) = if self.has_feedback() {
            ("", latency + PIXELS)
        } else {
            // Bit by bit, since the word that holds validity is shifted into itself.
            ("simplemap t:$mux\ntechmap -map wire.v\ncheck -assert\n", 1)
        };
        let read = |core: &str| {
            format!(
                "read_verilog {core}.v\nprep -flatten -top {core}\n{registers}design -stash {core}\n"
            )
        };
        format!(
            "{}{}design -copy-from general general\ndesign -copy-from special special\nread_verilog miter.v\n\
             prep -flatten -top miter\nopt -full\n\
             sat -timeout {SECONDS} -seq {clocks} -prove-skip {latency} -prove holds 1 -set-init first 1 -verify miter\n",
            read("general"),
            read("special")
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
    // A port may be narrower than the register it reads, whose other bits are then 0 or copies of
    // the sign.
    let inputs = inputs.map(|node| format!(".{0}({0}[{1}:0])", node.name, node.width() - 1));
    let codes = ["red", "green", "blue"].map(|colour| format!(".{colour}({})", code(colour)));
    let ports: Vec<String> = inputs.chain(codes).collect();
    format!(
        "  {core} {core}_core(.clock(clock), .reset(1'b0), .valid(1'b1), .start(first), {});\n",
        ports.join(", ")
    )
}

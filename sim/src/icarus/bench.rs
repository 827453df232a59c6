//! The testbench.
use std::fmt::Write;

use crate::external::{Port, Ports, RESULTS, STIMULUS, Sampling, TRACE};

/// Name of the testbench's module. Names of cores and their ports begin with a letter, so its own
/// begin with an underscore.
pub const NAME: &str = "_specula_bench";
/// Name of the core in it.
pub const INSTANCE: &str = "core";
/// A clock takes four units of time: pins are set in the first, values are read at the end of the
/// second, and the clock rises at the end of the third. The clock of reset comes first.
pub const SAMPLING: Sampling = Sampling { first: 6, period: 4 };

/// What a testbench writes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Watch {
    /// The ports of these numbers, as numbers.
    Ports(Vec<usize>),
    /// Every signal, as a VCD.
    Everything,
}

/// The text of the testbench.
pub fn text(ports: &Ports, watch: &Watch) -> String {
    let (open, sample, close) = match watch {
        Watch::Ports(numbers) => (
            format!("_results = $fopen(\"{RESULTS}\", \"wb\");"),
            sample(&ports.all().collect::<Vec<_>>(), numbers),
            "$fclose(_results);".to_owned(),
        ),
        Watch::Everything => (
            format!("$dumpfile(\"{TRACE}\");\n    $dumpvars(0, {INSTANCE});"),
            String::new(),
            "_results = 0;".to_owned(),
        ),
    };
    let (valid, start) = (&ports.valid.name, &ports.start.name);
    let reads: String =
        ports.inputs.iter().map(|port| format!("      {}\n", read(&port.name))).collect();
    let zeros: String =
        ports.inputs.iter().map(|port| format!("    {} = 0;\n", port.name)).collect();
    format!(
        "module {NAME};
{declarations}
  reg [63:0] _clocks, _clock;
  reg _starts;
  integer _stimulus, _results, _fields;

  {core} {INSTANCE} (
    {pins}
  );

  initial begin
    {open}
    _stimulus = $fopen(\"{STIMULUS}\", \"r\");
    clock = 0; reset = 1; {valid} = 0; {start} = 0;
{zeros}
    #3 clock = 1;
    #1 clock = 0; reset = 0;

    _fields = $fscanf(_stimulus, \"%h\", _clocks);
    while (_fields == 1) begin
      {read_valid}
      {read_starts}
{reads}
      {start} = _starts;
      for (_clock = 0; _clock < _clocks; _clock = _clock + 1) begin
        #2 {sample}
        #1 clock = 1;
        #1 clock = 0; {start} = 0;
      end
      _fields = $fscanf(_stimulus, \"%h\", _clocks);
    end
    {close}
    $finish;
  end
endmodule
",
        declarations = declarations(ports),
        core = ports.core,
        pins = pins(ports),
        read_valid = read(valid),
        read_starts = read("_starts"),
    )
}

fn read(variable: &str) -> String {
    format!("_fields = $fscanf(_stimulus, \"%h\", {variable});")
}

fn declarations(ports: &Ports) -> String {
    let mut out = String::from("  reg clock, reset;");
    for port in ports.all() {
        let net = if port.input { "reg" } else { "wire" };
        // Writing to a String cannot fail.
        let _ = write!(out, "\n  {net} {}{};", port.bounds(), port.name);
    }
    out
}

fn pins(ports: &Ports) -> String {
    let control = [("clock", ports.clock), ("reset", ports.reset)];
    let control = control.into_iter().filter(|&(_, there)| there).map(|(name, _)| name);
    let names = control.chain(ports.all().map(|port| port.name.as_str()));
    names.map(|name| format!(".{name}({name})")).collect::<Vec<_>>().join(",\n    ")
}

/// `%u` writes 32 bits at a time, the low ones first, and X as 0; on the machines that Icarus runs
/// on a word's low byte is first.
fn sample(all: &[&Port], numbers: &[usize]) -> String {
    let format = "%u".repeat(numbers.len());
    let extended = |&number: &usize| {
        let Port { name, width, .. } = all[number];
        format!("{{{}'d0, {name}}}", 64 - width)
    };
    let values = numbers.iter().map(extended).collect::<Vec<_>>().join(", ");
    format!("$fwrite(_results, \"{format}\", {values});")
}

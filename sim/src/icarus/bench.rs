//! The testbench.
use std::fmt::Write;

use crate::external::{Port, Ports, RESULTS, STIMULUS, Sampling, TRACE};

/// Name of the testbench's module. Names of cores and their ports begin with a letter, so its own
/// begin with an underscore.
pub const NAME: &str = "_specula_bench";
/// Name of the core in it.
pub const INSTANCE: &str = "core";
/// A clock takes four units of time: pins are set in the first, values are read at the end of the
/// second, and the clock rises at the end of the third.
const PERIOD: u64 = 4;
/// Clocks of an interrupted run before its first pixel, in which no pin is known.
const UNKNOWN: u64 = 3;

/// When values are read of a run that so many clocks of another one precede. The clock of reset is
/// between them.
pub const fn sampling(interrupted: Option<u64>) -> Sampling {
    let before = match interrupted {
        Some(clocks) => UNKNOWN + clocks,
        None => 0,
    };
    Sampling { first: before * PERIOD + 6, period: PERIOD }
}

/// What a testbench writes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Watch {
    /// The ports of these numbers, as numbers.
    Ports(Vec<usize>),
    /// Every signal, as a VCD.
    Everything,
}

/// The text of the testbench. With `interrupted`, the run is preceded by so many clocks of itself,
/// which begin with nothing known and end with a reset in the midst of pixels, while pins are unknown.
pub fn text(ports: &Ports, watch: &Watch, interrupted: Option<u64>) -> String {
    let (open, sample, close) = match watch {
        Watch::Ports(numbers) => (
            format!("_results = $fopen(\"{RESULTS}\", \"wb\");"),
            sample(ports, numbers),
            "$fclose(_results);".to_owned(),
        ),
        Watch::Everything => (
            format!("$dumpfile(\"{TRACE}\");\n    $dumpvars(0, {INSTANCE});"),
            String::new(),
            "_results = 0;".to_owned(),
        ),
    };
    let start = &ports.start.name;
    let reads = reads(ports);
    let before = interrupted.map_or_else(String::new, |clocks| cut_off(ports, clocks));
    // At the clock of reset.
    let value = |port: &Port| match interrupted {
        Some(_) => format!("{}'bx", port.width),
        None => "0".to_owned(),
    };
    let pins_at_reset: String = [&ports.valid, &ports.start]
        .into_iter()
        .chain(&ports.inputs)
        .map(|port| format!("    {} = {};\n", port.name, value(port)))
        .collect();
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
{before}
    _stimulus = $fopen(\"{STIMULUS}\", \"r\");
    clock = 0; reset = 1;
{pins_at_reset}
    #3 clock = 1;
    #1 clock = 0; reset = 0;

    _fields = $fscanf(_stimulus, \"%h\", _clocks);
    while (_fields == 1) begin
{reads}
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
    )
}

/// The beginning of the run, cut off after so many clocks. Behind the end of the stimulus pins stay as
/// they are.
fn cut_off(ports: &Ports, clocks: u64) -> String {
    let (start, reads) = (&ports.start.name, reads(ports));
    format!(
        "    clock = 0; reset = 0;
    repeat ({UNKNOWN}) begin
      #3 clock = 1;
      #1 clock = 0;
    end
    _stimulus = $fopen(\"{STIMULUS}\", \"r\");
    _clocks = 0;
    for (_clock = 0; _clock < {clocks}; _clock = _clock + 1) begin
      if (_clocks == 0) begin
        _fields = $fscanf(_stimulus, \"%h\", _clocks);
{reads}
      end
      #3 clock = 1;
      #1 clock = 0; {start} = 0;
      _clocks = _clocks - 1;
    end
    $fclose(_stimulus);"
    )
}

/// Reads what is held for some clocks.
fn reads(ports: &Ports) -> String {
    let starts = format!("{} = _starts;", ports.start.name);
    let first = [read(&ports.valid.name), read("_starts")].into_iter();
    let lines = first.chain(ports.inputs.iter().map(|port| read(&port.name))).chain([starts]);
    lines.map(|line| format!("      {line}\n")).collect()
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
/// on a word's low byte is first. Where it is not known that no pixel leaves, one does.
fn sample(ports: &Ports, numbers: &[usize]) -> String {
    let all: Vec<&Port> = ports.all().collect();
    let format = "%u".repeat(numbers.len());
    let is_valid_out =
        |port: &Port| ports.outputs.first().is_some_and(|valid| valid.node == port.node);
    let extended = |&number: &usize| match all[number] {
        port if is_valid_out(port) => format!("{{63'd0, {} !== 1'b0}}", port.name),
        Port { name, width, .. } => format!("{{{}'d0, {name}}}", 64 - width),
    };
    let values = numbers.iter().map(extended).collect::<Vec<_>>().join(", ");
    format!("$fwrite(_results, \"{format}\", {values});")
}

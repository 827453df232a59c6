//! Pipelines of one operator many times over, as Verilog.
//!
//! A delay is what it is in company: a lone adder's nets are as short as they can be, those of a
//! core are not. So a circuit is some 1200 look-up tables of one kind. Its stages stand between
//! flip-flops, and each operator takes the results of its neighbours in the stage before.
use std::fmt::Write;

/// Name of a circuit's module.
pub const MODULE: &str = "measured";
/// How names of what is measured begin: the flip-flops behind operators.
pub const STAGE: &str = "stage";
/// How names of instantiated cells begin.
pub const CELL: &str = "cell";

/// Look-up tables of a circuit, roughly.
const SIZE: u32 = 1200;
/// Stages of an operator in logic.
const STAGES: u32 = 4;

/// A pipeline: `lanes` operators side by side, `stages` times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pipeline {
    /// Width of every value, in bits.
    pub width: u32,
    /// Operators in a stage.
    pub lanes: u32,
    /// Stages.
    pub stages: u32,
}

/// An operator in logic, with a register behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// So many look-up tables in a row.
    Gates(u32),
    /// The sum of two numbers of so many bits.
    Sum(u32),
    /// The sum of three numbers of so many bits.
    SumOfThree(u32),
    /// One of two numbers, whichever the sign of a difference of so many bits says.
    Sign(u32),
    /// One of two numbers of so many bits, whichever a comparison says.
    Comparison(u32),
    /// One of four numbers of so many bits.
    Choice(u32),
    /// A sum of so many bits that goes on or is loaded.
    Accumulator(u32),
    /// A memory in look-up tables that gives numbers of so many bits back after 16 clocks.
    DelayLine(u32),
}

impl Operator {
    /// A circuit full of it.
    pub fn circuit(self) -> String {
        let (width, tables) = match self {
            // Four memories of 16 x 4 bits, of four look-up tables each.
            Operator::Gates(depth) => (16, 16 * depth),
            Operator::Sum(width) | Operator::Accumulator(width) => (width, width),
            Operator::DelayLine(width) => (width, 2 * width),
            Operator::SumOfThree(width)
            | Operator::Sign(width)
            | Operator::Comparison(width)
            | Operator::Choice(width) => (width, 2 * width),
        };
        let lanes = (SIZE / (STAGES * tables)).max(4);
        let pipeline = Pipeline { width, lanes, stages: STAGES };
        pipeline.text(|name, operands| self.statement(name, operands, width))
    }

    fn statement(self, name: &str, [a, b, c, d]: [&str; 4], width: u32) -> String {
        let value = match self {
            Operator::Gates(depth) => return gates(name, [a, b, c], (width, depth)),
            Operator::Sum(_) => format!("{a} + {b}"),
            Operator::SumOfThree(_) => format!("{a} + {b} + {c}"),
            Operator::Sign(_) => return sign(name, [a, b, c, d], width),
            Operator::Comparison(_) => {
                format!("$signed({a}) < $signed({b}) ? {c} : {d}")
            }
            Operator::Choice(_) => {
                format!("{a}[0] ? ({b}[0] ? {a} : {b}) : ({b}[0] ? {c} : {d})")
            }
            Operator::Accumulator(_) => format!("{b}[0] ? {a} : {name} + {a}"),
            Operator::DelayLine(_) => return delay_line(name, a, width),
        };
        register(name, width, &value)
    }
}

impl Pipeline {
    /// The pipeline of the operator that `statement` declares, given its name and the results of
    /// four neighbours. The name is that of a value of the pipeline's width.
    pub fn text(&self, statement: impl Fn(&str, [&str; 4]) -> String) -> String {
        let Pipeline { width, lanes, stages } = *self;
        let mut text = format!(
            "module {MODULE} (input wire clk, input wire serial_in, output wire serial_out);\n"
        );
        let name = |stage: u32, lane: u32| match stage {
            0 => format!("given_{lane}"),
            _ => format!("{STAGE}_{stage}_{lane}"),
        };
        for lane in 0..lanes {
            let before =
                if lane == 0 { "serial_in".to_owned() } else { last(&name(0, lane - 1), width) };
            text += &shift_register(&name(0, lane), &before, width);
        }
        for stage in 1..=stages {
            for lane in 0..lanes {
                let neighbours = [0, 1, 2, 3].map(|step| name(stage - 1, (lane + step) % lanes));
                text += &statement(&name(stage, lane), neighbours.each_ref().map(String::as_str));
            }
        }
        text += &self.outputs(|lane| name(stages, lane));
        text + "endmodule\n"
    }

    /// Shifts the last results out, each bit added modulo 2 to those before, so that no bit is for
    /// nothing and no net leads to many.
    fn outputs(&self, result: impl Fn(u32) -> String) -> String {
        let Pipeline { width, lanes, .. } = *self;
        let mut text = String::new();
        for lane in 0..lanes {
            let before = match lane {
                0 => "1'b0".to_owned(),
                _ => last(&format!("taken_{}", lane - 1), width),
            };
            let taken = format!("taken_{lane}");
            let value = format!("{} ^ {}", joined(&taken, &before, width), result(lane));
            text += &register(&taken, width, &value);
        }
        let taken = last(&format!("taken_{}", lanes - 1), width);
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  assign serial_out = {taken};");
        text
    }
}

/// A register that takes over `value`.
pub fn register(name: &str, width: u32, value: &str) -> String {
    format!("  reg [{}:0] {name};\n  always @(posedge clk) {name} <= {value};\n", width - 1)
}

fn shift_register(name: &str, before: &str, width: u32) -> String {
    register(name, width, &joined(name, before, width))
}

/// A value moved up by a bit, which `before` takes the place of.
fn joined(name: &str, before: &str, width: u32) -> String {
    match width {
        1 => before.to_owned(),
        _ => format!("{{{name}[{}:0], {before}}}", width - 2),
    }
}

/// The last bit.
fn last(name: &str, width: u32) -> String {
    format!("{name}[{}]", width - 1)
}

/// A value with its bits moved round.
fn rotated(name: &str, width: u32, by: u32) -> String {
    match by % width {
        0 => name.to_owned(),
        by => format!("{{{name}[{}:0], {name}[{}:{by}]}}", by - 1, width - 1),
    }
}

/// Look-up tables in a row. What is between them is kept, so that no tool makes fewer of them.
fn gates(name: &str, [a, b, c]: [&str; 3], (width, depth): (u32, u32)) -> String {
    let gate = |before: &str, level: u32| {
        let [b, c] = [(b, 3 * level), (c, 5 * level)].map(|(of, by)| rotated(of, width, by));
        format!("({before} ^ {b}) & ~{c}")
    };
    let between = |level: u32| match level {
        0 => a.to_owned(),
        _ => format!("{name}_gate_{level}"),
    };
    let mut text = String::new();
    for level in 1..depth {
        let value = gate(&between(level - 1), level);
        let _ = writeln!(text, "  (* keep *) wire [{}:0] {} = {value};", width - 1, between(level));
    }
    text + &register(name, width, &gate(&between(depth - 1), depth))
}

fn sign(name: &str, [a, b, c, d]: [&str; 4], width: u32) -> String {
    let last = width - 1;
    format!(
        "  wire [{last}:0] {name}_difference = {a} - {b};\n{}",
        register(name, width, &format!("{name}_difference[{last}] ? {c} : {d}"))
    )
}

fn delay_line(name: &str, a: &str, width: u32) -> String {
    format!(
        "  (* ram_style = \"distributed\" *) reg [{last}:0] {name}_memory [0:15];\n\
         {}\
         \x20 always @(posedge clk) {name}_memory[{name}_at] <= {a};\n\
         \x20 wire [{last}:0] {name}_old = {name}_memory[{name}_at];\n\
         {}",
        register(&format!("{name}_at"), 4, &format!("{name}_at + 4'd1")),
        register(name, width, &format!("{name}_old")),
        last = width - 1,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operators_take_their_neighbours_results() {
        let pipeline = Pipeline { width: 2, lanes: 2, stages: 1 };
        let text = pipeline.text(|name, [a, b, ..]| register(name, 2, &format!("{a} + {b}")));
        let expected = "\
module measured (input wire clk, input wire serial_in, output wire serial_out);
  reg [1:0] given_0;
  always @(posedge clk) given_0 <= {given_0[0:0], serial_in};
  reg [1:0] given_1;
  always @(posedge clk) given_1 <= {given_1[0:0], given_0[1]};
  reg [1:0] stage_1_0;
  always @(posedge clk) stage_1_0 <= given_0 + given_1;
  reg [1:0] stage_1_1;
  always @(posedge clk) stage_1_1 <= given_1 + given_0;
  reg [1:0] taken_0;
  always @(posedge clk) taken_0 <= {taken_0[0:0], 1'b0} ^ stage_1_0;
  reg [1:0] taken_1;
  always @(posedge clk) taken_1 <= {taken_1[0:0], taken_0[1]} ^ stage_1_1;
  assign serial_out = taken_1[1];
endmodule
";
        assert_eq!(text, expected);
    }

    #[test]
    fn gates_in_a_row_are_kept() {
        let text = gates("n", ["a", "b", "c"], (4, 2));
        let expected = "  (* keep *) wire [3:0] n_gate_1 = (a ^ {b[2:0], b[3:3]}) & ~{c[0:0], c[3:1]};\n  \
                        reg [3:0] n;\n  \
                        always @(posedge clk) n <= (n_gate_1 ^ {b[1:0], b[3:2]}) & ~{c[1:0], c[3:2]};\n";
        assert_eq!(text, expected);
    }
}

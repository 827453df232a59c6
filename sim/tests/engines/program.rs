//! Programs: a list of steps that is described to the builder on one side and worked out in plain
//! numbers on the other.

use specula_datapath::builder::{BuildError, Builder, Sig};
use specula_datapath::design::Range;
use specula_datapath::{Design, SpanPacket};
use specula_spec::{Format, InputPort};

use crate::number::Number;

/// An operator of the builder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operation {
    Integer(i64),
    Same,
    Add,
    Sub,
    Mul,
    Squared,
    Negated,
    TimesPowerOfTwo(i32),
    Truncated(u32),
    Rounded(u32),
    ClampedBelow(i64),
    ClampedAbove(i64),
    AtLeastZero,
    LessThan,
    AtLeast,
    Not,
    And,
    Or,
    Choose,
    WithBit,
    /// To a signal of this range of raw values.
    Assumed(i64, i64),
    /// Start and step, in spans of so many pixels at most.
    Accumulated(u32),
    /// In a table of numbers with so many fraction bits.
    LookedUp(&'static [i64], u32),
    /// Enable second.
    Held,
    /// Enable, load and what is loaded behind the value.
    HeldOrLoaded,
}

/// What a step remembers from pixel to pixel.
#[derive(Clone, Copy, Debug, Default)]
struct Memory {
    /// What an accumulator holds at the next pixel of the span.
    next: Option<Number>,
    /// What a register holds.
    held: Option<Number>,
}

/// Where the operator stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    Core,
    Unit,
    OneClock,
}

/// An operator on the results of earlier steps; inputs come before all steps.
#[derive(Clone, Debug)]
pub struct Step {
    pub operation: Operation,
    pub operands: Vec<usize>,
    pub place: Place,
}

/// Inputs and steps; every step's result leaves the core.
#[derive(Clone, Debug, Default)]
pub struct Program {
    pub ports: Vec<InputPort>,
    pub steps: Vec<Step>,
}

/// A program as hardware.
pub struct Described {
    pub design: Design,
    /// The proven range of every input and step.
    pub ranges: Vec<Range>,
    /// The fraction bits of every input and step.
    pub fraction_bits: Vec<u32>,
}

/// An input that takes the raw values of `range`.
pub fn port(name: String, range: Range, fraction_bits: u32) -> InputPort {
    let integer_bits = range.width().saturating_sub(fraction_bits);
    let format = Format { signed: range.signed(), integer_bits, fraction_bits };
    InputPort { range: (range.low, range.high), ..InputPort::whole(name, format) }
}

impl Program {
    /// Adds a step on inputs alone, unless a signal of it would need more than 63 bits; says
    /// whether it did.
    pub fn push(&mut self, operation: Operation, operands: &[usize], place: Place) -> bool {
        let step = Step { operation, operands: operands.to_vec(), place };
        let fits =
            Program { ports: self.ports.clone(), steps: vec![step.clone()] }.describe().is_ok();
        if fits {
            self.steps.push(step);
        }
        fits
    }

    /// The proven range of every input.
    pub fn input_ranges(&self) -> Vec<Range> {
        self.ports.iter().map(|port| Range::new(port.range.0, port.range.1)).collect()
    }

    /// The program as hardware.
    pub fn describe(&self) -> Result<Described, BuildError> {
        let b = Builder::new("operators", "a test");
        let control = b.control();
        let mut values: Vec<Sig> = self.ports.iter().map(|port| b.input(port)).collect();
        for step in &self.steps {
            let operands: Vec<&Sig> = step.operands.iter().map(|&o| &values[o]).collect();
            let value = described(&b, &control.start, step, &operands);
            values.push(value);
        }
        let ranges = values.iter().map(Sig::range).collect();
        let fraction_bits = values.iter().map(Sig::fraction_bits).collect();
        let names: Vec<String> = (0..self.steps.len()).map(|i| format!("out{i}")).collect();
        let results = values.split_off(self.ports.len());
        let outputs: Vec<(&str, Sig)> = names.iter().map(String::as_str).zip(results).collect();
        let design = b.finish(&control.valid, &outputs)?;
        Ok(Described { design, ranges, fraction_bits })
    }

    /// What every step's raw value is at each pixel of the spans.
    pub fn interpret(&self, described: &Described, spans: &[SpanPacket]) -> Vec<Vec<i64>> {
        let mut columns = vec![vec![]; self.steps.len()];
        let mut memories = vec![Memory::default(); self.steps.len()];
        for span in spans {
            memories.iter_mut().for_each(|memory| memory.next = None);
            for _ in 0..span.length {
                let values = self.pixel(described, &span.inputs, &mut memories);
                for (column, value) in columns.iter_mut().zip(&values[self.ports.len()..]) {
                    column.push(i64::try_from(value.raw).unwrap());
                }
            }
        }
        columns
    }

    fn pixel(&self, described: &Described, inputs: &[i64], memories: &mut [Memory]) -> Vec<Number> {
        let input = |(&raw, port): (&i64, &InputPort)| Number {
            raw: raw.into(),
            fraction_bits: port.format.fraction_bits,
        };
        let mut values: Vec<Number> = inputs.iter().zip(&self.ports).map(input).collect();
        for (step, memory) in self.steps.iter().zip(memories) {
            let index = values.len();
            let range = described.ranges[index];
            let operands: Vec<Number> = step.operands.iter().map(|&o| values[o]).collect();
            let value = meaning(step.operation, &operands, range, memory);
            let proven = matches!(step.operation, Operation::Assumed(..)) || fits(range, value.raw);
            assert!(
                proven,
                "step {index} {step:?}: {value:?} is outside its proven range {range:?}"
            );
            assert_eq!(
                value.fraction_bits, described.fraction_bits[index],
                "step {index} {step:?}"
            );
            values.push(value);
        }
        values
    }
}

fn fits(range: Range, raw: i128) -> bool {
    i128::from(range.low) <= raw && raw <= i128::from(range.high)
}

/// What a step means.
fn meaning(operation: Operation, operands: &[Number], range: Range, memory: &mut Memory) -> Number {
    let operand = |i: usize| operands[i];
    match operation {
        Operation::Integer(value) => Number::integer(value),
        Operation::Same => operand(0),
        Operation::Add => operand(0).plus(operand(1)),
        Operation::Sub => operand(0).minus(operand(1)),
        Operation::Mul => operand(0).times(operand(1)),
        Operation::Squared => operand(0).times(operand(0)),
        Operation::Negated => Number::integer(0).minus(operand(0)),
        Operation::TimesPowerOfTwo(exponent) => operand(0).times_power_of_two(exponent),
        Operation::Truncated(fraction_bits) => operand(0).floor(fraction_bits),
        Operation::Rounded(fraction_bits) => operand(0).nearest(fraction_bits),
        Operation::ClampedBelow(low) => operand(0).at_least(low),
        Operation::ClampedAbove(high) => operand(0).at_most(high),
        Operation::AtLeastZero => operand(0).at_least(0),
        Operation::LessThan => Number::bit(operand(0).less_than(operand(1))),
        Operation::AtLeast => Number::bit(!operand(0).less_than(operand(1))),
        Operation::Not => Number::bit(!operand(0).is_set()),
        Operation::And => Number::bit(operand(0).is_set() && operand(1).is_set()),
        Operation::Or => Number::bit(operand(0).is_set() || operand(1).is_set()),
        Operation::Choose => Number::either(operand(0).is_set(), operand(1), operand(2)),
        Operation::WithBit => Number::integer(2).times(operand(0)).plus(operand(1)),
        // Where the fact does not hold, the bits that it makes superfluous are missing; all of them
        // where it leaves one value.
        Operation::Assumed(..) => match range.only() {
            Some(value) => Number { raw: value.into(), ..operand(0) },
            None => operand(0).low_bits(range.width(), range.signed()),
        },
        Operation::Accumulated(_) => {
            let value = memory.next.unwrap_or(operand(0)).plus(Number { raw: 0, ..operand(1) });
            memory.next = Some(value.plus(operand(1)));
            value
        }
        Operation::LookedUp(entries, fraction_bits) => {
            let entry =
                usize::try_from(operand(0).raw).ok().and_then(|address| entries.get(address));
            Number { raw: entry.copied().unwrap_or(0).into(), fraction_bits }
        }
        Operation::Held => memory.take(operand(1).is_set().then_some(operand(0)), operand(0)),
        Operation::HeldOrLoaded => {
            let taken = if operand(2).is_set() {
                Some(operand(3))
            } else {
                operand(1).is_set().then_some(operand(0))
            };
            memory
                .take(taken, operand(0))
                .plus(Number { raw: 0, ..operand(3) })
                .plus(Number { raw: 0, ..operand(0) })
        }
    }
}

impl Memory {
    /// Takes a number over, if there is one, and gives what is then held; 0 in the unit of `unit`
    /// at first.
    fn take(&mut self, taken: Option<Number>, unit: Number) -> Number {
        self.held = taken.or(self.held);
        self.held.unwrap_or(Number { raw: 0, ..unit })
    }
}

fn described(b: &Builder, first: &Sig, step: &Step, operands: &[&Sig]) -> Sig {
    match (step.place, operands) {
        (Place::Core, _) | (_, []) => applied(b, first, step.operation, operands),
        (Place::OneClock, _) => b.in_one_clock(|| applied(b, first, step.operation, operands)),
        (Place::Unit, _) => {
            // A port for each of three operands; those that the operator does not read are left
            // open.
            let [x, y, z] = [0, 1, 2].map(|i| operands[i % operands.len()]);
            b.unit(
                "unit",
                "one operator",
                (("first", first), ("x", x), ("y", y), ("z", z)),
                |b, (first, x, y, z)| {
                    applied(b, &first, step.operation, &[&x, &y, &z][..operands.len()])
                },
            )
        }
    }
}

/// The operator of the builder.
fn applied(b: &Builder, first: &Sig, operation: Operation, operands: &[&Sig]) -> Sig {
    let operand = |i: usize| operands[i];
    match operation {
        Operation::Integer(value) => b.integer(value),
        Operation::Same => operand(0).clone(),
        Operation::Add => operand(0) + operand(1),
        Operation::Sub => operand(0) - operand(1),
        Operation::Mul => operand(0) * operand(1),
        Operation::Squared => operand(0).squared(),
        Operation::Negated => -operand(0),
        Operation::TimesPowerOfTwo(1) => operand(0).doubled(),
        Operation::TimesPowerOfTwo(-1) => operand(0).halved(),
        Operation::TimesPowerOfTwo(exponent) => operand(0).times_power_of_two(exponent),
        Operation::Truncated(fraction_bits) => operand(0).truncated(fraction_bits),
        Operation::Rounded(fraction_bits) => operand(0).rounded(fraction_bits),
        Operation::ClampedBelow(low) => operand(0).clamped_below(low),
        Operation::ClampedAbove(high) => operand(0).clamped_above(high),
        Operation::AtLeastZero => operand(0).at_least_zero(),
        Operation::LessThan => operand(0).less_than(operand(1)),
        Operation::AtLeast => operand(0).at_least(operand(1)),
        Operation::Not => operand(0).not(),
        Operation::And => operand(0).and(operand(1)),
        Operation::Or => operand(0).or(operand(1)),
        Operation::Choose => operand(0).choose(operand(1), operand(2)),
        Operation::WithBit => operand(0).with_bit(operand(1)),
        Operation::Assumed(low, high) => {
            let ulp = (-f64::from(operand(0).fraction_bits())).exp2();
            operand(0).assumed(low as f64 * ulp, high as f64 * ulp, "a fact")
        }
        Operation::Accumulated(longest) => accumulated(first, operand(0), operand(1), longest),
        Operation::LookedUp(entries, fraction_bits) => {
            operand(0).looked_up(entries.to_vec(), fraction_bits, 0.5)
        }
        Operation::Held => operand(0).held(operand(1)),
        Operation::HeldOrLoaded => operand(0).held_or_loaded(operand(1), operand(2), operand(3)),
    }
}

/// From `start` in steps of `step`, with the range that so many pixels can reach.
fn accumulated(first: &Sig, start: &Sig, step: &Sig, longest: u32) -> Sig {
    let value = |sig: &Sig, raw: i64| raw as f64 * (-f64::from(sig.fraction_bits())).exp2();
    let farthest = f64::from(longest - 1);
    let low = value(start, start.range().low) + farthest * value(step, step.range().low.min(0));
    let high = value(start, start.range().high) + farthest * value(step, step.range().high.max(0));
    Sig::accumulated(first, start, step, (low, high), longest - 1, "it is a short span")
}

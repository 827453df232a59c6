//! Delays of a target, measured with place-and-route.
//!
//! What is measured is the model by which the schedule reckons: a path from flip-flop to flip-flop
//! takes `register`, and for each operator on it the net that leads there and the operator's own
//! delay. So every figure comes from whole paths, the slowest of circuits of some 1200 look-up
//! tables each, and a net is what nets on *slowest* paths take.
mod block;
mod circuit;
mod fit;
mod route;
mod table;

use crate::synth::{SynthError, SynthTarget};

pub use block::Family;
use circuit::{CELL, Operator, STAGE};
use fit::{Line, median};
use route::{Arrivals, Laboratory};
pub use table::text;

/// Widths of sums that are measured, in bits.
const WIDTHS: [u32; 4] = [8, 16, 32, 48];

/// Delays of a target, in nanoseconds.
#[derive(Clone, Debug, PartialEq)]
pub struct Delays {
    /// The programs with their versions.
    pub programs: [String; 2],
    /// From flip-flop to flip-flop, nets and operators apart.
    pub register: f64,
    /// A net that leads to an operator.
    pub net: f64,
    /// A look-up table.
    pub lut: f64,
    /// A sum of no bits.
    pub carry: f64,
    /// Each bit of a sum.
    pub carry_bit: f64,
    /// Ways to use the registers of a multiplier block.
    pub multiplier: Vec<Way>,
    /// Ways to use the registers of a block RAM.
    pub memory: Vec<Way>,
    /// From flip-flop to flip-flop through a memory of look-up tables that is read.
    pub delay_line: Option<f64>,
}

/// How long a cell takes with some of its registers, in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    /// Registers from its inputs to its outputs.
    pub clocks: u32,
    /// From a flip-flop to the first of them; to the flip-flop behind the cell if there is none.
    pub into: f64,
    /// From the last of them to the flip-flop behind the cell; 0 if there is none.
    pub out: f64,
}

/// A circuit that no figure of a table comes from, to see how good the model is.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// What it is.
    pub name: String,
    /// Its slowest path by the model, in nanoseconds.
    pub predicted: f64,
    /// Its slowest path by place-and-route, in nanoseconds.
    pub measured: f64,
}

/// The targets that can be measured, each with the cells that it is measured with.
pub const TARGETS: [(SynthTarget, Family); 4] = [
    (SynthTarget::ECP5, Family::ECP5),
    (SynthTarget::ICE40_HX, Family::ICE40_HX),
    (SynthTarget::ICE40_UP, Family::ICE40_UP),
    (SynthTarget::GOWIN, Family::GOWIN),
];

/// Measures a target with so many seeds of the placer, and tells `watch` what comes of each circuit.
///
/// # Errors
/// As [`synthesise_and_place`](crate::synth::synthesise_and_place).
pub fn measure(
    (target, family): &(SynthTarget, Family),
    seeds: u32,
    watch: &dyn Fn(&str, f64),
) -> Result<Delays, SynthError> {
    let bench = Bench { laboratory: Laboratory::new(target, seeds)?, watch };
    let gates = bench.sweep(Operator::Gates, family.depths)?;
    let sums = bench.sweep(Operator::Sum, &WIDTHS)?;
    let multiplier = family.multiplier.iter().flat_map(|block| {
        block.registers.iter().map(|&used| bench.cell(&block.circuit(used), used))
    });
    let multiplier = multiplier.collect::<Result<Vec<Way>, SynthError>>()?;
    let memory = &family.memory;
    let registers = [false, true].into_iter().filter(|&used| !used || memory.has_output_register);
    let memory = registers.map(|used| bench.cell(&memory.circuit(used), 1 + u32::from(used)));
    let memory = memory.collect::<Result<Vec<Way>, SynthError>>()?;
    let delay_line = family.has_distributed_memory.then(|| bench.operator(Operator::DelayLine(16)));
    Ok(Delays {
        programs: bench.laboratory.programs()?,
        register: gates.line.base,
        net: gates.line.slope - gates.cell,
        lut: gates.cell,
        carry: sums.line.base - gates.line.base - (gates.line.slope - gates.cell),
        carry_bit: sums.line.slope,
        multiplier,
        memory,
        delay_line: delay_line.transpose()?.map(|slowest| slowest.nanoseconds),
    })
}

/// Circuits that no figure comes from, as the model predicts them and as they are.
///
/// # Errors
/// As [`measure`].
pub fn check(
    (target, _): &(SynthTarget, Family),
    seeds: u32,
    delays: &Delays,
) -> Result<Vec<Check>, SynthError> {
    let bench = Bench { laboratory: Laboratory::new(target, seeds)?, watch: &|_, _| () };
    let gate = delays.net + delays.lut;
    let sum = |width: u32| delays.net + delays.carry + delays.carry_bit * f64::from(width);
    let circuits = [
        (Operator::Sum(40), sum(40)),
        (Operator::SumOfThree(20), 2.0 * sum(20)),
        (Operator::Sign(20), sum(20) + gate),
        (Operator::Comparison(20), sum(20) + gate),
        (Operator::Choice(20), 2.0 * gate),
        (Operator::Accumulator(34), sum(34) + gate),
    ];
    let checked = circuits.into_iter().map(|(operator, of_operators)| {
        let predicted = delays.register + of_operators;
        let measured = bench.operator(operator)?.nanoseconds;
        Ok(Check { name: format!("{operator:?}"), predicted, measured })
    });
    checked.collect()
}

/// Programs, and who is told what comes of them.
struct Bench<'a> {
    laboratory: Laboratory<'a>,
    watch: &'a dyn Fn(&str, f64),
}

/// The slowest path of a circuit.
struct Slowest {
    nanoseconds: f64,
    /// Mean delay of the cells on it, in nanoseconds.
    cell: f64,
}

/// Slowest paths of circuits of one operator.
struct Sweep {
    /// The path in nanoseconds over the operator's size.
    line: Line,
    /// Mean delay of the cells on the path of the largest, in nanoseconds.
    cell: f64,
}

impl Bench<'_> {
    /// The slowest path of a circuit of an operator: the median of all seeds.
    fn operator(&self, operator: Operator) -> Result<Slowest, SynthError> {
        let routed = self.laboratory.route(&operator.circuit())?;
        let nanoseconds = self.slowest(&routed, |_, cell| cell.starts_with(STAGE))?;
        let cell = median(routed.iter().filter_map(|arrivals| arrivals.logic).collect());
        (self.watch)(&format!("{operator:?}"), nanoseconds);
        Ok(Slowest { nanoseconds, cell: cell.unwrap_or(0.0) })
    }

    /// Slowest paths of circuits of operators of these sizes, in rising order.
    fn sweep(&self, operator: fn(u32) -> Operator, sizes: &[u32]) -> Result<Sweep, SynthError> {
        let slowest = sizes.iter().map(|&size| self.operator(operator(size)));
        let slowest = slowest.collect::<Result<Vec<Slowest>, SynthError>>()?;
        let point = |(&size, path): (&u32, &Slowest)| (f64::from(size), path.nanoseconds);
        let points: Vec<(f64, f64)> = sizes.iter().zip(&slowest).map(point).collect();
        let cell = slowest.last().map_or(0.0, |largest| largest.cell);
        Ok(Sweep { line: Line::through(&points), cell })
    }

    /// The slowest paths of a circuit of cells into their registers, and from there.
    fn cell(&self, circuit: &str, clocks: u32) -> Result<Way, SynthError> {
        let routed = self.laboratory.route(circuit)?;
        let is_cell = |name: &str| name.starts_with(CELL);
        let is_behind = |driver: &str, end: &str| is_cell(driver) && !is_cell(end);
        let behind = self.slowest(&routed, is_behind)?;
        let way = match clocks {
            0 => Way { clocks, into: behind, out: 0.0 },
            _ => {
                let into = self.slowest(&routed, |_, end| is_cell(end))?;
                Way { clocks, into, out: behind }
            }
        };
        (self.watch)(&format!("cell with {clocks} registers: into it"), way.into);
        (self.watch)(&format!("cell with {clocks} registers: out of it"), way.out);
        Ok(way)
    }

    fn slowest(
        &self,
        routed: &[Arrivals],
        counts: impl Fn(&str, &str) -> bool,
    ) -> Result<f64, SynthError> {
        let slowest = routed.iter().filter_map(|arrivals| arrivals.slowest(&counts)).collect();
        median(slowest).ok_or_else(|| self.laboratory.absent())
    }
}

#[cfg(test)]
mod tests;

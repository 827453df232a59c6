//! Columns of values that include the extremes.
use proptest::collection::vec;
use proptest::prelude::*;
use specula_kernels::{InstructionSet, Lane};

/// Most lanes of a column: several vectors and an odd tail.
pub const LONGEST: usize = 70;
/// Most lanes that may precede the first one that a kernel reads.
const FURTHEST: usize = 5;

/// Both copies of a kernel; twice the baseline where the processor has nothing more.
pub fn instruction_sets() -> [InstructionSet; 2] {
    [InstructionSet::BASELINE, InstructionSet::best()]
}

/// How many lanes a kernel fills, and where each operand begins.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    pub lanes: usize,
    pub offsets: [usize; 3],
}

impl Shape {
    /// The lanes of a column that a kernel reads as operand `number`.
    pub fn of<L>(self, column: &[L], number: usize) -> &[L] {
        let first = self.offsets[number];
        &column[first..first + self.lanes]
    }
}

pub fn shape() -> impl Strategy<Value = Shape> {
    (0..=LONGEST, [0..=FURTHEST, 0..=FURTHEST, 0..=FURTHEST])
        .prop_map(|(lanes, offsets)| Shape { lanes, offsets })
}

/// Numbers that fit `bits` bits: the extremes, their neighbours, and random ones.
pub fn number(bits: u32) -> impl Strategy<Value = i64> {
    let (low, high) = (i64::MIN >> (64 - bits), i64::MAX >> (64 - bits));
    let extremes =
        [low, high, low + 1, high - 1, -1, 0, 1].map(move |value| value.clamp(low, high)).to_vec();
    // Small magnitudes of every size, as many as large ones.
    let of_any_size = (low..=high, 0..bits).prop_map(|(value, shift)| value >> shift);
    prop_oneof![1 => prop::sample::select(extremes), 3 => of_any_size]
}

/// A column as long as any kernel reads.
pub fn column(bits: u32) -> impl Strategy<Value = Vec<i64>> {
    vec(number(bits), LONGEST + FURTHEST)
}

/// The column, converted to lanes.
pub fn in_lanes<L: Lane>(column: &[i64]) -> Vec<L> {
    column.iter().map(|&value| L::from_i64(value)).collect()
}

/// An output column that holds something other than results.
pub fn unfilled<L: Lane>(lanes: usize) -> Vec<L> {
    vec![L::from_i64(0x5555_5555_5555_5555); lanes]
}

/// The lanes as numbers.
pub fn numbers<L: Lane>(lanes: &[L]) -> Vec<i64> {
    lanes.iter().map(|lane| lane.to_i64()).collect()
}

//! Which signals change at which clocks, found a column at a time.
//!
//! A signal's values at 64 clocks are compared with those of the clocks before, which gives 64
//! bits; 64 such signals make a square of bits, and transposed it has for each clock the signals
//! that change. So a signal that keeps its value costs its writer nothing.
use std::ops::Range;

use crate::Lanes;

/// Clocks that are looked at together.
pub const BLOCK: usize = 64;

/// The signals whose changes are looked for, and where they change in the block looked at last.
#[derive(Debug)]
pub struct Changes {
    /// Each signal's value at the clock before the next block.
    last: Vec<i64>,
    /// Whether there has been a clock.
    begun: bool,
    /// For every 64 signals, and each clock: a bit for each signal that changes.
    squares: Vec<[u64; BLOCK]>,
}

impl Changes {
    /// Looks for changes of so many signals. At the first clock of all every signal changes.
    pub fn new(signals: usize) -> Changes {
        Changes {
            last: vec![0; signals],
            begun: false,
            squares: vec![[0; BLOCK]; signals.div_ceil(64)],
        }
    }

    /// Looks at some rows of the signals' lanes, no more than [`BLOCK`], which follow those looked
    /// at before.
    pub fn find(&mut self, lanes: &[Lanes], rows: Range<usize>) {
        for ((square, lanes), last) in
            self.squares.iter_mut().zip(lanes.chunks(64)).zip(self.last.chunks_mut(64))
        {
            *square = [0; BLOCK];
            for ((bits, lanes), last) in square.iter_mut().zip(lanes).zip(last) {
                *bits = changes(*lanes, rows.clone(), last);
            }
            transpose(square);
        }
        if !self.begun && !rows.is_empty() {
            self.begin();
        }
    }

    fn begin(&mut self) {
        self.begun = true;
        for (square, last) in self.squares.iter_mut().zip(self.last.chunks(64)) {
            square[0] = u64::MAX >> (64 - last.len());
        }
    }

    /// The signals that change in a row of the block.
    #[inline]
    pub fn at(&self, row: usize) -> impl Iterator<Item = usize> + '_ {
        self.squares
            .iter()
            .enumerate()
            .flat_map(move |(square, bits)| ones(bits[row]).map(move |bit| 64 * square + bit))
    }
}

/// The numbers of the bits that are set, the lowest first.
#[inline]
pub fn ones(bits: u64) -> impl Iterator<Item = usize> {
    let after = |&bits: &u64| Some(bits & (bits - 1)).filter(|&rest| rest != 0);
    std::iter::successors(Some(bits).filter(|&bits| bits != 0), after)
        .map(|bits| bits.trailing_zeros() as usize)
}

/// A bit for each of these rows, up to [`BLOCK`], whose value is not that of the row before. Before
/// the first row of the lanes it is `last`, which becomes that of the last of these.
pub fn changes(lanes: Lanes, rows: Range<usize>, last: &mut i64) -> u64 {
    match lanes {
        Lanes::Narrow(lanes) => changes_of(lanes, rows, last),
        Lanes::Wide(lanes) => changes_of(lanes, rows, last),
        Lanes::Constant(..) if rows.is_empty() => 0,
        Lanes::Constant(value, _) => u64::from(value != std::mem::replace(last, value)),
    }
}

fn changes_of<T: Copy + PartialEq + Into<i64>>(
    lanes: &[T],
    rows: Range<usize>,
    last: &mut i64,
) -> u64 {
    let (Some(&first), Some(&end)) = (lanes[rows.clone()].first(), lanes[rows.clone()].last())
    else {
        return 0;
    };
    let before = std::mem::replace(last, end.into());
    match rows.start.checked_sub(1) {
        Some(start) => differences(&lanes[start..rows.end - 1], &lanes[rows]),
        None => {
            differences(&lanes[..rows.end - 1], &lanes[1..rows.end]) << 1
                | u64::from(first.into() != before)
        }
    }
}

/// A bit for each row whose values differ, up to [`BLOCK`] of them.
fn differences<T: Copy + PartialEq>(before: &[T], after: &[T]) -> u64 {
    let halves = before.chunks(HALF).zip(after.chunks(HALF)).enumerate();
    halves.fold(0, |bits, (half, (before, after))| {
        bits | u64::from(differences_of_half(before, after)) << (HALF * half)
    })
}

/// Rows whose bits fit into a narrow lane.
const HALF: usize = BLOCK / 2;
/// A bit for each of these rows.
const BIT: [u32; HALF] = bits();

const fn bits() -> [u32; HALF] {
    let mut bits = [0; HALF];
    let mut row = 0;
    while row < HALF {
        bits[row] = 1 << row;
        row += 1;
    }
    bits
}

/// A bit for each row whose values differ, up to [`HALF`] of them.
fn differences_of_half<T: Copy + PartialEq>(before: &[T], after: &[T]) -> u32 {
    // A mask for each row, no shift and no branch: this becomes a loop over vectors.
    let rows = before.iter().zip(after).zip(&BIT);
    rows.fold(0, |bits, ((before, after), bit)| {
        bits | bit & u32::from(before != after).wrapping_neg()
    })
}

/// Turns rows into columns [Warren, Hacker's Delight, section 7-3].
fn transpose(square: &mut [u64; BLOCK]) {
    let (mut width, mut low) = (32, 0x0000_0000_FFFF_FFFF);
    while width != 0 {
        // Rows whose number has no bit `width`; the other of each pair has it.
        for pair in (0..BLOCK).filter(|row| row & width == 0) {
            let swapped = (square[pair] >> width ^ square[pair + width]) & low;
            square[pair] ^= swapped << width;
            square[pair + width] ^= swapped;
        }
        width >>= 1;
        low ^= low << width;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_is_transposed() {
        let mut square =
            std::array::from_fn(|row| (row as u64 + 3).wrapping_mul(0x9E37_79B9_7F4A_7C15));
        let before: [u64; BLOCK] = square;
        transpose(&mut square);
        for (number, row) in square.iter().enumerate() {
            assert!(
                before
                    .iter()
                    .enumerate()
                    .all(|(column, bits)| row >> column & 1 == bits >> number & 1)
            );
        }
    }

    #[test]
    fn changes_are_those_from_one_clock_to_the_next() {
        // More than 64 signals, of all kinds of lanes, in blocks of different sizes.
        let value = |signal: usize, row: usize| ((row / (signal % 9 + 1)) * (signal % 4)) as i64;
        let narrow: Vec<Vec<i32>> =
            (0..50).map(|s| (0..150).map(|row| value(s, row) as i32).collect()).collect();
        let wide: Vec<Vec<i64>> =
            (50..100).map(|s| (0..150).map(|row| value(s, row)).collect()).collect();
        let mut lanes: Vec<Lanes> = narrow.iter().map(|lanes| Lanes::Narrow(lanes)).collect();
        lanes.extend(wide.iter().map(|lanes| Lanes::Wide(lanes)));
        lanes.push(Lanes::Constant(5, 150));
        let mut changes = Changes::new(lanes.len());
        for rows in [0..64, 64..65, 65..129, 129..150] {
            changes.find(&lanes, rows.clone());
            for row in rows.clone() {
                let changed = |&s: &usize| row == 0 || lanes[s].get(row) != lanes[s].get(row - 1);
                let wanted: Vec<usize> = (0..lanes.len()).filter(changed).collect();
                assert_eq!(changes.at(row - rows.start).collect::<Vec<_>>(), wanted, "row {row}");
            }
        }
    }
}

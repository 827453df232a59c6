//! Tables in logic: each bit of the word as a function of the address, cut by its highest bits until
//! four are left. What two bits of the word have in common is there once.
use std::collections::HashSet;

use super::Wiring;
use crate::design::{NodeId, Op, Table, TableId};

/// Bits of address of a look-up table.
const INPUTS: u32 = 4;

/// Look-up tables of all tables.
pub fn luts(wiring: &Wiring) -> u64 {
    let tables = wiring.operators().filter_map(|(id, op)| match op {
        Op::LookUp(address, table) => Some((id, wiring.width(address) as u32, table)),
        _ => None,
    });
    let luts = |(id, bits, table): (NodeId, u32, TableId)| {
        of_table(&wiring.design.tables[table.0 as usize], bits, wiring.width(id) as u32)
    };
    tables.map(luts).sum()
}

/// Look-up tables of a table with so many bits of address and of word.
fn of_table(table: &Table, address_bits: u32, word_bits: u32) -> u64 {
    let mut functions = Functions::default();
    for bit in 0..word_bits {
        let truth = (0..1_i64 << address_bits).map(|address| table.entry(address) >> bit & 1 == 1);
        functions.add(&truth.collect::<Vec<bool>>());
    }
    functions.luts
}

/// The functions that are there.
#[derive(Default)]
struct Functions {
    known: HashSet<Vec<bool>>,
    luts: u64,
}

impl Functions {
    /// Adds a function, by its values at all addresses.
    fn add(&mut self, truth: &[bool]) {
        let half = truth.len() / 2;
        let is_constant = truth.iter().all(|&bit| bit == truth[0]);
        if is_constant || is_wire(truth) || !self.known.insert(truth.to_vec()) {
            return;
        }
        if truth.len() <= 1 << INPUTS {
            self.luts += 1;
            return;
        }
        let (low, high) = truth.split_at(half);
        if low == high {
            return self.add(low);
        }
        self.luts += 1;
        self.add(low);
        self.add(high);
    }
}

/// Whether a function is a bit of the address.
fn is_wire(truth: &[bool]) -> bool {
    let bits = truth.len().ilog2();
    (0..bits).any(|bit| truth.iter().enumerate().all(|(at, &value)| value == (at >> bit & 1 == 1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn luts(bits: u32, word_bits: u32, entry: impl Fn(i64) -> i64) -> u64 {
        of_table(&Table { entries: (0..1 << bits).map(entry).collect() }, bits, word_bits)
    }

    #[test]
    fn tables_are_counted_as_their_parts_of_four_bits() {
        let parity = |address: i64| i64::from(address.count_ones() % 2);
        assert_eq!(luts(6, 6, |address| address), 0, "wires");
        assert_eq!(luts(6, 3, |_| 5), 0, "constants");
        assert_eq!(luts(4, 1, parity), 1);
        assert_eq!(luts(4, 2, |address| 3 * parity(address)), 1, "one of both bits");
        // The two halves, and the choice between them.
        assert_eq!(luts(5, 1, |address| i64::from(address % 7 == 3)), 3);
        // A bit that decides nothing.
        assert_eq!(luts(5, 1, |address| parity(address % 16)), 1);
    }
}

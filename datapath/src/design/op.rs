//! What a signal is computed by.
use super::{NodeId, Range};

/// A table of a design, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TableId(pub u32);

/// The contents of a read-only memory.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// Raw values, from address 0 on; an address behind the last reads 0.
    pub entries: Vec<i64>,
}

impl Table {
    /// The entry at `address`.
    #[inline]
    pub fn entry(&self, address: i64) -> i64 {
        usize::try_from(address).ok().and_then(|at| self.entries.get(at)).copied().unwrap_or(0)
    }
}

/// An operator on raw values. Widths and signs belong to the signals, not to the operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    /// An input of the design.
    Input,
    /// The same value at every clock.
    Constant(i64),
    /// The operand itself: a port, or (with a register) a delay.
    Copy(NodeId),
    /// Sum.
    Add(NodeId, NodeId),
    /// Difference.
    Sub(NodeId, NodeId),
    /// Product.
    Mul(NodeId, NodeId),
    /// Times 2^k.
    ShiftLeft(NodeId, u32),
    /// Divided by 2^k, rounded down.
    ShiftRight(NodeId, u32),
    /// The low bits, as many as the result is wide, in the result's sign.
    Wrap(NodeId),
    /// 1 if the first is smaller, else 0.
    LessThan(NodeId, NodeId),
    /// Both bits.
    And(NodeId, NodeId),
    /// Either bit.
    Or(NodeId, NodeId),
    /// The opposite bit.
    Not(NodeId),
    /// The second operand if the first, a bit, is 1, else the third.
    Select(NodeId, NodeId, NodeId),
    /// The entry of a table at this address.
    LookUp(NodeId, TableId),
}

impl Op {
    /// The value, if it is the same at every clock.
    pub const fn constant(self) -> Option<i64> {
        match self {
            Op::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// The signals it reads, in order.
    pub fn operands(&self) -> impl Iterator<Item = NodeId> + use<> {
        let slots = match *self {
            Op::Input | Op::Constant(_) => [None; 3],
            Op::Copy(a)
            | Op::ShiftLeft(a, _)
            | Op::ShiftRight(a, _)
            | Op::Wrap(a)
            | Op::Not(a)
            | Op::LookUp(a, _) => [Some(a), None, None],
            Op::Add(a, b)
            | Op::Sub(a, b)
            | Op::Mul(a, b)
            | Op::LessThan(a, b)
            | Op::And(a, b)
            | Op::Or(a, b) => [Some(a), Some(b), None],
            Op::Select(c, a, b) => [Some(c), Some(a), Some(b)],
        };
        slots.into_iter().flatten()
    }

    /// The same operator on other signals.
    pub fn map(self, mut f: impl FnMut(NodeId) -> NodeId) -> Op {
        match self {
            Op::Input | Op::Constant(_) => self,
            Op::Copy(a) => Op::Copy(f(a)),
            Op::Add(a, b) => Op::Add(f(a), f(b)),
            Op::Sub(a, b) => Op::Sub(f(a), f(b)),
            Op::Mul(a, b) => Op::Mul(f(a), f(b)),
            Op::ShiftLeft(a, k) => Op::ShiftLeft(f(a), k),
            Op::ShiftRight(a, k) => Op::ShiftRight(f(a), k),
            Op::Wrap(a) => Op::Wrap(f(a)),
            Op::LessThan(a, b) => Op::LessThan(f(a), f(b)),
            Op::And(a, b) => Op::And(f(a), f(b)),
            Op::Or(a, b) => Op::Or(f(a), f(b)),
            Op::Not(a) => Op::Not(f(a)),
            Op::Select(c, a, b) => Op::Select(f(c), f(a), f(b)),
            Op::LookUp(a, table) => Op::LookUp(f(a), table),
        }
    }

    /// Whether it only puts two values side by side: a value times 2^k, and one of k bits without
    /// sign. `operand` gives an operand's operator and range.
    pub fn is_join(self, operand: impl Fn(NodeId) -> (Op, Range)) -> bool {
        let Op::Or(high, low) = self else { return false };
        let (Op::ShiftLeft(_, bits), _) = operand(high) else { return false };
        let (_, range) = operand(low);
        range.low >= 0 && range.width() <= bits
    }

    /// The raw value, from the operands' raw values, before it is brought to the signal's width.
    ///
    /// Arithmetic is modulo 2^64, so the low bits are right whatever the operands are.
    #[inline]
    pub fn evaluate(self, tables: &[Table], value: impl Fn(NodeId) -> i64) -> i64 {
        match self {
            Op::Input => 0,
            Op::Constant(c) => c,
            Op::Copy(a) | Op::Wrap(a) => value(a),
            Op::Add(a, b) => value(a).wrapping_add(value(b)),
            Op::Sub(a, b) => value(a).wrapping_sub(value(b)),
            Op::Mul(a, b) => value(a).wrapping_mul(value(b)),
            Op::ShiftLeft(a, k) => value(a).wrapping_shl(k),
            Op::ShiftRight(a, k) => value(a) >> k.min(63),
            Op::LessThan(a, b) => i64::from(value(a) < value(b)),
            Op::And(a, b) => value(a) & value(b),
            Op::Or(a, b) => value(a) | value(b),
            Op::Not(a) => value(a) ^ 1,
            Op::Select(c, a, b) => {
                if value(c) != 0 {
                    value(a)
                } else {
                    value(b)
                }
            }
            Op::LookUp(a, table) => {
                tables.get(table.0 as usize).map_or(0, |table| table.entry(value(a)))
            }
        }
    }
}

/// The low `width` bits of `raw`, in two's complement if `signed`.
#[inline]
pub fn wrapped(raw: i64, width: u32, signed: bool) -> i64 {
    let unused = 64 - width;
    let top = raw << unused;
    if signed { top >> unused } else { (top as u64 >> unused) as i64 }
}

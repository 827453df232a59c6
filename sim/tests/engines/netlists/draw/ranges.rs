//! Ranges of what is drawn.
use specula_datapath::Design;
use specula_datapath::design::{NodeId, Op, Range};

use specula_fixtures::Draw;

/// Widths at which lanes, products and sums change their kind come up often.
const WIDTHS: [u32; 16] = [1, 2, 3, 5, 8, 8, 12, 15, 16, 17, 30, 31, 32, 33, 62, 63];

pub fn bit() -> Range {
    Range::new(0, 1)
}

pub fn is_bit(range: Range) -> bool {
    0 <= range.low && range.high <= 1
}

pub fn width(draw: &mut Draw) -> u32 {
    if draw.below(3) == 0 { draw.between(1, 63) as u32 } else { WIDTHS[draw.below(WIDTHS.len())] }
}

/// Every value of some width.
pub fn whole(draw: &mut Draw) -> Range {
    Range::whole(width(draw), draw.below(2) == 0)
}

/// A range with 0 in it, that fills its width or not.
pub fn around_zero(draw: &mut Draw) -> Range {
    let whole = whole(draw);
    match draw.below(3) {
        0 => Range::new(draw.between(whole.low, 0), draw.between(0, whole.high)),
        _ => whole,
    }
}

/// A constant, small ones and powers of two more often.
pub fn constant(draw: &mut Draw) -> i64 {
    match draw.below(4) {
        0 => 1,
        1 => draw.between(-9, 9),
        2 => 1 << draw.below(40),
        _ => {
            let whole = whole(draw);
            draw.between(whole.low, whole.high)
        }
    }
}

/// Every value that the operator can give; `None` if it does not fit 63 bits, or if the result's
/// width is its own choice.
pub fn of(design: &Design, op: Op) -> Option<Range> {
    let range = |id: NodeId| design.node(id).range;
    match op {
        Op::Input | Op::Wrap(_) => None,
        Op::Constant(value) => Some(Range::single(value)),
        Op::Copy(a) => Some(range(a)),
        Op::Add(a, b) => range(a).plus(range(b)).narrow().ok(),
        Op::Sub(a, b) => range(a).minus(range(b)).narrow().ok(),
        Op::Mul(a, b) if unregistered(design, a) == unregistered(design, b) => {
            range(a).squared().narrow().ok()
        }
        Op::Mul(a, b) => range(a).times(range(b)).narrow().ok(),
        Op::ShiftLeft(a, bits) => range(a).shifted_left(bits).narrow().ok(),
        Op::ShiftRight(a, bits) => Some(range(a).shifted_right(bits)),
        Op::LessThan(..) | Op::Not(_) => Some(bit()),
        Op::And(a, b) | Op::Or(a, b) => hull(bits_of(range(a)), bits_of(range(b))),
        Op::Select(_, a, b) => hull(range(a), range(b)),
        Op::LookUp(at, table) => {
            let entries = &design.tables[table.0 as usize].entries;
            let beyond = (range(at).high >= entries.len() as i64).then_some(0);
            // All entries are of one width and sign.
            entries.iter().copied().chain(beyond).map(Range::single).reduce(Range::hull)
        }
    }
}

/// Both ranges, if that fits 63 bits.
pub fn hull(a: Range, b: Range) -> Option<Range> {
    a.hull(b).plus(Range::single(0)).narrow().ok()
}

/// The signal that this one is another name of.
fn unregistered(design: &Design, id: NodeId) -> NodeId {
    match design.node(id) {
        node if node.registered() => id,
        node => {
            if let Op::Copy(from) = node.op {
                unregistered(design, from)
            } else {
                id
            }
        }
    }
}

fn bits_of(range: Range) -> Range {
    Range::whole(range.width(), range.signed())
}

//! Operators as Verilog-2001 expressions.
//!
//! Every operand is brought to the width of the result by hand, since a linter asks for it and the
//! reader then need not know Verilog's rules of extension. Addition, subtraction and selection work
//! modulo 2^width, so signs do not matter there; where they do (products, comparisons), both
//! operands are made signed.
//!
//! A choice between a value and 0 that keeps the value where a bit is 1 is printed as a mask. Of a
//! choice, Yosys makes a reset of the register behind it, each bit's with an inverter and a net of
//! its own, which a device has few of (decision 0036).
use crate::design::{NodeId, Op, Table};

/// What an expression reads.
pub enum Operand<'a> {
    /// A net.
    Net {
        /// Its name.
        name: &'a str,
        /// Its width in bits.
        width: u32,
        /// Whether it is declared signed.
        signed: bool,
    },
    /// A constant.
    Literal(i64),
}

/// `op` as an expression `width` bits wide.
pub fn expression<'a>(op: Op, width: u32, operand: &dyn Fn(NodeId) -> Operand<'a>) -> String {
    let wide = |id| extended(&operand(id), width);
    match op {
        // Inputs are driven from outside, and a table is a `case` statement: nothing asks for their
        // expression.
        Op::Input | Op::LookUp(..) => String::new(),
        Op::Constant(value) => literal(value, width),
        Op::Copy(a) => wide(a),
        Op::Add(a, b) => format!("{} + {}", wide(a), wide(b)),
        Op::Sub(a, b) => format!("{} - {}", wide(a), wide(b)),
        Op::Mul(a, b) => product(&operand(a), &operand(b), width),
        Op::ShiftLeft(a, bits) => shifted_left(&operand(a), bits, width),
        Op::ShiftRight(a, bits) => shifted_right(&operand(a), bits, width),
        Op::Wrap(a) => low_bits(&operand(a), width),
        Op::LessThan(a, b) => less_than(&operand(a), &operand(b)),
        Op::And(a, b) => format!("{} & {}", wide(a), wide(b)),
        Op::Or(a, b) => format!("{} | {}", wide(a), wide(b)),
        Op::Not(a) => format!("~{}", wide(a)),
        Op::Select(c, a, b) => {
            let choice = extended(&operand(c), 1);
            let kept = || format!("{} & {}", repeated(&choice, width), wide(a));
            let is_not = || repeated(&format!("~{choice}"), width);
            match [operand(a), operand(b)] {
                [_, Operand::Literal(0)] => kept(),
                [_, Operand::Literal(_)] => format!("{} | {} & {}", kept(), is_not(), wide(b)),
                [Operand::Literal(0), _] if width == 1 => format!("{} & {}", is_not(), wide(b)),
                [Operand::Literal(_), _] if width == 1 => format!("{choice} | {}", wide(b)),
                _ => format!("{choice} ? {} : {}", wide(a), wide(b)),
            }
        }
    }
}

/// `target {arrow} op;` as statements of an `always` block; `target_number` is the number of the
/// target among the operands.
pub fn assignment<'a>(
    (target, target_number): (&str, NodeId),
    arrow: &str,
    op: Op,
    width: u32,
    operand: &dyn Fn(NodeId) -> Operand<'a>,
    tables: &[Table],
) -> String {
    match op {
        // A register that holds its value, as tools like to see it.
        Op::Select(enable, value, own) if own == target_number => {
            format!(
                "if ({}) {target} {arrow} {};",
                extended(&operand(enable), 1),
                extended(&operand(value), width)
            )
        }
        Op::LookUp(address, table) => {
            let entries = tables.get(table.0 as usize).map_or(&[][..], |table| &table.entries);
            case(target, arrow, &operand(address), entries, width)
        }
        _ => format!("{target} {arrow} {};", expression(op, width, operand)),
    }
}

/// A table as a `case` statement.
fn case(target: &str, arrow: &str, address: &Operand, entries: &[i64], width: u32) -> String {
    let address_width = match *address {
        Operand::Net { width, .. } => width,
        Operand::Literal(value) => crate::design::Range::single(value).width(),
    };
    let reachable =
        if address_width < 63 { entries.len().min(1 << address_width) } else { entries.len() };
    let mut text = format!("case ({})\n", plain(address));
    for (at, &entry) in entries[..reachable].iter().enumerate() {
        text.push_str(&format!(
            "      {}: {target} {arrow} {};\n",
            literal(at as i64, address_width),
            literal(entry, width)
        ));
    }
    text.push_str(&format!("      default: {target} {arrow} {};\n    endcase", literal(0, width)));
    text
}

/// Bits of an operand that an expression of `width` bits does not read, as a mask.
pub fn unread_bits(op: Op, width: u32, operand: NodeId, operand_width: u32) -> u64 {
    let all = u64::MAX >> (64 - operand_width);
    let above = |bits: u32| if bits >= operand_width { 0 } else { all & (u64::MAX << bits) };
    match op {
        Op::ShiftRight(_, bits) => {
            let dropped = bits.min(operand_width - 1);
            all & !(all << dropped)
        }
        Op::ShiftLeft(_, bits) => above(width - bits),
        Op::Select(c, a, b) if c == operand && a != operand && b != operand => 0,
        Op::Add(..)
        | Op::Sub(..)
        | Op::Mul(..)
        | Op::Copy(_)
        | Op::Wrap(_)
        | Op::And(..)
        | Op::Or(..)
        | Op::Not(_)
        | Op::Select(..) => above(width),
        Op::Input | Op::Constant(_) | Op::LessThan(..) | Op::LookUp(..) => 0,
    }
}

/// The low bits of `value` in two's complement, decimal where that is what it says.
fn literal(value: i64, width: u32) -> String {
    let low_bits = value as u64 & (u64::MAX >> (64 - width));
    if i64::try_from(low_bits) == Ok(value) {
        format!("{width}'d{low_bits}")
    } else {
        format!("{width}'h{low_bits:x}")
    }
}

/// The operand `width` bits wide, its value kept as far as it fits.
fn extended(operand: &Operand, width: u32) -> String {
    match *operand {
        Operand::Literal(value) => literal(value, width),
        Operand::Net { width: own, .. } if own > width => low_bits(operand, width),
        Operand::Net { name, width: own, .. } if own == width => name.to_owned(),
        Operand::Net { name, width: own, signed: true } => {
            format!("{{{}, {name}}}", repeated(&bit(name, own - 1, own), width - own))
        }
        Operand::Net { name, width: own, signed: false } => {
            format!("{{{}'d0, {name}}}", width - own)
        }
    }
}

/// Bit `number` of a net; a net of one bit has no index.
fn bit(name: &str, number: u32, width: u32) -> String {
    if width == 1 { name.to_owned() } else { format!("{name}[{number}]") }
}

fn repeated(text: &str, times: u32) -> String {
    if times == 1 { text.to_owned() } else { format!("{{{times}{{{text}}}}}") }
}

/// The operand as a signed expression of its own width, one more for an unsigned net.
fn signed(operand: &Operand) -> String {
    match *operand {
        Operand::Net { name, signed: true, .. } => name.to_owned(),
        Operand::Net { name, .. } => format!("$signed({{1'b0, {name}}})"),
        Operand::Literal(value) => {
            let width = crate::design::Range::single(value).width() + u32::from(value >= 0);
            format!("$signed({})", literal(value, width))
        }
    }
}

fn is_unsigned(operand: &Operand) -> bool {
    matches!(*operand, Operand::Net { signed: false, .. } | Operand::Literal(0..))
}

/// Bits of the net, or that the literal needs.
fn own_width(operand: &Operand) -> u32 {
    match *operand {
        Operand::Net { width, .. } => width,
        Operand::Literal(value) => crate::design::Range::single(value).width(),
    }
}

fn plain(operand: &Operand) -> String {
    match *operand {
        Operand::Net { name, .. } => name.to_owned(),
        Operand::Literal(value) => literal(value, crate::design::Range::single(value).width()),
    }
}

/// A product no wider than an operand is right modulo 2^width whatever the signs; else Verilog
/// extends the operands by their signs.
fn product(a: &Operand, b: &Operand, width: u32) -> String {
    let unsigned = is_unsigned(a) && is_unsigned(b);
    let own = |operand: &Operand| own_width(operand) + u32::from(!unsigned && is_unsigned(operand));
    if own(a) > width || own(b) > width {
        return format!("{} * {}", extended(a, width), extended(b, width));
    }
    if unsigned {
        return format!("{} * {}", plain(a), plain(b));
    }
    format!("{} * {}", signed(a), signed(b))
}

fn shifted_left(operand: &Operand, bits: u32, width: u32) -> String {
    match operand {
        Operand::Literal(value) => literal(value << bits, width),
        Operand::Net { .. } if bits == 0 => extended(operand, width),
        Operand::Net { .. } => format!("{{{}, {bits}'d0}}", extended(operand, width - bits)),
    }
}

fn shifted_right(operand: &Operand, bits: u32, width: u32) -> String {
    match *operand {
        Operand::Literal(value) => literal(value >> bits, width),
        Operand::Net { name, width: own, signed } => {
            let low = bits.min(own - 1);
            let kept = own - low;
            let slice = match (own, kept) {
                (1, _) => name.to_owned(),
                (_, 1) => format!("{name}[{low}]"),
                _ if low == 0 => name.to_owned(),
                _ => format!("{name}[{}:{low}]", own - 1),
            };
            let missing = width.saturating_sub(kept);
            match (missing, signed) {
                (0, _) => slice,
                (_, true) => {
                    format!("{{{}, {slice}}}", repeated(&bit(name, own - 1, own), missing))
                }
                (_, false) => format!("{{{missing}'d0, {slice}}}"),
            }
        }
    }
}

fn low_bits(operand: &Operand, width: u32) -> String {
    match *operand {
        Operand::Net { name, width: own, .. } if own > width && width == 1 => format!("{name}[0]"),
        Operand::Net { name, width: own, .. } if own > width => format!("{name}[{}:0]", width - 1),
        _ => extended(operand, width),
    }
}

/// Both sides at one width and signed, or plain where neither can be negative.
fn less_than(a: &Operand, b: &Operand) -> String {
    if let (&Operand::Net { name, width, signed: true }, Operand::Literal(0)) = (a, b) {
        // The sign.
        return bit(name, width - 1, width);
    }
    if let (Operand::Literal(0), &Operand::Net { name, signed: false, .. }) = (a, b) {
        return format!("|{name}");
    }
    if is_unsigned(a) && is_unsigned(b) {
        let width = own_width(a).max(own_width(b));
        return format!("{} < {}", extended(a, width), extended(b, width));
    }
    let width = [a, b]
        .map(|operand| own_width(operand) + u32::from(is_unsigned(operand)))
        .into_iter()
        .max()
        .unwrap_or(1);
    format!("$signed({}) < $signed({})", extended(a, width), extended(b, width))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A choice by `c` between two of `x`, 0, 1 and 5.
    fn choice([one, other]: [u32; 2], width: u32) -> String {
        let operand = |id: NodeId| match id.0 {
            0 => Operand::Net { name: "c", width: 1, signed: false },
            1 => Operand::Net { name: "x", width, signed: false },
            2 => Operand::Literal(0),
            3 => Operand::Literal(1),
            _ => Operand::Literal(5),
        };
        expression(Op::Select(NodeId(0), NodeId(one), NodeId(other)), width, &operand)
    }

    #[test]
    fn a_value_that_a_bit_keeps_is_masked() {
        assert_eq!(choice([1, 2], 3), "{3{c}} & x");
        assert_eq!(choice([1, 4], 3), "{3{c}} & x | {3{~c}} & 3'd5");
    }

    #[test]
    fn a_register_of_several_bits_has_one_reset() {
        assert_eq!(choice([2, 1], 3), "c ? 3'd0 : x");
        assert_eq!(choice([4, 1], 3), "c ? 3'd5 : x");
    }

    #[test]
    fn a_single_bit_has_no_reset() {
        assert_eq!(choice([1, 2], 1), "c & x");
        assert_eq!(choice([2, 1], 1), "~c & x");
        assert_eq!(choice([3, 1], 1), "c | x");
    }
}

//! Reads what `print` wrote.
use std::str::FromStr;

use specula_datapath::SpanPacket;
use specula_datapath::design::{Node, NodeId, Op, Range, Register, ScopeId, Table, TableId};
use specula_sim::fast::{InstructionSet, Settings};

use crate::netlists::case::{Case, Subject};
use crate::netlists::draw::{empty, node, scope};

/// The case that a text describes; lines that begin with `#` are remarks.
pub fn parse(text: &str) -> Result<Case, String> {
    let mut design = empty();
    design.nodes.clear();
    let mut case = Case {
        design,
        packets: vec![],
        bubbles: None,
        window: None,
        watched: vec![],
        subject: Subject::RustHdl,
    };
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        if !line.is_empty() && !line.starts_with('#') {
            read_line(&mut case, line)
                .map_err(|what| format!("line {}: {what}: `{line}`", number + 1))?;
        }
    }
    Ok(case)
}

fn read_line(case: &mut Case, line: &str) -> Result<(), String> {
    let (first, rest) = line.split_once(' ').unwrap_or((line, ""));
    let design = &mut case.design;
    match first {
        "unit" => design.scopes.push(scope(design.scopes.len(), ScopeId(one(rest)?))),
        "table" => design.tables.push(Table { entries: all(rest)? }),
        "inputs" => design.inputs = rest.split_whitespace().map(port).collect::<Result<_, _>>()?,
        "outputs" => design.outputs = nodes(rest)?,
        "leaves" => {
            let (id, latency) = rest.split_once(" after ").ok_or("no latency")?;
            design.valid_out = NodeId(one(id)?);
            design.nodes.get_mut(design.valid_out.0 as usize).ok_or("no such signal")?.stage =
                one(latency)?;
        }
        "span" => {
            let (length, inputs) = rest.split_once(':').ok_or("no inputs")?;
            case.packets.push(SpanPacket { length: one(length)?, inputs: all(inputs)? });
        }
        "bubbles" => case.bubbles = Some(one(rest)?),
        "window" => case.window = Some(bounds(rest)?),
        "watch" => case.watched = nodes(rest)?,
        "run" => case.subject = subject(rest)?,
        _ => {
            let number = design.nodes.len();
            if first.parse() != Ok(number) {
                return Err(format!("this should be signal {number}"));
            }
            design.nodes.push(signal(number, rest)?);
        }
    }
    Ok(())
}

fn one<T: FromStr>(text: &str) -> Result<T, String> {
    text.trim().parse().map_err(|_| format!("`{text}` is no number here"))
}

fn all<T: FromStr>(text: &str) -> Result<Vec<T>, String> {
    text.split_whitespace().map(one).collect()
}

fn nodes(text: &str) -> Result<Vec<NodeId>, String> {
    Ok(all(text)?.into_iter().map(NodeId).collect())
}

fn port(word: &str) -> Result<Option<NodeId>, String> {
    if word == "-" { Ok(None) } else { Ok(Some(NodeId(one(word)?))) }
}

fn bounds<T: FromStr>(text: &str) -> Result<std::ops::Range<T>, String> {
    let (low, high) = text.split_once("..").ok_or("no bounds")?;
    Ok(one(low)?..one(high)?)
}

fn subject(text: &str) -> Result<Subject, String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    match words[..] {
        ["rust-hdl"] => Ok(Subject::RustHdl),
        ["fast", batch, instruction_set, threads, piece] => {
            let instruction_set = if instruction_set == InstructionSet::BASELINE.name() {
                InstructionSet::BASELINE
            } else {
                InstructionSet::best()
            };
            Ok(Subject::Fast(Settings {
                batch: one(batch)?,
                instruction_set,
                threads: one(threads)?,
                piece: one(piece)?,
            }))
        }
        _ => Err("no such engine".to_owned()),
    }
}

fn signal(number: usize, text: &str) -> Result<Node, String> {
    let (operator, facts) = text.split_once(':').ok_or("no range")?;
    let (range, unit) = facts.split_once('@').unwrap_or((facts, "0"));
    let range = bounds::<i64>(range)?;
    let (register, operator) = match operator.split_once(' ') {
        Some(("reg", rest)) => (Register::Data, rest),
        Some(("valid", rest)) => (Register::Validity, rest),
        _ => (Register::None, operator),
    };
    Ok(node(
        number,
        op(operator)?,
        register,
        Range::new(range.start, range.end),
        ScopeId(one(unit)?),
    ))
}

fn op(text: &str) -> Result<Op, String> {
    let (name, rest) = text.trim().split_once(' ').unwrap_or((text.trim(), ""));
    if name == "constant" {
        return Ok(Op::Constant(one(rest)?));
    }
    let numbers: Vec<u32> = all(rest)?;
    let id = NodeId;
    Ok(match (name, &numbers[..]) {
        ("input", []) => Op::Input,
        ("copy", &[a]) => Op::Copy(id(a)),
        ("add", &[a, b]) => Op::Add(id(a), id(b)),
        ("sub", &[a, b]) => Op::Sub(id(a), id(b)),
        ("mul", &[a, b]) => Op::Mul(id(a), id(b)),
        ("left", &[a, bits]) => Op::ShiftLeft(id(a), bits),
        ("right", &[a, bits]) => Op::ShiftRight(id(a), bits),
        ("wrap", &[a]) => Op::Wrap(id(a)),
        ("less", &[a, b]) => Op::LessThan(id(a), id(b)),
        ("and", &[a, b]) => Op::And(id(a), id(b)),
        ("or", &[a, b]) => Op::Or(id(a), id(b)),
        ("not", &[a]) => Op::Not(id(a)),
        ("select", &[c, a, b]) => Op::Select(id(c), id(a), id(b)),
        ("look_up", &[a, table]) => Op::LookUp(id(a), TableId(table)),
        _ => return Err(format!("no operator `{text}`")),
    })
}

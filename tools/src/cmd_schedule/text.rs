//! A schedule as text.
use std::collections::BTreeMap;
use std::fmt::Write;

use specula_datapath::stages::OperatorKind;

use super::contents::{CarriedFacts, Contents, LimitFacts, OperatorFacts, PathFacts, StageFacts};
use crate::table;

/// Most operators of a path in an overview.
const SHOWN: usize = 3;

/// A line for each clock, and the totals.
pub fn overview(contents: &Contents) -> String {
    let stages = &contents.stages;
    let clocks = match contents.made_for {
        Some(_) => table::shown(&timed_rows(stages)),
        None => table::shown(&rows(stages)),
    };
    format!("{clocks}\n{}", table::shown(&totals(contents)))
}

/// Every operator of each clock, and the totals.
pub fn complete(contents: &Contents) -> String {
    let clocks: String = contents.stages.iter().map(paragraph).collect();
    format!("{clocks}{}", table::shown(&totals(contents)))
}

fn timed_rows(stages: &[StageFacts]) -> Vec<[String; 8]> {
    let titles = [
        "clock",
        "path ns",
        "slack ns",
        "in blocks",
        "flip-flops",
        "in memories",
        "longest path",
        "other operators",
    ];
    let row = |stage: &StageFacts| {
        let path = stage.longest_path.as_ref();
        let [ns, slack] = path.map_or([String::new(), String::new()], |path| {
            [format!("{:7.2}", path.ns), format!("{:8.2}", path.slack_ns)]
        });
        let [blocks, flip_flops, memories] = carried(&stage.carried);
        let on_path = path.map_or(String::new(), way);
        let others = counted(&others(stage));
        [number(stage.clock), ns, slack, blocks, flip_flops, memories, on_path, others]
    };
    [titles.map(str::to_owned)].into_iter().chain(stages.iter().map(row)).collect()
}

fn rows(stages: &[StageFacts]) -> Vec<[String; 5]> {
    let titles = ["clock", "in blocks", "flip-flops", "in memories", "operators"];
    let row = |stage: &StageFacts| {
        let [blocks, flip_flops, memories] = carried(&stage.carried);
        [number(stage.clock), blocks, flip_flops, memories, largest(stage)]
    };
    [titles.map(str::to_owned)].into_iter().chain(stages.iter().map(row)).collect()
}

fn number(clock: u32) -> String {
    format!("{clock:5}")
}

fn carried(bits: &CarriedFacts) -> [String; 3] {
    let CarriedFacts { in_blocks, flip_flops, in_memories, .. } = bits;
    [format!("{in_blocks:9}"), format!("{flip_flops:10}"), format!("{in_memories:11}")]
}

/// The operators of a clock: those of its longest path, or the widest ones, and counts of the others.
pub fn operators_of(stage: &StageFacts) -> String {
    let Some(path) = &stage.longest_path else { return largest(stage) };
    let others = counted(&others(stage));
    if others.is_empty() { way(path) } else { format!("{}; {others}", way(path)) }
}

/// Where a path begins, and its last operators.
fn way(path: &PathFacts) -> String {
    let operators = &path.operators;
    let more = operators.len().saturating_sub(SHOWN);
    let before = if more > 0 { format!(", {more} more") } else { String::new() };
    let shown = listed(unit(&path.from), &operators[more..].iter().collect::<Vec<_>>());
    let to = path.signals.last().map_or("", String::as_str);
    if shown.is_empty() {
        format!("{} to {to}", path.from)
    } else {
        format!("{}{before}: {shown}", path.from)
    }
}

/// The operators of a clock that are not on its longest path.
fn others(stage: &StageFacts) -> Vec<&OperatorFacts> {
    let on_path: Vec<&str> = stage
        .longest_path
        .iter()
        .flat_map(|path| &path.operators)
        .map(|o| o.name.as_str())
        .collect();
    stage.operators.iter().filter(|operator| !on_path.contains(&operator.name.as_str())).collect()
}

/// The widest operators of a clock, and counts of the others.
fn largest(stage: &StageFacts) -> String {
    let mut operators: Vec<&OperatorFacts> = stage.operators.iter().collect();
    operators.sort_by_key(|operator| (operator.sort, std::cmp::Reverse(operator.widths.clone())));
    let (shown, rest) = operators.split_at(operators.len().min(SHOWN));
    let shown = listed("", shown);
    if rest.is_empty() { shown } else { format!("{shown}; {} more", counted(rest)) }
}

/// How many operators there are of each kind.
fn counted(operators: &[&OperatorFacts]) -> String {
    let mut counts: BTreeMap<OperatorKind, usize> = BTreeMap::new();
    operators.iter().for_each(|operator| *counts.entry(operator.sort).or_default() += 1);
    let words = |(kind, count): (&OperatorKind, &usize)| {
        let [one, several] = kind.words();
        format!("{count} {}", if *count == 1 { one } else { several })
    };
    counts.iter().map(words).collect::<Vec<_>>().join(", ")
}

/// Operators in a row, the units of their names where they are others than those before.
fn listed(before: &str, operators: &[&OperatorFacts]) -> String {
    let mut before = before;
    let words = operators.iter().map(|of| {
        let own = unit(&of.name);
        let name = if own == before { &of.name[own.len()..] } else { &of.name };
        before = own;
        called(of, name)
    });
    words.collect::<Vec<_>>().join(", ")
}

/// The units of a signal's name.
fn unit(name: &str) -> &str {
    name.rsplit_once('.').map_or("", |(unit, _)| unit)
}

/// An operator under a name: its kind, its width, the clock in its block.
fn called(operator: &OperatorFacts, name: &str) -> String {
    let widths: Vec<String> = operator.widths.iter().map(u32::to_string).collect();
    let block = operator.block_clock.map_or(String::new(), |[clock, clocks]| {
        format!(" (clock {clock} of {clocks} in its block)")
    });
    format!("{} {} {name}{block}", operator.kind, widths.join("x"))
}

/// A clock with all that is in it.
fn paragraph(stage: &StageFacts) -> String {
    let CarriedFacts { in_blocks, flip_flops, in_memories, total } = stage.carried;
    let mut text = format!(
        "clock {}: {total} register bits into the next, {in_blocks} in blocks, {flip_flops} in flip-flops, {in_memories} in memories\n",
        stage.clock
    );
    if let Some(path) = &stage.longest_path {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {:.2} ns, slack {:.2} ns", path.ns, path.slack_ns);
        path.signals.iter().for_each(|signal| text.push_str(&format!("    {signal}\n")));
    }
    stage.operators.iter().for_each(|of| text.push_str(&format!("  {}\n", called(of, &of.name))));
    text + "\n"
}

fn totals(contents: &Contents) -> Vec<[String; 2]> {
    let CarriedFacts { in_blocks, flip_flops, in_memories, total } = contents.register_bits;
    let first = |stage: &StageFacts| {
        stage
            .operators
            .iter()
            .filter(|o| o.block_clock.is_none_or(|[clock, _]| clock == 1))
            .cloned()
            .collect::<Vec<_>>()
    };
    let all: Vec<OperatorFacts> = contents.stages.iter().flat_map(first).collect();
    let core =
        format!("{} by {}, latency {} clocks", contents.name, contents.method, contents.latency);
    let bits = format!(
        "{total}: {in_blocks} in blocks, {flip_flops} in flip-flops, {in_memories} in memories"
    );
    let slowest =
        contents.slowest_path.as_ref().map(|path| format!("{:.2} ns: {}", path.ns, way(path)));
    let rows = [
        ("core", Some(core)),
        ("operators", Some(counted(&all.iter().collect::<Vec<_>>()))),
        ("register bits", Some(bits)),
        (
            "made for",
            Some(
                contents
                    .made_for_in_words
                    .clone()
                    .unwrap_or_else(|| "any device: a register behind each operator".to_owned()),
            ),
        ),
        ("slowest path", slowest),
        ("highest clock", highest(contents)),
    ];
    rows.into_iter().filter_map(|(name, value)| Some([name.to_owned(), value?])).collect()
}

/// The highest clock, and what limits it.
fn highest(contents: &Contents) -> Option<String> {
    let mhz = contents.highest_mhz?;
    let limit = contents.limited_by.as_ref().map(limit_in_words);
    let limit = limit.unwrap_or("nothing limits it below that".to_owned());
    Some(format!("{mhz} MHz: {limit}"))
}

fn limit_in_words(limit: &LimitFacts) -> String {
    let (kind, from, to, ns) = match limit {
        LimitFacts::Operator { from, to, ns } => ("operator", from, to, ns),
        LimitFacts::Loop { from, to, ns } => ("loop", from, to, ns),
        LimitFacts::Carries { needed, most } => {
            return format!(
                "sums in shorter pieces have {needed} carries between them, of which placement \
                 keeps {most} short"
            );
        }
    };
    if from == to {
        format!("the {kind} {to} takes {ns:.2} ns")
    } else {
        format!("the {kind} from {from} to {to} takes {ns:.2} ns")
    }
}

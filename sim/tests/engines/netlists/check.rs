//! Whether a run gives what the interpreter gives.
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Once;

use specula_datapath::design::{NodeId, Op};
use specula_fixtures::Draw;
use specula_sim::fast::{InstructionSet, Settings};

use crate::netlists::case::{Case, Subject};

/// How a run went wrong.
#[derive(Clone, Debug)]
pub enum Failure {
    Panic(String),
    Error(String),
    Clocks { wanted: usize, got: usize },
    Value { signal: String, op: Op, clock: usize, wanted: i64, got: i64 },
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Failure::Panic(message) => write!(f, "panic: {message}"),
            Failure::Error(message) => write!(f, "error: {message}"),
            Failure::Clocks { wanted, got } => write!(f, "{got} clocks, not {wanted}"),
            Failure::Value { signal, op, clock, wanted, got } => {
                write!(f, "{signal} ({op:?}) is {got} at clock {clock} of the run, not {wanted}")
            }
        }
    }
}

/// What is wrong with a run, if anything.
pub fn failure(case: &Case) -> Option<Failure> {
    let expected = case.expected().ok()?;
    let columns = match quietly(|| case.run()) {
        Err(message) => return Some(Failure::Panic(message)),
        Ok(Err(error)) => return Some(Failure::Error(error.to_string())),
        Ok(Ok(columns)) => columns,
    };
    for (&node, got) in case.watched.iter().zip(&columns.values) {
        let wanted = &expected[node.0 as usize];
        if wanted.len() != got.len() {
            return Some(Failure::Clocks { wanted: wanted.len(), got: got.len() });
        }
        if let Some(clock) = wanted.iter().zip(got).position(|(w, g)| w != g) {
            let (signal, op) = (case.design.full_name(node), case.design.node(node).op);
            return Some(Failure::Value {
                signal,
                op,
                clock,
                wanted: wanted[clock],
                got: got[clock],
            });
        }
    }
    None
}

thread_local! {
    static QUIET: Cell<bool> = const { Cell::new(false) };
}

/// Runs `f`; a panic in it prints nothing and becomes its message.
fn quietly<T>(f: impl FnOnce() -> T) -> Result<T, String> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if !QUIET.with(Cell::get) {
                usual(info);
            }
        }));
    });
    QUIET.with(|quiet| quiet.set(true));
    let result = catch_unwind(AssertUnwindSafe(f));
    QUIET.with(|quiet| quiet.set(false));
    result.map_err(|payload| {
        let text = payload.downcast_ref::<String>().cloned();
        text.or_else(|| payload.downcast_ref::<&str>().map(|s| (*s).to_owned())).unwrap_or_default()
    })
}

const BATCHES: [usize; 6] = [1, 2, 7, 64, 512, 1000];

/// A netlist in several settings: all signals and some, short and long batches, both instruction
/// sets, from the beginning and late.
pub fn views(case: &Case, draw: &mut Draw) -> Vec<Case> {
    let all: Vec<NodeId> = (0..case.design.nodes.len() as u32).map(NodeId).collect();
    let view =
        |watched: &[NodeId], subject| Case { watched: watched.to_vec(), subject, ..case.clone() };
    let mut views = vec![view(&all, Subject::RustHdl)];
    for batch in BATCHES {
        let instruction_set =
            if draw.below(2) == 0 { InstructionSet::BASELINE } else { InstructionSet::best() };
        let subject = Subject::Fast(Settings { batch, instruction_set, ..Settings::default() });
        views.push(view(&all, subject));
        // Few signals leave much to be fused and memory to be shared.
        let few = 1 + draw.below(3);
        views.push(view(&picked(&all, few, draw), subject));
        let some = 1 + draw.below(all.len());
        let late =
            Case { window: Some(window(case, draw)), ..view(&picked(&all, some, draw), subject) };
        views.push(late);
    }
    views.extend(threaded(case, &all, draw));
    views
}

/// Two threads on short pieces, for all signals and for some.
fn threaded(case: &Case, all: &[NodeId], draw: &mut Draw) -> [Case; 2] {
    [all.len(), 1 + draw.below(all.len())].map(|count| {
        let piece = [1, 3, 10, 50][draw.below(4)];
        let settings = Settings {
            batch: BATCHES[draw.below(BATCHES.len())],
            threads: 2,
            piece,
            ..Settings::default()
        };
        Case { watched: picked(all, count, draw), subject: Subject::Fast(settings), ..case.clone() }
    })
}

fn picked(all: &[NodeId], count: usize, draw: &mut Draw) -> Vec<NodeId> {
    (0..count).map(|_| all[draw.below(all.len())]).collect()
}

fn window(case: &Case, draw: &mut Draw) -> std::ops::Range<u64> {
    let end = case.stimulus().clocks().end;
    let first = draw.below(end as usize) as u64;
    first..(first + 1 + draw.below(40) as u64).min(end)
}

//! What is said of a schedule. It serialises as the JSON that `schedule --json` prints.
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::design::{NodeId, Op};
use specula_datapath::pass::ClockLimit;
use specula_datapath::stages::{Carried, Computed, OperatorKind, Stage};
use specula_spec::CoreSpec;

use crate::made_for::{MadeFor, Prediction};

/// The core that is described.
pub struct Core<'a> {
    pub name: &'a str,
    pub spec: &'a CoreSpec,
    pub design: &'a Design,
    /// The highest clock in MHz that its target allows it, and what limits it.
    pub limit: Option<(f64, Option<ClockLimit>)>,
}

/// A schedule.
#[derive(Serialize)]
pub struct Contents {
    pub name: String,
    pub method: &'static str,
    /// Clocks from a pixel's entry to its exit.
    pub latency: u32,
    /// The target, its clock, and what is predicted; none of a core for any device.
    pub made_for: Option<Prediction>,
    #[serde(skip)]
    pub made_for_in_words: Option<String>,
    /// Nanoseconds from clock to clock that were asked for.
    pub period_ns: Option<f64>,
    /// The slowest path of all.
    pub slowest_path: Option<PathFacts>,
    /// The highest clock that the target allows, in MHz.
    pub highest_mhz: Option<f64>,
    /// What keeps it from being higher.
    pub limited_by: Option<LimitFacts>,
    pub stages: Vec<StageFacts>,
    /// Register bits of all clocks.
    pub register_bits: CarriedFacts,
}

/// A clock.
#[derive(Serialize)]
pub struct StageFacts {
    /// Counted from the one in which a pixel enters.
    pub clock: u32,
    /// The longest path that ends in it; none without a target, and where nothing ends.
    pub longest_path: Option<PathFacts>,
    pub operators: Vec<OperatorFacts>,
    /// Register bits that take over at its end.
    pub carried: CarriedFacts,
}

/// An operator in one of its clocks.
#[derive(Clone, Serialize)]
pub struct OperatorFacts {
    pub kind: &'static str,
    #[serde(skip)]
    pub sort: OperatorKind,
    /// Bits of the result; of a product, of both factors; of a comparison, of the wider operand.
    pub widths: Vec<u32>,
    /// Name of the signal, with its units.
    pub name: String,
    /// Of a product in a multiplier block: which of the block's clocks this is, and how many it has.
    pub block_clock: Option<[u32; 2]>,
}

/// A path between registers.
#[derive(Clone, Serialize)]
pub struct PathFacts {
    pub ns: f64,
    /// What is left of the period that was asked for.
    pub slack_ns: f64,
    /// The register or input that it begins at.
    pub from: String,
    /// Operators on the way.
    pub operators: Vec<OperatorFacts>,
    /// Every signal on the way, wires included.
    pub signals: Vec<String>,
}

/// Register bits.
#[derive(Clone, Copy, Serialize)]
pub struct CarriedFacts {
    pub in_blocks: u64,
    pub flip_flops: u64,
    pub in_memories: u64,
    pub total: u64,
}

/// What limits the clock.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum LimitFacts {
    Operator { from: String, to: String, ns: f64 },
    Loop { from: String, to: String, ns: f64 },
    Carries { needed: u32, most: u32 },
}

impl Contents {
    /// What is said of a core.
    pub fn of(core: &Core) -> Contents {
        let Core { name, spec, design, limit } = core;
        let made_for = MadeFor::of(spec, design);
        let describing = Describing { design, made_for: made_for.as_ref() };
        let stages: Vec<Stage> = design.stages();
        let carried = stages.iter().map(|stage| stage.carried);
        let register_bits = carried.fold(Carried::default(), Carried::plus);
        let limited_by = limit.as_ref().and_then(|(_, limit)| limit.as_ref());
        Contents {
            name: (*name).to_owned(),
            method: spec.method().name(),
            latency: design.latency(),
            period_ns: made_for.as_ref().map(MadeFor::period),
            slowest_path: made_for
                .as_ref()
                .and_then(|made_for| describing.path(made_for, *made_for.timing.path.last()?)),
            made_for_in_words: made_for.as_ref().map(MadeFor::in_words),
            made_for: made_for.as_ref().map(MadeFor::prediction),
            highest_mhz: limit.as_ref().map(|(mhz, _)| *mhz),
            limited_by: limited_by.map(limit_facts),
            stages: (0..).zip(&stages).map(|(clock, of)| describing.stage(clock, of)).collect(),
            register_bits: carried_facts(register_bits),
        }
    }
}

/// A design that is described.
struct Describing<'a> {
    design: &'a Design,
    made_for: Option<&'a MadeFor>,
}

impl Describing<'_> {
    fn stage(&self, clock: u32, stage: &Stage) -> StageFacts {
        let longest_path = self.made_for.and_then(|made_for| {
            let arrival = |id: &NodeId| made_for.timing.arrival(*id);
            let ends = stage.ends.iter().copied().filter(|id| arrival(id) > 0.0);
            let last = ends.max_by(|one, other| arrival(one).total_cmp(&arrival(other)))?;
            self.path(made_for, last)
        });
        let operators = stage.operators.iter().filter_map(|&computed| self.operator(computed));
        StageFacts {
            clock,
            longest_path,
            operators: operators.collect(),
            carried: carried_facts(stage.carried),
        }
    }

    fn path(&self, made_for: &MadeFor, end: NodeId) -> Option<PathFacts> {
        let signals = made_for.timing.path_to(self.design, end);
        let (&from, rest) = signals.split_first()?;
        let ns = made_for.timing.arrival(end);
        let operators =
            rest.iter().filter_map(|&node| self.operator(Computed { node, in_block: None }));
        Some(PathFacts {
            ns,
            slack_ns: made_for.period() - ns,
            from: self.name(from),
            operators: operators.collect(),
            signals: signals.iter().map(|&id| self.name(id)).collect(),
        })
    }

    fn operator(&self, Computed { node: id, in_block }: Computed) -> Option<OperatorFacts> {
        let sort = self.design.operator_kind(id)?;
        Some(OperatorFacts {
            kind: sort.words()[0],
            sort,
            widths: self.widths(id),
            name: self.name(id),
            block_clock: in_block.map(|(clock, clocks)| [clock, clocks]),
        })
    }

    fn widths(&self, id: NodeId) -> Vec<u32> {
        let node = self.design.node(id);
        let width = |id: NodeId| self.design.node(id).width();
        let block = self.design.multipliers.iter().find(|block| block.product == id);
        let factors = block.map(|block| block.factors).or(self.design.factors(node));
        match (factors, node.op) {
            (Some(factors), _) => factors.map(width).to_vec(),
            (None, Op::LessThan(a, b)) => vec![width(a).max(width(b))],
            (None, _) => vec![node.width()],
        }
    }

    /// A signal's name with its units, the core apart.
    fn name(&self, id: NodeId) -> String {
        let name = self.design.full_name(id);
        name.split_once('.').map_or(name.clone(), |(_, rest)| rest.to_owned())
    }
}

fn limit_facts(limit: &ClockLimit) -> LimitFacts {
    let below = |name: &str| name.split_once('.').map_or(name, |(_, rest)| rest).to_owned();
    match limit {
        &ClockLimit::Carries { needed, most } => LimitFacts::Carries { needed, most },
        ClockLimit::Path { from, to, in_loop, delay } => {
            let (from, to, ns) = (below(from), below(to), *delay);
            if *in_loop {
                LimitFacts::Loop { from, to, ns }
            } else {
                LimitFacts::Operator { from, to, ns }
            }
        }
    }
}

fn carried_facts(carried: Carried) -> CarriedFacts {
    let Carried { in_blocks, flip_flops, in_memories } = carried;
    CarriedFacts { in_blocks, flip_flops, in_memories, total: carried.total() }
}

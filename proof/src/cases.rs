//! The ways to answer a question, and the cases that each of them has.
mod branch;
mod dot;

use specula_datapath::bound::Interval;
use specula_datapath::design::{NodeId, Op};
use specula_datapath::graph::{Graph, RealId, Rule};
use specula_datapath::pass::Bounds;

use super::script::Writer;
use super::{About, Alternative, Detail, Goal, Script, number};
use branch::{Branch, branches};

/// What the rules for choices rest on: fixed-point and real value take the same branch, or both meet.
const SAME_CHOICE: &str = "same choice, or the branches meet";

/// What a register's value rests on.
const HOLDS: &str = "a register holds what it was given";

/// What the rule for accumulators rests on.
const CLOSED_FORM: &str = "a loop adds its step once a pixel";

/// The branch of a clamp, an absolute value or a choice that the real value takes.
#[derive(Clone, Copy)]
enum RealCase {
    /// The operand itself; of a clamp or an absolute value, on the side where it is left as it is.
    Kept(RealId),
    /// The limit that a clamp puts in its place.
    Limit(RealId, f64),
    /// What a register holds of several.
    Held(RealId),
    /// The operand with the other sign.
    Negated(RealId),
}

/// Ways to prove what is stated of a real value.
pub fn alternatives(
    graph: &Graph,
    bounds: &Bounds,
    id: RealId,
    detail: Detail,
) -> Vec<Alternative> {
    let new = || Writer::new(graph, bounds, id, detail);
    match &graph.real(id).rule {
        Rule::Table { .. } | Rule::LoopInvariant { .. } => vec![],
        Rule::Overridden { .. } => alternative([new().overridden()]).into_iter().collect(),
        Rule::Accumulated { start, step, steps } => {
            alternative([Some(new().accumulated([*start, *step], *steps))]).into_iter().collect()
        }
        Rule::DotProduct { of, .. } => {
            let sum = new().sum_of_products(*of);
            let whole = new().dot_product();
            [alternative([Some(sum)]), alternative([Some(whole)])].into_iter().flatten().collect()
        }
        Rule::Remainder(of) => alternative([Some(new().remainder(*of))]).into_iter().collect(),
        rule => {
            let pairs = cases(graph, id, rule);
            if pairs.is_empty() {
                return alternative([new().plain()]).into_iter().collect();
            }
            let scripts = pairs.iter().map(|(branch, real)| Some(new().case(*branch, *real)));
            alternative(scripts).into_iter().collect()
        }
    }
}

type Written = (Vec<Script>, std::collections::BTreeSet<String>);

fn alternative(scripts: impl IntoIterator<Item = Option<Written>>) -> Option<Alternative> {
    let mut of = Alternative { premises: Default::default(), cases: vec![] };
    for (scripts, premises) in scripts.into_iter().flatten() {
        of.premises.extend(premises);
        of.cases.extend(scripts);
    }
    (!of.cases.is_empty()).then_some(of)
}

/// Which branch the fixed-point and the real value take; none where there are no branches.
fn cases(graph: &Graph, id: RealId, rule: &Rule) -> Vec<(Branch, RealCase)> {
    let node = graph.real(id).value;
    // Where a clamp or an absolute value never does anything, its value is its operand's.
    let is_operand = rule.operands().iter().any(|&of| graph.real(of).value == node);
    let branches = if is_operand { vec![None] } else { branches(graph, node) };
    let each = |reals: &[RealCase]| {
        let pair = |&branch: &Branch| reals.iter().map(move |&real| (branch, real));
        branches.iter().flat_map(pair).collect()
    };
    match rule {
        Rule::ClampedBelow(a, limit) | Rule::ClampedAbove(a, limit) => {
            each(&[RealCase::Kept(*a), RealCase::Limit(*a, *limit)])
        }
        Rule::Absolute(a) => each(&[RealCase::Kept(*a), RealCase::Negated(*a)]),
        Rule::Choice(a, b) => {
            let taken = |&branch: &Branch| match branch {
                Some((_, true)) => vec![(branch, RealCase::Kept(*a))],
                Some((_, false)) => vec![(branch, RealCase::Kept(*b))],
                None => taken_always(graph, id, [*a, *b]).map(|of| (branch, of)).collect(),
            };
            branches.iter().flat_map(taken).collect()
        }
        Rule::AnyOf(all) => all.iter().map(|&of| (None, RealCase::Kept(of))).collect(),
        _ => vec![],
    }
}

/// Of a choice that is always the same the branch that it is; of a register that holds either, both.
fn taken_always(graph: &Graph, id: RealId, of: [RealId; 2]) -> impl Iterator<Item = RealCase> {
    let raw = |id: RealId| {
        let value = source(graph, graph.real(id).value);
        (graph.value(value).op.constant(), value)
    };
    let is_same = |of: &RealId| match (raw(id), raw(*of)) {
        ((Some(a), _), (Some(b), _)) => a == b,
        ((_, a), (_, b)) => a == b,
    };
    let same = of.iter().copied().find(is_same);
    let both = of.into_iter().filter(move |&of| same.is_none_or(|same| of == same));
    let is_held = graph.is_state(graph.value(graph.real(id).value));
    both.map(move |of| if is_held { RealCase::Held(of) } else { RealCase::Kept(of) })
}

/// What a value is a copy of, more bits at the right or not.
fn source(graph: &Graph, id: NodeId) -> NodeId {
    let value = graph.value(id);
    match value.op {
        Op::Copy(of) | Op::ShiftLeft(of, _) if !graph.is_state(value) => source(graph, of),
        _ => id,
    }
}

impl Writer<'_> {
    /// A value that is neither parted into cases nor a loop's.
    fn plain(mut self) -> Option<Written> {
        let goal = self.goal;
        let fixed = self.fixed_of(goal);
        let real = self.real(goal);
        let range = self.range_goal(&fixed);
        let goals = range.into_iter().chain([self.error_goal(&fixed, &real)]);
        let goals = goals.chain(self.real_goal(&real)).collect();
        Some(self.written(goals))
    }

    /// A value of which only the range is asked.
    fn overridden(mut self) -> Option<Written> {
        let fixed = self.fixed_of(self.goal);
        let goals: Vec<Goal> = self.range_goal(&fixed).into_iter().collect();
        (!goals.is_empty()).then(|| self.written(goals))
    }

    /// Start and step, `i` times: closed form of the loop.
    fn accumulated(mut self, [start, step]: [RealId; 2], steps: u32) -> Written {
        let [fixed_start, fixed_step] = [start, step].map(|id| self.fixed_of(id));
        let [real_start, real_step] = [start, step].map(|id| self.real(id));
        self.suppose(format!("steps in [0, {steps}]"));
        let fixed = self.define('F', "value", format!("{fixed_start} + steps * {fixed_step}"));
        let real = self.define('R', "value", format!("{real_start} + steps * {real_step}"));
        self.premises.insert(CLOSED_FORM.to_owned());
        let goal = self.error_goal(&fixed, &real);
        self.written(vec![goal])
    }

    /// What a multiple of a power of two leaves: fixed-point and real value are less by the same.
    fn remainder(mut self, of: RealId) -> Written {
        let fixed = self.fixed_of(self.goal);
        let (whole, real) = (self.fixed_of(of), self.real(of));
        let rest = self.define('R', "rest", format!("{fixed} - ({whole} - {real})"));
        let goal = self.error_goal(&fixed, &rest);
        self.written(vec![goal])
    }

    /// One branch each of the fixed-point and of the real value.
    fn case(mut self, branch: Branch, real_case: RealCase) -> Written {
        let goal = self.goal;
        let node = self.graph.real(goal).value;
        let at = i64::from(self.graph.value(node).fraction_bits)
            - i64::from(self.graph.real(goal).fraction_bits);
        let fixed = match real_case {
            RealCase::Held(of) => self.fixed_of(of),
            _ => {
                let fixed = self.in_branch(node, branch);
                self.moved(fixed, at)
            }
        };
        let fixed = self.define('F', "taken", fixed);
        let real = self.branch_of_real(real_case, &fixed);
        let goals = [self.case_range_goal(node, &fixed), Some(self.error_goal(&fixed, &real))];
        let goals = goals.into_iter().flatten().chain(self.real_goal(&real)).collect();
        self.written(goals)
    }

    fn branch_of_real(&mut self, case: RealCase, taken: &str) -> String {
        let (RealCase::Kept(of)
        | RealCase::Limit(of, _)
        | RealCase::Negated(of)
        | RealCase::Held(of)) = case;
        let real = self.real(of);
        let fixed = self.fixed_of(of);
        let rule = &self.graph.real(self.goal).rule;
        match (case, rule) {
            (RealCase::Kept(_), Rule::ClampedBelow(_, limit)) => {
                self.suppose(format!("{real} >= {}", number::of(*limit)));
                self.by_way_of([taken, &fixed, &real]);
                real
            }
            (RealCase::Kept(_), Rule::ClampedAbove(_, limit)) => {
                self.suppose(format!("{real} <= {}", number::of(*limit)));
                self.by_way_of([taken, &fixed, &real]);
                real
            }
            (RealCase::Limit(_, limit), Rule::ClampedBelow(..)) => {
                self.suppose(format!("{real} <= {}", number::of(limit)));
                let limit = self.number(limit);
                self.beyond_limit([taken, &real, &limit]);
                limit
            }
            (RealCase::Limit(_, limit), _) => {
                self.suppose(format!("{real} >= {}", number::of(limit)));
                let limit = self.number(limit);
                self.beyond_limit([taken, &real, &limit]);
                limit
            }
            (RealCase::Kept(_), Rule::Absolute(_)) => {
                self.suppose(format!("{real} >= 0"));
                self.hint(&fixed, &format!("({fixed} - {real}) + {real}"));
                real
            }
            (RealCase::Negated(_), _) => {
                self.suppose(format!("{real} <= 0"));
                self.hint(&fixed, &format!("({fixed} - {real}) + {real}"));
                self.define('R', "negated", format!("0 - {real}"))
            }
            (RealCase::Held(_), _) => {
                self.premises.insert(HOLDS.to_owned());
                real
            }
            (RealCase::Kept(_), Rule::Choice(..)) => {
                self.premises.insert(SAME_CHOICE.to_owned());
                real
            }
            (RealCase::Kept(_), _) => real,
        }
    }

    /// Where the fixed value is at the limit and the real one is not: by way of the operand.
    fn by_way_of(&mut self, [taken, fixed, real]: [&str; 3]) {
        if taken != fixed && fixed != real {
            let by_way = format!("({taken} - {fixed}) + ({fixed} - {real})");
            self.hint(&format!("{taken} - {real}"), &by_way);
        }
    }

    /// Where the real value is at the limit and the fixed one is not.
    fn beyond_limit(&mut self, [taken, real, limit]: [&str; 3]) {
        if taken != limit {
            let by_way = format!("({taken} - {real}) + ({real} - {limit})");
            self.hint(&format!("{taken} - {limit}"), &by_way);
        }
    }

    fn written(mut self, goals: Vec<Goal>) -> Written {
        let premises = std::mem::take(&mut self.premises);
        let goals = goals.into_iter().map(|goal| self.named_goal(goal)).collect();
        (self.finish(goals), premises)
    }

    /// The range of the fixed value, where the unit computes it.
    fn range_goal(&self, fixed: &str) -> Option<Goal> {
        let node = self.graph.real(self.goal).value;
        let is_computed = self.is_defined(fixed);
        if is_computed { self.case_range_goal(node, fixed) } else { None }
    }

    fn case_range_goal(&self, node: NodeId, fixed: &str) -> Option<Goal> {
        let range = self.graph.value(node).range;
        let at = -i64::from(self.graph.real(self.goal).fraction_bits);
        let ulp = specula_datapath::format::power_of_two(at);
        let stated = Interval::new(below(range.low) * ulp, above(range.high) * ulp);
        Some(Goal { about: About::Range, expression: fixed.to_owned(), stated })
    }

    fn error_goal(&self, fixed: &str, real: &str) -> Goal {
        let error = self.bounds.of(self.goal).error;
        let expression = format!("{fixed} - {real}");
        Goal { about: About::Error, expression, stated: Interval::new(-error, error) }
    }

    /// The interval of the real value, where more is stated than follows of the others.
    fn real_goal(&self, real: &str) -> Option<Goal> {
        let bound = self.bounds.of(self.goal);
        let follows = bound.fixed.enlarged_by(bound.error);
        (bound.real != follows).then(|| Goal {
            about: About::Real,
            expression: real.to_owned(),
            stated: bound.real,
        })
    }
}

/// The largest f64 that is no larger.
fn below(raw: i64) -> f64 {
    let nearest = raw as f64;
    if nearest as i128 > i128::from(raw) { nearest.next_down() } else { nearest }
}

/// The smallest f64 that is no smaller.
fn above(raw: i64) -> f64 {
    -below_of_negated(raw)
}

fn below_of_negated(raw: i64) -> f64 {
    let nearest = -(raw as f64);
    if (nearest as i128) > -i128::from(raw) { nearest.next_down() } else { nearest }
}

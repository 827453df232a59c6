//! What each rule means for error and real value.
use crate::bound::{Bound, ErrorBound, ErrorModel, Interval};
use crate::format::power_of_two;
use crate::graph::{Graph, RealId, RealValue, Rule};

use super::Bounds;

/// What a rule says, before the range of the fixed value is looked at.
struct Derived {
    error: f64,
    model: ErrorModel,
    real: Interval,
}

impl Derived {
    /// An error of which nothing else is known, and a real value that may be near any fixed one.
    fn bounded(error: f64) -> Derived {
        Derived { error, model: ErrorModel::Bounded, real: Interval::ANY }
    }

    fn same(Bound { error, model, real, .. }: Bound) -> Derived {
        Derived { error, model, real }
    }

    fn with_real(self, real: Interval) -> Derived {
        Derived { real, ..self }
    }
}

/// What is known of a real value whose operands' bounds are there.
pub(super) fn bound(graph: &Graph, bounds: &Bounds, of: &RealValue) -> Bound {
    let range = graph.value(of.value).range;
    let ulp = power_of_two(-i64::from(of.fraction_bits));
    let fixed = Interval::new(range.low as f64, range.high as f64).scaled(ulp);
    let Derived { error, model, real } = derived(graph, bounds, &of.rule, (fixed, ulp));
    // No number is no bound.
    let error = if error.is_nan() { f64::INFINITY } else { error };
    Bound { error, model, fixed, real: real.intersection(fixed.enlarged_by(error)), ulp }
}

fn derived(graph: &Graph, bounds: &Bounds, rule: &Rule, (fixed, ulp): (Interval, f64)) -> Derived {
    let of = |id: &RealId| bounds.of(*id);
    match rule {
        Rule::Exact => Derived::bounded(0.0),
        Rule::Input { error, real } => Derived::bounded(*error).with_real(*real),
        Rule::Table { error } | Rule::LoopInvariant { error } => Derived::bounded(*error),
        Rule::Same(a) => Derived::same(of(a)),
        Rule::Scaled(a, exponent) => {
            let (a, factor) = (of(a), power_of_two((*exponent).into()));
            Derived::bounded(a.error * factor).with_real(a.real.scaled(factor))
        }
        Rule::Sum(a, b) => {
            Derived::bounded(of(a).error + of(b).error).with_real(of(a).real.plus(of(b).real))
        }
        Rule::Difference(a, b) => {
            Derived::bounded(of(a).error + of(b).error).with_real(of(a).real.minus(of(b).real))
        }
        Rule::Product(a, b) => {
            Derived::bounded(product_error(of(a), of(b))).with_real(of(a).real.times(of(b).real))
        }
        Rule::Square(a) => Derived::bounded((2.0 * of(a).magnitude() + of(a).error) * of(a).error)
            .with_real(of(a).real.squared()),
        Rule::Rounded(a) => Derived::bounded(of(a).error + 0.5 * ulp).with_real(of(a).real),
        Rule::Truncated(a) => Derived::bounded(of(a).error + ulp).with_real(of(a).real),
        Rule::Remainder(a) => Derived::bounded(of(a).error),
        Rule::ClampedBelow(a, limit) => {
            clamped(of(a), *limit <= of(a).fixed.low, of(a).real.clamped_below(*limit), fixed)
        }
        Rule::ClampedAbove(a, limit) => {
            clamped(of(a), of(a).fixed.high <= *limit, of(a).real.clamped_above(*limit), fixed)
        }
        Rule::Absolute(a) => Derived {
            error: of(a).error,
            model: if of(a).fixed.low >= 0.0 { of(a).model } else { ErrorModel::Bounded },
            real: of(a).real.absolute(),
        },
        Rule::Choice(a, b) => chosen(of(a), of(b)),
        Rule::AnyOf(all) => any_of(all.iter().map(of)),
        Rule::Accumulated { start, step, steps } => {
            Derived::bounded(of(start).error + f64::from(*steps) * of(step).error)
        }
        Rule::DotProduct { of: sum, vectors, lengths, truncated } => {
            let [a, b] = vectors.map(|vector| bounds.of_vector(graph, vector));
            let error = truncated + dot_product_error(*lengths, [a.error.length, b.error.length]);
            let squared = vectors[0] == vectors[1];
            let least = if squared { a.shortest * a.shortest } else { f64::NEG_INFINITY };
            Derived::bounded(error.min(of(sum).error))
                .with_real(of(sum).real.intersection(Interval::at_least(least)))
        }
        Rule::Tightened { of: a, bound: ErrorBound { error, model }, .. } => Derived {
            error: error.min(of(a).error),
            model: if *model == ErrorModel::Bounded { of(a).model } else { *model },
            real: of(a).real,
        },
        Rule::Overridden { bound: ErrorBound { error, model }, .. } => {
            Derived { error: *error, model: *model, real: Interval::ANY }
        }
        Rule::Within { of: a, real, .. } => {
            Derived::same(of(a)).with_real(of(a).real.intersection(*real))
        }
    }
}

/// |ab - a'b'| ≤ |a'| e_b + |b'| e_a + e_a e_b.
fn product_error(a: Bound, b: Bound) -> f64 {
    a.magnitude() * b.error + b.magnitude() * a.error + a.error * b.error
}

/// With vectors off by e_a and e_b a dot product is off by |a| e_b + |b| e_a + e_a e_b.
fn dot_product_error([a, b]: [f64; 2], [error_a, error_b]: [f64; 2]) -> f64 {
    a * error_b + b * error_a + error_a * error_b
}

/// Fixed and real value come no further apart where both are clamped, nor than the one can be from
/// the other's range. What is known of the error besides stays true where the fixed value never
/// meets the limit.
fn clamped(of: Bound, never: bool, real: Interval, fixed: Interval) -> Derived {
    Derived {
        error: of.error.min(real.furthest_from(fixed)),
        model: if never { of.model } else { ErrorModel::Bounded },
        real,
    }
}

/// The bound is the larger of the two, also where the bit is always the same: it holds where the
/// real value takes the same branch, or the branches meet. What is known of an error besides is
/// still true where the other branch is 0 exactly.
fn chosen(a: Bound, b: Bound) -> Derived {
    let zero = |bound: Bound| bound.fixed == Interval::new(0.0, 0.0) && bound.is_exact();
    let model = match (zero(a), zero(b)) {
        (false, true) => a.model,
        (true, false) => b.model,
        _ => ErrorModel::Bounded,
    };
    Derived { error: a.error.max(b.error), model, real: a.real.hull(b.real) }
}

/// The largest error, and wherever one of the real values may lie.
fn any_of(all: impl Iterator<Item = Bound>) -> Derived {
    let hull = |a: Derived, b: Derived| Derived {
        error: a.error.max(b.error),
        model: if a.model == b.model { a.model } else { ErrorModel::Bounded },
        real: a.real.hull(b.real),
    };
    all.map(Derived::same).reduce(hull).unwrap_or(Derived::bounded(f64::INFINITY))
}

//! Gappa and the bounds pass: both find the same bounds, and a bound that is too small is found.
use std::time::Duration;

use specula_datapath::builder::{Builder, Vector};
use specula_datapath::graph::{Graph, Rule};
use specula_datapath::{Format, InputPort};
use specula_fixtures::tools;
use specula_proof::{About, Standing, gappa, prove};

const LIMIT: Duration = Duration::from_secs(20);

/// A unit that rounds a dot product and keeps it within 0 to 1.
fn dot_product(proof: impl Fn(f64) -> f64) -> Graph {
    let builder = Builder::new("core", "max(A.B, 0), rounded");
    let control = builder.control();
    let format = Format::signed(0, 9);
    let vector = |name: &str| {
        let component = |axis: &str| {
            let port = InputPort::whole(format!("{name}_{axis}"), format);
            builder.input(&InputPort {
                real: specula_datapath::bound::Interval::new(-1.0, 1.0),
                ..port
            })
        };
        Vector::new(["x", "y", "z"].map(component))
    };
    let (a, b) = (vector("a"), vector("b"));
    let cosine = builder.unit("cosine", "max(A.B, 0)", (("a", &a), ("b", &b)), |_, (a, b)| {
        let rounded = a.dot(&b).rounded(8);
        let stated = proof(rounded.error_value());
        let rounded = rounded.override_error("error::test", stated).named("rounded");
        rounded.at_least_zero().clamped_above(1).named("cosine")
    });
    let sum = (&cosine + &cosine * &cosine).truncated(6);
    builder.graph(&control.valid, &[("sum", sum)]).expect("it is a graph")
}

#[test]
fn bounds_of_a_rounded_dot_product_are_proven() {
    if !tools::is_installed(gappa::COMMAND) {
        return;
    }
    let answers = prove(&dot_product(|error| error), LIMIT).expect("Gappa answers");
    let standings = answers.iter().flat_map(|(question, outcomes)| {
        outcomes.iter().map(move |outcome| (question.signal.clone(), outcome.clone()))
    });
    let standings: Vec<_> = standings.collect();
    assert!(standings.len() > 6, "{standings:?}");
    for (signal, outcome) in &standings {
        assert!(outcome.standing <= Standing::Fact, "{signal}: {outcome:?}");
    }
    // Nothing but what the unit overrides is taken for granted.
    let facts = standings.iter().filter(|(_, outcome)| outcome.standing == Standing::Fact);
    let facts: Vec<_> = facts.map(|(_, outcome)| (outcome.about, outcome.premises.len())).collect();
    assert_eq!(facts, [(About::Error, 1)]);
}

#[test]
fn a_bound_that_is_too_small_is_found() {
    if !tools::is_installed(gappa::COMMAND) {
        return;
    }
    let mut graph = dot_product(|error| error);
    // A rounding is forgotten: what is truncated counts as what it was.
    let truncated = graph.reals.iter_mut().rev().find_map(|real| match real.rule {
        Rule::Truncated(of) => Some((real, of)),
        _ => None,
    });
    let (real, of) = truncated.expect("the sum is truncated");
    real.rule = Rule::Scaled(of, 0);
    let answers = prove(&graph, LIMIT).expect("Gappa answers");
    let wrong = answers.iter().flat_map(|(question, outcomes)| {
        let wrong = outcomes.iter().filter(|outcome| outcome.standing == Standing::Unproven);
        wrong.map(move |outcome| (question, outcome))
    });
    let wrong: Vec<_> = wrong.collect();
    let [(_, outcome)] = wrong[..] else { panic!("one goal is wrong: {wrong:?}") };
    assert_eq!(outcome.about, About::Error);
    let found = outcome.found.expect("Gappa finds a bound").magnitude();
    let forgotten = 1.0 / 64.0;
    assert!(found > outcome.stated.magnitude(), "{outcome:?}");
    assert!(found <= outcome.stated.magnitude() + forgotten, "{outcome:?}");
}

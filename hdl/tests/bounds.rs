//! The pass over whole cores says what was known while they were described, in whatever order, and
//! names proofs that there are.
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::path::Path;

use specula_datapath::builder::Builder;
use specula_datapath::graph::{Graph, RealId, RealValue, RealVector, Rule, VectorId};
use specula_datapath::pass::bounds::{Bounds, bounds, premises};
use specula_fixtures::Draw;
use specula_hdl::cores;
use specula_scene::load;
use specula_spec::{CoreSpec, Method, SceneCore};

/// Cores of all methods, for a scene with lights of all kinds and for another, each for that scene
/// alone and for any.
fn specs() -> impl Iterator<Item = CoreSpec> {
    let scenes = ["teapot", "lamps"].map(|name| load(name, Some((48, 36))).unwrap());
    scenes.into_iter().flat_map(|scene| {
        let core = move |method| scene.core_spec(Some(method)).ok();
        let specs = Method::ALL.into_iter().filter_map(core);
        specs.flat_map(|spec| [spec.general(), spec])
    })
}

/// A core's graph, and what was known when it was described.
fn described(spec: &CoreSpec) -> (Graph, Bounds) {
    let kept = RefCell::new(None);
    let graph = cores::graph(spec, |formula| {
        let builder = Builder::new("core", formula);
        kept.replace(Some(builder.clone()));
        builder
    });
    let builder = kept.into_inner().unwrap();
    (graph.unwrap(), builder.bounds())
}

#[test]
fn the_pass_over_a_finished_graph_says_what_was_known_while_it_grew() {
    let mut cores = 0;
    for spec in specs() {
        let (graph, known) = described(&spec);
        assert_eq!(bounds(&graph), known, "{}", spec.method().name());
        assert!(graph.reals.len() > 50 && !graph.outputs.is_empty());
        cores += 1;
    }
    assert!(cores > 20, "{cores}");
}

/// Real values in another order, each after those that it depends on.
fn shuffled(graph: &Graph, draw: &mut Draw) -> (Graph, Vec<RealId>) {
    let needs: Vec<Vec<RealId>> = graph.reals.iter().map(|real| needed(graph, real)).collect();
    let mut order: Vec<RealId> = vec![];
    let mut placed = vec![false; needs.len()];
    let mut open: Vec<usize> = (0..needs.len()).collect();
    while !open.is_empty() {
        let ready: Vec<usize> = (0..open.len())
            .filter(|&at| needs[open[at]].iter().all(|need| placed[need.0 as usize]))
            .collect();
        // Several at once, the last described first.
        let some = ready.len().min(1 + draw.between(0, 40) as usize);
        for &at in ready.iter().rev().take(some) {
            let real = open.remove(at);
            placed[real] = true;
            order.push(RealId(real as u32));
        }
    }
    let mut new = vec![RealId(0); order.len()];
    for (at, old) in order.iter().enumerate() {
        new[old.0 as usize] = RealId(at as u32);
    }
    let map = |id: RealId| new[id.0 as usize];
    let real = |old: &RealId| {
        let RealValue { value, fraction_bits, rule } = graph.real(*old).clone();
        RealValue { value, fraction_bits, rule: renumbered(rule, map) }
    };
    let vector = |vector: &RealVector| RealVector {
        components: vector.components.map(map),
        rule: vector.rule.clone(),
    };
    let shuffled = Graph {
        reals: order.iter().map(real).collect(),
        vectors: graph.vectors.iter().map(vector).collect(),
        ..graph.clone()
    };
    (shuffled, new)
}

/// What a real value depends on, through vectors too.
fn needed(graph: &Graph, real: &RealValue) -> Vec<RealId> {
    let mut needed = real.rule.operands();
    let mut vectors: Vec<VectorId> = real.rule.vectors().to_vec();
    while let Some(id) = vectors.pop() {
        let vector = &graph.vectors[id.0 as usize];
        needed.extend(vector.components);
        vectors.extend(vector.rule.operands());
    }
    needed
}

fn renumbered(rule: Rule, map: impl Fn(RealId) -> RealId) -> Rule {
    match rule {
        Rule::Exact | Rule::Input { .. } | Rule::Table { .. } | Rule::LoopInvariant { .. } => rule,
        Rule::Same(a) => Rule::Same(map(a)),
        Rule::Scaled(a, exponent) => Rule::Scaled(map(a), exponent),
        Rule::Sum(a, b) => Rule::Sum(map(a), map(b)),
        Rule::Difference(a, b) => Rule::Difference(map(a), map(b)),
        Rule::Product(a, b) => Rule::Product(map(a), map(b)),
        Rule::Square(a) => Rule::Square(map(a)),
        Rule::Rounded(a) => Rule::Rounded(map(a)),
        Rule::Truncated(a) => Rule::Truncated(map(a)),
        Rule::Remainder(a) => Rule::Remainder(map(a)),
        Rule::ClampedBelow(a, limit) => Rule::ClampedBelow(map(a), limit),
        Rule::ClampedAbove(a, limit) => Rule::ClampedAbove(map(a), limit),
        Rule::Absolute(a) => Rule::Absolute(map(a)),
        Rule::Choice(a, b) => Rule::Choice(map(a), map(b)),
        Rule::AnyOf(all) => Rule::AnyOf(all.into_iter().map(map).collect()),
        Rule::Accumulated { start, step, steps } => {
            Rule::Accumulated { start: map(start), step: map(step), steps }
        }
        Rule::DotProduct { of, vectors, lengths, truncated } => {
            Rule::DotProduct { of: map(of), vectors, lengths, truncated }
        }
        Rule::Tightened { of, bound, proof } => Rule::Tightened { of: map(of), bound, proof },
        Rule::Overridden { of, bound, proof } => Rule::Overridden { of: map(of), bound, proof },
        Rule::Within { of, real, fact } => Rule::Within { of: map(of), real, fact },
    }
}

#[test]
fn no_bound_depends_on_the_order_of_statements() {
    for (seed, spec) in specs().enumerate().step_by(3) {
        let (graph, known) = described(&spec);
        let (other, new) = shuffled(&graph, &mut Draw::new(seed as u64));
        assert_ne!(other.reals, graph.reals, "nothing moved");
        let found = bounds(&other);
        for (old, &new) in new.iter().enumerate() {
            assert_eq!(found.of(new), known.of(RealId(old as u32)), "{}", spec.method().name());
        }
        for vector in (0..graph.vectors.len() as u32).map(VectorId) {
            assert_eq!(found.of_vector(&other, vector), known.of_vector(&graph, vector));
        }
    }
}

/// The proofs that the outputs of all cores rest on: each is a function of the module it names.
#[test]
fn proofs_stand_where_bounds_say() {
    let mut proofs = BTreeSet::new();
    for spec in specs() {
        let (graph, _) = described(&spec);
        for (_, output) in &graph.outputs {
            let names = premises(&graph, *output).into_iter();
            proofs.extend(names.filter(|name| name.starts_with("error::")).map(str::to_owned));
        }
    }
    assert!(proofs.len() > 15, "{proofs:?}");
    for proof in &proofs {
        let path: Vec<&str> = proof.split("::").collect();
        let [_, module, .., function] = path.as_slice() else { panic!("{proof}") };
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("src/error/{module}.rs"));
        let text =
            std::fs::read_to_string(&file).unwrap_or_else(|error| panic!("{proof}: {error}"));
        assert!(text.contains(&format!("fn {function}")), "{proof}");
    }
    // Every statement names one.
    let units = cores_text();
    for (at, _) in units.match_indices("_error(\"") {
        let name = &units[at + "_error(\"".len()..];
        assert!(name.starts_with("error::"), "{}", &name[..40.min(name.len())]);
    }
}

/// The source of all units and cores.
fn cores_text() -> String {
    fn read(folder: &Path, text: &mut String) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                read(&path, text);
            } else {
                text.push_str(&std::fs::read_to_string(path).unwrap());
            }
        }
    }
    let mut text = String::new();
    for folder in ["src/units", "src/cores"] {
        read(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder), &mut text);
    }
    text
}

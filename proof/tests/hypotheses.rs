//! Hypotheses that contradict each other would prove anything.
use std::time::Duration;

use specula_datapath::Builder;
use specula_datapath::bound::Interval;
use specula_fixtures::{Method, tools};
use specula_proof::gappa::{self, Answer};
use specula_proof::{About, Alternative, Detail, Goal, Script, questions};
use specula_spec::SceneCore;

/// Whether a script proves that 0 lies from 1 to 2.
fn proves_anything(script: &Script) -> bool {
    let wrong = Interval::new(1.0, 2.0);
    let wrong = Goal { about: About::Range, expression: "0".to_owned(), stated: wrong };
    let answer = gappa::asked(&script.stated(&[wrong]), Duration::from_secs(20));
    matches!(answer, Ok(Answer::Proven(_)))
}

/// A branch that no value takes may have such hypotheses, but not all branches.
fn has_a_case(alternative: &Alternative) -> bool {
    let given = alternative.cases.iter().filter(|script| script.has_hypotheses());
    let given: Vec<&Script> = given.collect();
    given.is_empty() || !given.into_iter().all(proves_anything)
}

#[test]
fn hypotheses_do_not_contradict_each_other() {
    if !tools::is_installed(gappa::COMMAND) {
        return;
    }
    let scene = specula_scene::load("teapot", None).expect("it is built in");
    for method in [Method::Lyon, Method::Gouraud] {
        let spec = scene.core_spec(Some(method)).expect("it has a core").specialised(&scene.frame);
        let graph = specula_hdl::cores::graph(&spec, |formula| Builder::new("core", formula));
        let graph = graph.expect("its formats fit");
        for question in questions(&graph, Detail::Unit) {
            let sound = question.alternatives.iter().all(has_a_case);
            assert!(sound, "{}, {}: hypotheses contradict", question.path, question.signal);
        }
    }
}

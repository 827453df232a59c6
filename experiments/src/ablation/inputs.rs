//! Ablations: the core elaborated without knowing what values some of its inputs are given.
use rayon::prelude::*;
use specula_spec::{CoreSpec, Given, InputPort, Subject};

use super::Ablation;
use specula_testbench::BenchError;

/// The ablations of inputs, group by group.
///
/// # Errors
/// [`BenchError::TooWide`] if such a core has too wide a signal.
pub fn of_inputs(spec: &CoreSpec) -> Result<Vec<Ablation>, BenchError> {
    let ports = spec.inputs();
    let ablation = |(need, safe, group): (&'static str, &'static str, Vec<&InputPort>)| {
        let left_out = described(spec, &group)?;
        let known = |name: &str| !group.iter().any(|port| port.name == name);
        let core = CoreSpec { specialisation: spec.specialisation.only(known), ..spec.clone() };
        let design = specula_hdl::elaborate(&core, "core").map_err(BenchError::from);
        Some(design.map(|design| Ablation { need, left_out, safe, design }))
    };
    groups(&ports).collect::<Vec<_>>().into_par_iter().filter_map(ablation).collect()
}

/// Inputs that a need is about. Coefficients that are the same in several channels are a need of
/// their own.
fn groups(
    ports: &[InputPort],
) -> impl Iterator<Item = (&'static str, &'static str, Vec<&InputPort>)> {
    let own = |port: &&InputPort| port.same_as.is_none();
    let of = move |subject: Subject| {
        ports.iter().filter(own).filter(|port| Subject::of(&port.name) == subject).collect()
    };
    let within = "the host gives these inputs no other values in this frame";
    let subjects =
        Subject::ALL.into_iter().map(move |subject| (subject.in_words(), within, of(subject)));
    let same = ports.iter().filter(|port| port.same_as.is_some()).collect();
    subjects.chain([(
        "inputs that are alike",
        "both are given the same value with every span of this frame",
        same,
    )])
}

/// What is known of these inputs; nothing if none is constant, the same as another, or narrower.
fn described(spec: &CoreSpec, group: &[&InputPort]) -> Option<String> {
    let given = || group.iter().filter_map(|port| spec.specialisation.of(&port.name));
    let count = |of: fn(&Given) -> bool| given().filter(|given| of(given)).count();
    let kinds = [
        (count(|given| *given == Given::Between([0, 0])), "always 0"),
        (
            count(|given| matches!(given, Given::Between([low, high]) if low == high && *low != 0)),
            "constant",
        ),
        (count(|given| matches!(given, Given::SameAs(_))), "same as another"),
        (count(|given| matches!(given, Given::Between([low, high]) if low != high)), "narrower"),
    ];
    let parts: Vec<String> = kinds
        .iter()
        .filter(|(number, _)| *number > 0)
        .map(|(number, kind)| format!("{number} {kind}"))
        .collect();
    (!parts.is_empty()).then(|| format!("{} of {} inputs", parts.join(", "), group.len()))
}

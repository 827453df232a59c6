//! Ablations of inputs: the core elaborated without known values or ranges of some of its inputs.
use rayon::prelude::*;
use specula_spec::{CoreSpec, Given, InputPort, InputRole};

use super::core::Ablation;
use specula_testbench::BenchError;

/// The ablations of inputs, one group at a time.
///
/// # Errors
/// [`BenchError::TooWide`] if an ablated core has a signal that is too wide.
pub fn input_ablations(spec: &CoreSpec) -> Result<Vec<Ablation>, BenchError> {
    let (ports, roles) = (spec.inputs(), spec.input_roles());
    let ablation = |(need, safe, group): (&'static str, &'static str, Vec<&InputPort>)| {
        let left_out = described(spec, &group)?;
        let known = |name: &str| !group.iter().any(|port| port.name == name);
        let core =
            CoreSpec { specialisation: spec.specialisation.restricted(known), ..spec.clone() };
        let design = specula_hdl::elaborate(&core, "core").map_err(BenchError::from);
        Some(design.map(|design| Ablation { need, left_out, safe, design }))
    };
    groups(&ports, &roles).collect::<Vec<_>>().into_par_iter().filter_map(ablation).collect()
}

/// The inputs that belong to each need. Coefficients that are equal in several channels are a need
/// of their own.
fn groups<'a>(
    ports: &'a [InputPort],
    roles: &'a [InputRole],
) -> impl Iterator<Item = (&'static str, &'static str, Vec<&'a InputPort>)> {
    let of_role = move |role: InputRole| {
        let own = |(port, of): &(&InputPort, &InputRole)| port.same_as.is_none() && **of == role;
        ports.iter().zip(roles).filter(own).map(|(port, _)| port).collect()
    };
    let within = "the host gives these inputs no other values in this frame";
    let roles =
        InputRole::ALL.into_iter().map(move |role| (role.in_words(), within, of_role(role)));
    let same = ports.iter().filter(|port| port.same_as.is_some()).collect();
    roles.chain([(
        "inputs that are alike",
        "both are given the same value with every span of this frame",
        same,
    )])
}

/// What is known of these inputs; `None` if none is constant, equal to another, or narrower.
fn described(spec: &CoreSpec, group: &[&InputPort]) -> Option<String> {
    let given = || group.iter().filter_map(|port| spec.specialisation.given(&port.name));
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

//! What a core for one scene saves, need by need: each is measured by elaborating the core without knowing it.
use rayon::prelude::*;
use serde::Serialize;
use specula_hdl::Design;
use specula_scene::CoreSpec;
use specula_scene::spec::{Given, InputPort, LONGEST_SPAN, MOST_LIGHTS, Subject};
use specula_sim::{SimError, Synthesised};

use crate::BenchError;

/// Makes cells of designs, if that is asked for: [`specula_sim::synthesise`].
pub type Synthesis<'a> = &'a dyn Fn(&[&Design]) -> Result<Vec<Synthesised>, SimError>;

/// What a hardware is spared; negative where a constant's shifts and sums are more than they stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Spared {
    /// Multipliers of two variables.
    pub multipliers: i64,
    /// Sum over multipliers of the product of their operands' widths.
    pub multiplier_bits: i64,
    /// Adders and subtractors, products with constants among them.
    pub adders: i64,
    /// Sum of their widths.
    pub adder_bits: i64,
    /// Register bits.
    pub register_bits: i64,
    /// Clocks of latency.
    pub latency: i64,
    /// Cells of an FPGA, if they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cells: Option<SparedCells>,
}

/// Cells of an ECP5 that a hardware is spared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct SparedCells {
    /// Look-up tables of four inputs.
    pub luts: i64,
    /// Multipliers of 18 x 18 bits.
    pub multipliers: i64,
    /// Flip-flops.
    pub flip_flops: i64,
}

/// A core that was built.
struct Built {
    design: Design,
    cells: Option<Synthesised>,
}

impl Built {
    /// The cores of `specs`, and with `synthesis` their cells.
    fn all(specs: &[&CoreSpec], synthesis: Option<Synthesis>) -> Result<Vec<Built>, BenchError> {
        let designs: Vec<Design> = specs.par_iter().map(|spec| specula_hdl::elaborate(spec, "core")).collect::<Result<_, _>>()?;
        let references: Vec<&Design> = designs.iter().collect();
        let cells = match synthesis {
            Some(synthesise) => synthesise(&references)?.into_iter().map(Some).collect(),
            None => vec![None; designs.len()],
        };
        Ok(designs.into_iter().zip(cells).map(|(design, cells)| Built { design, cells }).collect())
    }
}

impl Spared {
    /// What `less` has less than `more`.
    fn between(more: &Built, less: &Built) -> Spared {
        let (m, l) = (more.design.size(), less.design.size());
        let difference = |a: u64, b: u64| a as i64 - b as i64;
        let cells = |(more, less): (Synthesised, Synthesised)| SparedCells {
            luts: difference(more.luts, less.luts),
            multipliers: difference(more.multipliers, less.multipliers),
            flip_flops: difference(more.flip_flops, less.flip_flops),
        };
        Spared {
            multipliers: difference(m.multipliers as u64, l.multipliers as u64),
            multiplier_bits: difference(m.multiplier_bits, l.multiplier_bits),
            adders: difference(m.adders as u64, l.adders as u64),
            adder_bits: difference(m.adder_bits, l.adder_bits),
            register_bits: difference(m.register_bits, l.register_bits),
            latency: i64::from(more.design.latency()) - i64::from(less.design.latency()),
            cells: more.cells.zip(less.cells).map(cells),
        }
    }
}

/// A need of a scene, and what knowing it saves.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Saving {
    /// What is known of the scene.
    pub need: &'static str,
    /// What was left out or narrowed.
    pub left_out: String,
    /// What the core would have more without knowing.
    pub saves: Spared,
    /// Why nothing is lost.
    pub safe: &'static str,
}

/// A core for one scene against the general one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Savings {
    /// Need by need. They overlap, so they do not add up to the whole.
    pub needs: Vec<Saving>,
    /// Of all of them together.
    pub together: Spared,
}

/// What the core of `spec` saves against the general one, with cells if `synthesis` makes them.
///
/// # Errors
/// [`BenchError::TooWide`] if the general core has too wide a signal, [`BenchError::Simulation`] if it cannot be synthesised.
pub fn savings(spec: &CoreSpec, synthesis: Option<Synthesis>) -> Result<Savings, BenchError> {
    let needs: Vec<Ignorant> = of_sizes(spec).chain(of_inputs(spec)).collect();
    let general = spec.general();
    let specs: Vec<&CoreSpec> = [spec, &general].into_iter().chain(needs.iter().map(|need| &need.core)).collect();
    let built = Built::all(&specs, synthesis)?;
    let ([special, general], of_needs) = (&[&built[0], &built[1]], &built[2..]);
    let saving = |(without, core): (Ignorant, &Built)| Saving {
        need: without.need,
        left_out: without.left_out,
        saves: Spared::between(core, special),
        safe: without.safe,
    };
    let together = Spared::between(general, special);
    Ok(Savings { needs: needs.into_iter().zip(of_needs).map(saving).collect(), together })
}

/// The core without knowing one need.
struct Ignorant {
    need: &'static str,
    left_out: String,
    safe: &'static str,
    core: CoreSpec,
}

/// Without knowing how many lights there are, or how long spans are; where such a core can be built at all.
fn of_sizes(spec: &CoreSpec) -> impl Iterator<Item = Ignorant> {
    // Lights at places are the last ones, so more lights at infinity would have their names.
    let fewer_lights = spec.lights < MOST_LIGHTS && spec.local_lights.is_empty();
    let lights = fewer_lights.then(|| Ignorant {
        need: "number of lights",
        left_out: format!("{} of {MOST_LIGHTS} pipelines for lights", MOST_LIGHTS - spec.lights),
        safe: "the scene has no more lights",
        core: CoreSpec { lights: MOST_LIGHTS, ..spec.clone() },
    });
    let longer = (spec.longest_span < LONGEST_SPAN).then(|| spec.for_spans(LONGEST_SPAN).ok()).flatten();
    let longer = longer.filter(|core| specula_hdl::elaborate(core, "core").is_ok());
    let spans = longer.map(|core| Ignorant {
        need: "longest span",
        left_out: format!("accumulators for {} pixels, not {LONGEST_SPAN}", spec.longest_span),
        safe: "no span of this frame is longer",
        core,
    });
    lights.into_iter().chain(spans)
}

/// Without knowing what some inputs are given.
fn of_inputs(spec: &CoreSpec) -> Vec<Ignorant> {
    let ports = spec.inputs();
    let ignorant = |(need, safe, group): (&'static str, &'static str, Vec<&InputPort>)| {
        let left_out = described(spec, &group)?;
        let known = |name: &str| !group.iter().any(|port| port.name == name);
        let core = CoreSpec { specialisation: spec.specialisation.only(known), ..spec.clone() };
        Some(Ignorant { need, left_out, safe, core })
    };
    groups(&ports).filter_map(ignorant).collect()
}

/// Inputs that a need is about. Coefficients that are the same in several channels are a need of their own.
fn groups(ports: &[InputPort]) -> impl Iterator<Item = (&'static str, &'static str, Vec<&InputPort>)> {
    let own = |port: &&InputPort| port.same_as.is_none();
    let of = move |subject: Subject| ports.iter().filter(own).filter(|port| Subject::of(&port.name) == subject).collect();
    let within = "the host gives these inputs no other values in this frame";
    let subjects = Subject::ALL.into_iter().map(move |subject| (subject.in_words(), within, of(subject)));
    let same = ports.iter().filter(|port| port.same_as.is_some()).collect();
    subjects.chain([("inputs that are alike", "both are given the same value with every span of this frame", same)])
}

/// What is known of these inputs; nothing if none is constant, the same as another, or narrower.
fn described(spec: &CoreSpec, group: &[&InputPort]) -> Option<String> {
    let given = || group.iter().filter_map(|port| spec.specialisation.of(&port.name));
    let count = |of: fn(&Given) -> bool| given().filter(|given| of(given)).count();
    let kinds = [
        (count(|given| *given == Given::Between([0, 0])), "always 0"),
        (count(|given| matches!(given, Given::Between([low, high]) if low == high && *low != 0)), "constant"),
        (count(|given| matches!(given, Given::SameAs(_))), "same as another"),
        (count(|given| matches!(given, Given::Between([low, high]) if low != high)), "narrower"),
    ];
    let parts: Vec<String> =
        kinds.iter().filter(|(number, _)| *number > 0).map(|(number, kind)| format!("{number} {kind}")).collect();
    (!parts.is_empty()).then(|| format!("{} of {} inputs", parts.join(", "), group.len()))
}

//! What a core for one scene saves, need by need: each is measured by elaborating the core without that one specialisation.
use serde::Serialize;
use specula_hdl::Design;
use specula_scene::CoreSpec;
use specula_scene::spec::{Given, InputPort};

use crate::BenchError;

/// What inputs tell of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Subject {
    Light,
    Exponent,
    Ambient,
    Diffuse,
    Specular,
    Surface,
}

impl Subject {
    const ALL: [Subject; 6] =
        [Subject::Light, Subject::Exponent, Subject::Ambient, Subject::Diffuse, Subject::Specular, Subject::Surface];

    /// By an input's name, of which every method makes the same use.
    fn of(name: &str) -> Subject {
        let (stem, last) = name.rsplit_once('_').unwrap_or(("", name));
        let is_channel = matches!(last, "r" | "g" | "b");
        let constant_vector = ["_direction", "_halfway", "_axis"].iter().any(|end| stem.ends_with(end)) && !is_channel;
        let of_lights = constant_vector && matches!(last, "x" | "y" | "z");
        let scalar = ["dot_view", "halfway_gain"].iter().any(|end| name.ends_with(end));
        match name {
            _ if is_channel && stem == "ambient" => Subject::Ambient,
            _ if is_channel && stem.ends_with("_diffuse") => Subject::Diffuse,
            _ if is_channel && stem.ends_with("_specular") => Subject::Specular,
            "shininess" | "root_shininess" | "exponent" | "log2_exponent" => Subject::Exponent,
            _ if name.starts_with("light") && (of_lights || scalar || name.ends_with("_exponent")) => Subject::Light,
            _ => Subject::Surface,
        }
    }

    const fn in_words(self) -> &'static str {
        match self {
            Subject::Light => "directions of lights",
            Subject::Exponent => "exponents of materials",
            Subject::Ambient => "ambient light",
            Subject::Diffuse => "diffuse colours",
            Subject::Specular => "specular colours",
            Subject::Surface => "what changes along spans",
        }
    }
}

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
}

impl Spared {
    /// What `less` has less than `more`.
    pub fn between(more: &Design, less: &Design) -> Spared {
        let (m, l) = (more.size(), less.size());
        let difference = |a: u64, b: u64| a as i64 - b as i64;
        Spared {
            multipliers: difference(m.multipliers as u64, l.multipliers as u64),
            multiplier_bits: difference(m.multiplier_bits, l.multiplier_bits),
            adders: difference(m.adders as u64, l.adders as u64),
            adder_bits: difference(m.adder_bits, l.adder_bits),
            register_bits: difference(m.register_bits, l.register_bits),
            latency: i64::from(more.latency()) - i64::from(less.latency()),
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

/// What the core of `spec` saves against the general one.
///
/// # Errors
/// [`BenchError::TooWide`] if the general core has too wide a signal.
pub fn savings(spec: &CoreSpec) -> Result<Savings, BenchError> {
    let core = |spec: &CoreSpec| specula_hdl::elaborate(spec, "core").map_err(BenchError::from);
    let (special, general) = (core(spec)?, core(&spec.general())?);
    let ports = spec.inputs();
    let needs: Result<Vec<Option<Saving>>, BenchError> = groups(&ports)
        .map(|(need, safe, group)| {
            let Some(left_out) = described(spec, &group) else { return Ok(None) };
            let known = |name: &str| !group.iter().any(|port| port.name == name);
            let ignorant = CoreSpec { specialisation: spec.specialisation.only(known), ..spec.clone() };
            let saves = Spared::between(&core(&ignorant)?, &special);
            Ok(Some(Saving { need, left_out, saves, safe }))
        })
        .collect();
    Ok(Savings { needs: needs?.into_iter().flatten().collect(), together: Spared::between(&general, &special) })
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

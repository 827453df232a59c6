//! What a core's inputs are given over one frame: a core for that frame alone leaves out the rest.
use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use specula_scene::frame::Frame;

use super::{CoreSpec, InputPort, SetUp, SpecError};

/// What an input is given.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(
    untagged,
    expecting = "expected two raw values, smallest and largest, or an earlier input's name"
)]
pub enum Given {
    /// Raw values from the first to the second.
    Between([i64; 2]),
    /// Whatever this earlier input of the same format is given.
    SameAs(String),
}

/// What inputs are given, by their names. One that is not named may be given whatever its format
/// and its method allow; if none is, the core is general.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Specialisation(BTreeMap<String, Given>);

impl Specialisation {
    /// Whether nothing is known of any input.
    pub fn is_general(&self) -> bool {
        self.0.is_empty()
    }

    /// What it says, for people.
    pub(super) fn in_words(&self) -> String {
        if self.is_general() {
            return "any scene of that kind".to_owned();
        }
        let count = |of: fn(&Given) -> bool| self.0.values().filter(|given| of(given)).count();
        let constant = count(|given| matches!(given, Given::Between([low, high]) if low == high));
        let same = count(|given| matches!(given, Given::SameAs(_)));
        let narrower = self.0.len() - constant - same;
        format!(
            "one scene: {constant} inputs are constants, {same} are the same as others, {narrower} are narrower"
        )
    }

    /// What an input is given, if that is less than it could be.
    pub fn of(&self, name: &str) -> Option<&Given> {
        self.0.get(name)
    }

    /// What is known of some inputs alone.
    pub fn only(&self, keep: impl Fn(&str) -> bool) -> Specialisation {
        Specialisation(
            self.0
                .iter()
                .filter(|(name, _)| keep(name))
                .map(|(name, given)| (name.clone(), given.clone()))
                .collect(),
        )
    }
}

impl CoreSpec {
    /// The same core for any frame.
    pub fn general(&self) -> CoreSpec {
        CoreSpec { specialisation: Specialisation::default(), ..self.clone() }
    }

    /// The same core for this frame alone: it gives the same codes, and need not take inputs that
    /// the frame does not have.
    pub fn specialised(&self, frame: &Frame) -> CoreSpec {
        let general = self.general();
        let ports = general.inputs();
        let seen = Seen::of(&general, &ports, frame);
        let given = ports
            .iter()
            .enumerate()
            .filter_map(|(i, port)| Some((port.name.clone(), seen.given(i, &ports)?)));
        CoreSpec { specialisation: Specialisation(given.collect()), ..general }
    }

    /// As [`CoreSpec::specialised`], where another core for the frame alone is at hand, `special`.
    /// Spans are set up only if this core's inputs are not given what that one's are.
    pub fn specialised_as(&self, special: &CoreSpec, frame: &Frame) -> CoreSpec {
        let general = self.general();
        if general.is_given_what(&special.general()) {
            CoreSpec { specialisation: special.specialisation.clone(), ..general }
        } else {
            general.specialised(frame)
        }
    }

    /// Whether a host gives both cores the same raw values in every frame: set-up rests on ports
    /// and options, and not on formats of values within the core.
    fn is_given_what(&self, other: &CoreSpec) -> bool {
        self.inputs() == other.inputs()
            && self.method.with_formats_of(&other.method).as_ref() == Some(&other.method)
    }

    /// A port as it is over the frames that this core is for.
    pub(super) fn over_frames(&self, port: &InputPort) -> InputPort {
        match self.specialisation.of(&port.name) {
            None => port.clone(),
            Some(&Given::Between([low, high])) => InputPort { range: (low, high), ..port.clone() },
            Some(Given::SameAs(name)) => InputPort { same_as: Some(name.clone()), ..port.clone() },
        }
    }

    /// Whether what inputs are given is something that they can be given.
    pub(super) fn check_specialisation(&self) -> Result<(), SpecError> {
        let ports = self.general().inputs();
        let place = |name: &str| ports.iter().position(|port| port.name == *name);
        let fail = |name: &str, wrong: String| {
            Err(SpecError::Specialisation { name: name.to_owned(), wrong })
        };
        for (name, given) in &self.specialisation.0 {
            let Some(own) = place(name) else {
                return fail(name, "the core has no such input".to_owned());
            };
            match given {
                &Given::Between([low, high]) => {
                    let (lowest, highest) = ports[own].range;
                    if !(lowest <= low && low <= high && high <= highest) {
                        return fail(
                            name,
                            format!("[{low}, {high}] is no range within {lowest} to {highest}"),
                        );
                    }
                }
                Given::SameAs(other) => match place(other) {
                    Some(earlier)
                        if earlier < own && ports[earlier].format == ports[own].format => {}
                    _ => {
                        return fail(
                            name,
                            format!(
                                "`{other}` is no earlier input of the format {}",
                                ports[own].format
                            ),
                        );
                    }
                },
            }
        }
        Ok(())
    }
}

/// What the inputs of a core were given over a frame.
pub(super) struct Seen {
    /// Smallest and largest raw value of each; none in a frame without spans.
    ranges: Option<Vec<(i64, i64)>>,
    /// For each the earlier ones of its format that always had its value.
    twins: Vec<Vec<usize>>,
}

impl Seen {
    /// Sets up every span of the frame.
    pub fn of(core: &CoreSpec, ports: &[InputPort], frame: &Frame) -> Seen {
        let set_up = SetUp::new(core, frame);
        let earlier = |own: usize| {
            (0..own).filter(|&other| ports[other].format == ports[own].format).collect()
        };
        let mut seen = Seen { ranges: None, twins: (0..ports.len()).map(earlier).collect() };
        let mut inputs = Vec::with_capacity(ports.len());
        for span in &frame.spans {
            inputs.clear();
            set_up.append(span, &mut inputs);
            seen.add(&inputs);
        }
        seen
    }

    fn add(&mut self, inputs: &[i64]) {
        let ranges =
            self.ranges.get_or_insert_with(|| inputs.iter().map(|&raw| (raw, raw)).collect());
        for (range, &raw) in ranges.iter_mut().zip(inputs) {
            *range = (range.0.min(raw), range.1.max(raw));
        }
        for (twins, &raw) in self.twins.iter_mut().zip(inputs) {
            twins.retain(|&other| inputs[other] == raw);
        }
    }

    /// Smallest and largest raw value of an input; none in a frame without spans.
    pub fn range(&self, input: usize) -> Option<(i64, i64)> {
        self.ranges.as_ref().map(|ranges| ranges[input])
    }

    /// Earlier inputs that always had the value of this one.
    pub fn twins(&self, input: usize) -> &[usize] {
        &self.twins[input]
    }

    /// What an input was given, if that is less than its port takes.
    fn given(&self, input: usize, ports: &[InputPort]) -> Option<Given> {
        let range = self.range(input)?;
        // An input that never changes needs no twin.
        let twin = self.twins[input].first().filter(|_| range.0 != range.1);
        let same = twin.map(|&other| Given::SameAs(ports[other].name.clone()));
        same.or((range != ports[input].range).then_some(Given::Between([range.0, range.1])))
    }
}

//! What a core's inputs are given over the frames that it is for.
use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use specula_datapath::InputPort;

use crate::error::SpecError;
use crate::kept::Kept;

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
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Specialisation {
    given: BTreeMap<String, Given>,
    /// What stays an input whatever is known of it; of a core that was read from a file nothing,
    /// since there nothing more is left out.
    #[serde(skip)]
    kept: Kept,
}

impl Specialisation {
    /// What inputs are given, by their names.
    pub(crate) fn new(
        given: impl IntoIterator<Item = (String, Given)>,
        kept: Kept,
    ) -> Specialisation {
        Specialisation { given: given.into_iter().collect(), kept }
    }

    /// Nothing is known of any input, and some must stay one.
    pub(crate) fn keeping(kept: Kept) -> Specialisation {
        Specialisation { given: BTreeMap::new(), kept }
    }

    /// What stays an input.
    pub(crate) fn kept(&self) -> &Kept {
        &self.kept
    }

    /// The same without what is known of inputs.
    pub(crate) fn general(&self) -> Specialisation {
        Specialisation::keeping(self.kept.clone())
    }

    /// Whether nothing is known of any input.
    pub fn is_general(&self) -> bool {
        self.given.is_empty()
    }

    /// What it says, for people.
    pub(crate) fn in_words(&self) -> String {
        if self.is_general() {
            return "any scene of that kind".to_owned();
        }
        let count = |of: fn(&Given) -> bool| self.given.values().filter(|given| of(given)).count();
        let constant = count(|given| matches!(given, Given::Between([low, high]) if low == high));
        let same = count(|given| matches!(given, Given::SameAs(_)));
        let narrower = self.given.len() - constant - same;
        let words = format!(
            "one scene: {constant} inputs are constants, {same} are the same as others, {narrower} are narrower"
        );
        match &self.kept.in_words()[..] {
            [] => words,
            kept => format!("{words}; what may change: {}", kept.join("; ")),
        }
    }

    /// What an input is given, if that is less than it could be.
    pub fn given(&self, name: &str) -> Option<&Given> {
        self.given.get(name)
    }

    /// What is known of some inputs alone.
    pub fn restricted(&self, keep: impl Fn(&str) -> bool) -> Specialisation {
        let known = self.given.iter().filter(|(name, _)| keep(name));
        let given = known.map(|(name, given)| (name.clone(), given.clone()));
        Specialisation::new(given, self.kept.clone())
    }

    /// A port as it is over the frames that the core is for.
    pub(crate) fn narrowed(&self, port: &InputPort) -> InputPort {
        match self.given(&port.name) {
            None => port.clone(),
            Some(&Given::Between([low, high])) => InputPort { range: (low, high), ..port.clone() },
            Some(Given::SameAs(name)) => InputPort { same_as: Some(name.clone()), ..port.clone() },
        }
    }

    /// Whether what inputs are given is something that they can be given.
    ///
    /// # Errors
    /// [`SpecError::Specialisation`] names the first that is not.
    pub(crate) fn check(&self, ports: &[InputPort]) -> Result<(), SpecError> {
        let place = |name: &str| ports.iter().position(|port| port.name == *name);
        let fail = |name: &str, wrong: String| {
            Err(SpecError::Specialisation { name: name.to_owned(), wrong })
        };
        for (name, given) in &self.given {
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

//! Selection of the signals of a dump that are drawn.
use std::collections::{HashMap, HashSet};

use wildmatch::WildMatch;

use super::dump::Dump;
use super::error::WaveError;
use super::save_file::SaveFile;
use super::value::Notation;
use super::variables::{ScopeId, Variable};

/// The signals that a user asks for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    /// Patterns of full names; every signal that matches one of them is selected.
    pub patterns: Vec<String>,
    /// The name of a unit.
    pub unit: Option<String>,
}

/// A signal to be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chosen {
    /// Its number among the dump's variables.
    pub variable: usize,
    /// How its values are written.
    pub notation: Notation,
    /// The clock, or time, whose value matters most, if there is one.
    pub highlight: Option<u64>,
}

/// The signals to be drawn, in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChosenSignals {
    /// The signals.
    pub signals: Vec<Chosen>,
    /// The number of signals left out, if the user named none and there are too many.
    pub left_out: usize,
}

/// Largest number of signals that are drawn unless the user selects them by name.
const MAX_SIGNALS: usize = 40;
/// Number of names that an error message gives as examples.
const EXAMPLES: usize = 6;

impl Selection {
    /// Selects signals of `dump`: those that match, or without patterns and a unit those of the
    /// save file, or without one those of the outermost scope.
    ///
    /// # Errors
    /// [`WaveError`] if a pattern or the unit does not match anything.
    pub fn choose(
        &self,
        dump: &Dump,
        save_file: Option<&SaveFile>,
    ) -> Result<ChosenSignals, WaveError> {
        let saved = Saved::of(dump, save_file);
        let within = self.unit.as_ref().map(|unit| signals_of_units(dump, unit)).transpose()?;
        let (variables, left_out) = match (&self.patterns[..], within) {
            ([], None) => or_first_few(saved.visible(), || outermost(dump)),
            ([], Some(unit)) => or_first_few(saved.among(&unit.all), || unit.direct),
            (patterns, None) => {
                (matching(dump, patterns, &(0..dump.variables().len()).collect::<Vec<_>>())?, 0)
            }
            (patterns, Some(unit)) => (matching(dump, patterns, &unit.all)?, 0),
        };
        let signal = |variable| Chosen {
            variable,
            notation: saved.notation(dump, variable),
            highlight: None,
        };
        Ok(ChosenSignals { signals: variables.into_iter().map(signal).collect(), left_out })
    }
}

/// Finds signals by their full names, each with the clock, or time, whose value matters most. Names
/// that the dump does not have are left out.
pub fn by_name(
    dump: &Dump,
    save_file: Option<&SaveFile>,
    names: &[(String, u64)],
) -> ChosenSignals {
    let (saved, numbers) = (Saved::of(dump, save_file), numbers(dump));
    let there =
        names.iter().filter_map(|(name, highlight)| Some((*numbers.get(name)?, *highlight)));
    let signal = |(variable, highlight)| Chosen {
        variable,
        notation: saved.notation(dump, variable),
        highlight: Some(highlight),
    };
    ChosenSignals { signals: there.map(signal).collect(), left_out: 0 }
}

/// The variables' numbers, by full name.
fn numbers(dump: &Dump) -> HashMap<String, usize> {
    (0..dump.variables().len()).map(|index| (dump.full_name(index), index)).collect()
}

/// `chosen`, or if that is empty, the first [`MAX_SIGNALS`] of `others`, and the number of those left
/// out.
fn or_first_few(chosen: Vec<usize>, others: impl FnOnce() -> Vec<usize>) -> (Vec<usize>, usize) {
    if !chosen.is_empty() {
        return (chosen, 0);
    }
    let mut others = others();
    let left_out = others.len().saturating_sub(MAX_SIGNALS);
    others.truncate(MAX_SIGNALS);
    (others, left_out)
}

/// The signals of the outermost scope that has any; only its ports, if the file says which those
/// are.
fn outermost(dump: &Dump) -> Vec<usize> {
    let depth = |variable: &Variable| dump.scopes().depth(variable.scope);
    let Some(first) = dump.variables().iter().min_by_key(|variable| depth(variable)) else {
        return vec![];
    };
    let here = |wanted: &dyn Fn(&Variable) -> bool| {
        numbers_of(dump, &|variable| variable.scope == first.scope && wanted(variable))
    };
    let ports = here(&|variable| variable.port);
    if ports.is_empty() { here(&|_| true) } else { ports }
}

/// The numbers of the variables for which `wanted` holds.
fn numbers_of(dump: &Dump, wanted: &dyn Fn(&Variable) -> bool) -> Vec<usize> {
    dump.variables()
        .iter()
        .enumerate()
        .filter(|(_, variable)| wanted(variable))
        .map(|(index, _)| index)
        .collect()
}

/// The signals in the units of one name.
struct UnitSignals {
    /// The signals that belong to the units themselves.
    direct: Vec<usize>,
    /// These signals and those of units inside of them.
    all: Vec<usize>,
}

/// The signals of the units with that name, or of the one with that full name.
fn signals_of_units(dump: &Dump, unit: &str) -> Result<UnitSignals, WaveError> {
    let scopes = dump.scopes();
    let meant = |scope: ScopeId| {
        scopes.name(scope) == unit || (unit.contains('.') && scopes.path(scope) == unit)
    };
    let all = numbers_of(dump, &|variable| scopes.ancestors(variable.scope).any(meant));
    if all.is_empty() {
        let names = distinct(scopes.names().map(str::to_owned));
        let (near, there) = (suggestion(unit, &names), examples(&names));
        return Err(WaveError::Unit { unit: unit.to_owned(), near, there });
    }
    let direct =
        numbers_of(dump, &|variable| scopes.ancestors(variable.scope).next().is_some_and(meant));
    Ok(UnitSignals { direct, all })
}

/// The variables of `among` that match a pattern, in the file's order.
fn matching(dump: &Dump, patterns: &[String], among: &[usize]) -> Result<Vec<usize>, WaveError> {
    let names: Vec<String> = among.iter().map(|&index| dump.full_name(index)).collect();
    let mut wanted = vec![false; names.len()];
    for pattern in patterns {
        let glob = WildMatch::new(pattern);
        let spelt = |(&index, name): (&usize, &String)| {
            spellings(&dump.variables()[index], name).iter().any(|name| glob.matches(name))
        };
        let matches: Vec<bool> = among.iter().zip(&names).map(spelt).collect();
        if !matches.contains(&true) {
            let (near, there) = (suggestion(pattern, &names), examples(&names));
            return Err(WaveError::Signals { pattern: pattern.clone(), near, there });
        }
        wanted.iter_mut().zip(matches).for_each(|(wanted, matches)| *wanted |= matches);
    }
    Ok(among.iter().zip(wanted).filter(|(_, wanted)| *wanted).map(|(&index, _)| index).collect())
}

/// The spellings by which a signal may be selected: with its range, as files and GTKWave write it,
/// and without the backslash of an escaped name.
fn spellings(variable: &Variable, name: &str) -> Vec<String> {
    let mut spellings = vec![name.to_owned()];
    if let Some(range) = variable.range.as_ref().filter(|range| !name.ends_with(range.as_str())) {
        spellings.extend([format!("{name}{range}"), format!("{name} {range}")]);
    }
    if name.contains('\\') {
        let plain: Vec<String> = spellings.iter().map(|name| name.replace('\\', "")).collect();
        spellings.extend(plain);
    }
    spellings
}

/// The first few of many names, as text.
fn examples(names: &[String]) -> String {
    let mut shown: Vec<String> =
        names.iter().take(EXAMPLES).map(|name| format!("`{name}`")).collect();
    if names.len() > EXAMPLES {
        shown.push(format!("and {} more", names.len() - EXAMPLES));
    }
    shown.join(", ")
}

/// The name that is most similar to `asked`, as a question; empty if none is similar.
fn suggestion(asked: &str, names: &[String]) -> String {
    let likeness = |name: &String| {
        let last = name.rsplit('.').next().unwrap_or(name);
        let whole =
            strsim::normalized_damerau_levenshtein(&asked.to_lowercase(), &name.to_lowercase());
        // A user who leaves out the scopes still means the signal.
        whole.max(if last.eq_ignore_ascii_case(asked) { 1.0 } else { 0.0 })
    };
    let short = names.iter().filter(|name| name.len() <= LONGEST_COMPARED).take(MAX_COMPARED);
    let likely =
        short.map(|name| (likeness(name), name)).filter(|(likeness, _)| *likeness >= LIKELY);
    let best = likely.min_by(|(one, _), (other, _)| other.total_cmp(one));
    best.map_or(String::new(), |(_, name)| format!("did you mean `{name}`? "))
}

/// How similar, from 0 to 1, a name must be to be suggested.
const LIKELY: f64 = 0.7;
/// Largest number of names that are compared, and of characters of each: the time grows with their
/// product.
const MAX_COMPARED: usize = 100_000;
const LONGEST_COMPARED: usize = 200;

fn distinct(names: impl Iterator<Item = String>) -> Vec<String> {
    let mut seen = HashSet::new();
    names.filter(|name| seen.insert(name.clone())).collect()
}

/// What the save file says, by the dump's variables.
struct Saved {
    /// Variables in the order of the save file, and whether each is visible.
    order: Vec<(usize, bool)>,
    notations: HashMap<usize, Notation>,
}

impl Saved {
    fn of(dump: &Dump, save_file: Option<&SaveFile>) -> Saved {
        let signals = save_file.map_or(&[][..], |save_file| &save_file.signals);
        // The map of all names is built only if there is something to look up.
        let numbers = if signals.is_empty() { HashMap::new() } else { numbers(dump) };
        let mut saved = Saved { order: vec![], notations: HashMap::new() };
        for signal in signals {
            let Some(&index) = numbers.get(&signal.name) else { continue };
            // A save file may show a signal twice; it is drawn once.
            if !saved.notations.contains_key(&index) {
                saved.order.push((index, signal.visible));
                saved.notations.insert(index, signal.notation);
            }
        }
        saved
    }

    fn visible(&self) -> Vec<usize> {
        self.order.iter().filter(|(_, visible)| *visible).map(|&(index, _)| index).collect()
    }

    fn among(&self, variables: &[usize]) -> Vec<usize> {
        let variables: HashSet<&usize> = variables.iter().collect();
        self.order
            .iter()
            .map(|&(index, _)| index)
            .filter(|index| variables.contains(index))
            .collect()
    }

    fn notation(&self, dump: &Dump, variable: usize) -> Notation {
        let known = self.notations.get(&variable).copied();
        known.unwrap_or(if dump.variables()[variable].width == Some(1) {
            Notation::Binary
        } else {
            Notation::Hexadecimal
        })
    }
}

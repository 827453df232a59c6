//! Which signals of a dump are drawn.
use std::collections::{HashMap, HashSet};

use wildmatch::WildMatch;

use super::dump::Dump;
use super::error::WaveError;
use super::save_file::SaveFile;
use super::value::Notation;
use super::variables::Variable;

/// What somebody wants to see.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    /// Patterns of full names; every signal that matches one.
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
    /// The clock, or time, whose value matters most, if one does.
    pub highlight: Option<u64>,
}

/// The signals to be drawn, in order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Those.
    pub signals: Vec<Chosen>,
    /// How many more there were where nobody named them, and they were too many.
    pub left_out: usize,
}

/// Signals that are drawn where nobody chose them by name.
const MOST: usize = 40;
/// Names that an error message gives as examples.
const EXAMPLES: usize = 6;

impl Selection {
    /// The signals of `dump` that are meant; without patterns and a unit those of the save file, and without one the outermost.
    ///
    /// # Errors
    /// [`WaveError`] if a pattern or the unit does not match anything.
    pub fn choose(&self, dump: &Dump, save_file: Option<&SaveFile>) -> Result<Choice, WaveError> {
        let saved = Saved::of(dump, save_file);
        let within = self.unit.as_ref().map(|unit| inside(dump, unit)).transpose()?;
        let (variables, left_out) = match (&self.patterns[..], within) {
            ([], None) => or_first_few(saved.visible(), || outermost(dump)),
            ([], Some(unit)) => or_first_few(saved.among(&unit.all), || unit.direct),
            (patterns, None) => (matching(dump, patterns, &(0..dump.variables.len()).collect::<Vec<_>>())?, 0),
            (patterns, Some(unit)) => (matching(dump, patterns, &unit.all)?, 0),
        };
        let signal = |variable| Chosen { variable, notation: saved.notation(dump, variable), highlight: None };
        Ok(Choice { signals: variables.into_iter().map(signal).collect(), left_out })
    }
}

/// Signals by their full names, each with the clock, or time, whose value matters most; those that the dump does not hold are left out.
pub fn named(dump: &Dump, save_file: Option<&SaveFile>, names: &[(String, u64)]) -> Choice {
    let (saved, numbers) = (Saved::of(dump, save_file), numbers(dump));
    let there = names.iter().filter_map(|(name, highlight)| Some((*numbers.get(name)?, *highlight)));
    let signal = |(variable, highlight)| Chosen { variable, notation: saved.notation(dump, variable), highlight: Some(highlight) };
    Choice { signals: there.map(signal).collect(), left_out: 0 }
}

/// The number of each full name.
fn numbers(dump: &Dump) -> HashMap<String, usize> {
    dump.variables.iter().enumerate().map(|(index, variable)| (variable.full_name(), index)).collect()
}

/// `chosen`, or if that is nothing, the first of `others`, and how many more of them there are.
fn or_first_few(chosen: Vec<usize>, others: impl FnOnce() -> Vec<usize>) -> (Vec<usize>, usize) {
    if !chosen.is_empty() {
        return (chosen, 0);
    }
    let mut others = others();
    let left_out = others.len().saturating_sub(MOST);
    others.truncate(MOST);
    (others, left_out)
}

/// The signals of the outermost scope that has any; of its ports alone if the file says which are.
fn outermost(dump: &Dump) -> Vec<usize> {
    let depth = dump.variables.iter().map(|variable| variable.scopes.len()).min();
    let Some(first) = dump.variables.iter().find(|variable| Some(variable.scopes.len()) == depth) else { return vec![] };
    let here = |wanted: &dyn Fn(&Variable) -> bool| -> Vec<usize> {
        let numbered = dump.variables.iter().enumerate();
        numbered.filter(|(_, variable)| variable.scopes == first.scopes && wanted(variable)).map(|(index, _)| index).collect()
    };
    let ports = here(&|variable| variable.port);
    if ports.is_empty() { here(&|_| true) } else { ports }
}

/// The signals of units with a name.
struct Inside {
    /// Those of the units themselves.
    direct: Vec<usize>,
    /// Those, and those of units inside them.
    all: Vec<usize>,
}

fn inside(dump: &Dump, unit: &str) -> Result<Inside, WaveError> {
    let numbers = |wanted: &dyn Fn(&Variable) -> bool| -> Vec<usize> {
        dump.variables.iter().enumerate().filter(|(_, variable)| wanted(variable)).map(|(index, _)| index).collect()
    };
    let all = numbers(&|variable| variable.scopes.iter().any(|scope| scope == unit));
    if all.is_empty() {
        let names = distinct(dump.variables.iter().flat_map(|variable| &variable.scopes).cloned());
        return Err(WaveError::Unit { unit: unit.to_owned(), there: examples(&names) });
    }
    Ok(Inside { direct: numbers(&|variable| variable.scopes.last().is_some_and(|scope| scope == unit)), all })
}

/// Those of `among` that match a pattern, in the file's order.
fn matching(dump: &Dump, patterns: &[String], among: &[usize]) -> Result<Vec<usize>, WaveError> {
    let names: Vec<String> = among.iter().map(|&index| dump.variables[index].full_name()).collect();
    let mut wanted = vec![false; names.len()];
    for pattern in patterns {
        let glob = WildMatch::new(pattern);
        let matches: Vec<bool> = names.iter().map(|name| glob.matches(name)).collect();
        if !matches.contains(&true) {
            return Err(WaveError::Signals { pattern: pattern.clone(), there: examples(&names) });
        }
        wanted.iter_mut().zip(matches).for_each(|(wanted, matches)| *wanted |= matches);
    }
    Ok(among.iter().zip(wanted).filter(|(_, wanted)| *wanted).map(|(&index, _)| index).collect())
}

/// The first names of many, in words.
fn examples(names: &[String]) -> String {
    let mut shown: Vec<String> = names.iter().take(EXAMPLES).map(|name| format!("`{name}`")).collect();
    if names.len() > EXAMPLES {
        shown.push(format!("and {} more", names.len() - EXAMPLES));
    }
    shown.join(", ")
}

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
        let numbers = numbers(dump);
        let mut saved = Saved { order: vec![], notations: HashMap::new() };
        for signal in signals {
            let Some(&index) = numbers.get(&signal.name) else { continue };
            // A signal may be shown twice, and is drawn once.
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
        self.order.iter().map(|&(index, _)| index).filter(|index| variables.contains(index)).collect()
    }

    fn notation(&self, dump: &Dump, variable: usize) -> Notation {
        let known = self.notations.get(&variable).copied();
        known.unwrap_or(if dump.variables[variable].width == Some(1) { Notation::Binary } else { Notation::Hexadecimal })
    }
}

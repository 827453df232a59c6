//! Checks of single values, with errors that point at them.
use std::ops::RangeInclusive;

use glam::DVec3;
use toml::Spanned;

use super::SourceFile;
use super::values::{Integer, Number, Triple, Vector};
use crate::{Colour, SceneError};

/// Numbers farther from 0 than this are refused, so that products of them stay finite.
const FARTHEST: f64 = 1e30;

/// A colour whose components are all in `range`; `default` if there is none.
pub(super) fn colour(
    source: &SourceFile,
    name: &str,
    given: Option<&Spanned<Triple>>,
    range: RangeInclusive<f64>,
    default: Colour,
) -> Result<Colour, SceneError> {
    Ok(given_colour(source, name, given, range)?.unwrap_or(default))
}

/// A colour whose components are all in `range`, if there is one.
pub(super) fn given_colour(
    source: &SourceFile,
    name: &str,
    given: Option<&Spanned<Triple>>,
    range: RangeInclusive<f64>,
) -> Result<Option<Colour>, SceneError> {
    let Some(given) = given else { return Ok(None) };
    let colour = given.get_ref().0;
    match colour.iter().find(|c| !range.contains(c)) {
        None => Ok(Some(colour)),
        Some(component) => {
            let help = format!(
                "components of `{name}` are {} to {}; 1 is full scale of the picture",
                range.start(),
                range.end()
            );
            Err(source.error(
                given.span(),
                format!("the component {component:?} of `{name}` is out of range"),
                help,
            ))
        }
    }
}

/// A number that is finite and not larger than [`FARTHEST`].
pub(super) fn number(
    source: &SourceFile,
    name: &str,
    given: &Spanned<Number>,
) -> Result<f64, SceneError> {
    within(source, name, given.span(), [given.get_ref().0; 3]).map(|[number, ..]| number)
}

/// Such a number that is 0 or more.
pub(super) fn nonnegative(
    source: &SourceFile,
    name: &str,
    given: &Spanned<Number>,
) -> Result<f64, SceneError> {
    match number(source, name, given)? {
        number if number >= 0.0 => Ok(number),
        number => {
            let help = format!("`{name}` is 0 or more");
            Err(source.error(given.span(), format!("`{name}` = {number:?} is below 0"), help))
        }
    }
}

/// A vector of such numbers.
pub(super) fn vector(
    source: &SourceFile,
    name: &str,
    given: &Spanned<Vector>,
) -> Result<DVec3, SceneError> {
    within(source, name, given.span(), given.get_ref().0).map(DVec3::from_array)
}

/// A vector that is not 0.
pub(super) fn direction(
    source: &SourceFile,
    name: &str,
    given: &Spanned<Vector>,
) -> Result<DVec3, SceneError> {
    match vector(source, name, given)? {
        DVec3::ZERO => {
            let help = "give a vector of any length above 0, as in [0, 1, 0]";
            Err(source.error(given.span(), format!("`{name}` is 0 and points nowhere"), help))
        }
        direction => Ok(direction),
    }
}

/// Scale factors; none may be 0.
pub(super) fn scale(source: &SourceFile, given: &Spanned<Triple>) -> Result<DVec3, SceneError> {
    let factors = within(source, "scale", given.span(), given.get_ref().0)?;
    if factors.iter().any(|f| f.abs() < 1.0 / FARTHEST) {
        Err(source.error(
            given.span(),
            "`scale` squashes the object flat",
            "scale factors are not 0",
        ))
    } else {
        Ok(DVec3::from_array(factors))
    }
}

fn within(
    source: &SourceFile,
    name: &str,
    at: std::ops::Range<usize>,
    numbers: [f64; 3],
) -> Result<[f64; 3], SceneError> {
    match numbers.iter().find(|x| x.is_nan() || x.abs() > FARTHEST) {
        None => Ok(numbers),
        Some(x) => {
            let help = format!("numbers are finite, from -{FARTHEST:e} to {FARTHEST:e}");
            Err(source.error(at, format!("`{name}` is {x:?}"), help))
        }
    }
}

/// An integer in `range`.
pub(super) fn integer(
    source: &SourceFile,
    name: &str,
    given: &Spanned<Integer>,
    range: RangeInclusive<u32>,
) -> Result<u32, SceneError> {
    match u32::try_from(given.get_ref().0) {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => {
            let help = format!("`{name}` is an integer from {} to {}", range.start(), range.end());
            Err(source.error(
                given.span(),
                format!("`{name}` = {} is out of range", given.get_ref().0),
                help,
            ))
        }
    }
}

/// One of a few words; the first one is the default.
pub(super) fn word<T: Copy>(
    source: &SourceFile,
    name: &str,
    given: Option<&Spanned<String>>,
    words: &[(&str, T)],
) -> Result<Option<T>, SceneError> {
    let Some(given) = given else { return Ok(None) };
    match words.iter().find(|(word, _)| word == given.get_ref()) {
        Some((_, meaning)) => Ok(Some(*meaning)),
        None => {
            let known: Vec<String> = words.iter().map(|(word, _)| format!("\"{word}\"")).collect();
            let help = format!("`{name}` is {}", known.join(" or "));
            Err(source.error(
                given.span(),
                format!("there is no {name} \"{}\"", given.get_ref()),
                help,
            ))
        }
    }
}

/// Checks a kind that the format could have several of, but of which only one exists so far.
pub(super) fn only_kind(
    source: &SourceFile,
    given: Option<&Spanned<String>>,
    made: &str,
    planned: &[&str],
) -> Result<(), SceneError> {
    match given {
        Some(kind) if kind.get_ref() != made => {
            let help = format!("`kind` is \"{made}\", or left out");
            let problem = if planned.contains(&kind.get_ref().as_str()) {
                format!("the kind \"{}\" is not made yet", kind.get_ref())
            } else {
                format!("there is no kind \"{}\"", kind.get_ref())
            };
            Err(source.error(kind.span(), problem, help))
        }
        _ => Ok(()),
    }
}

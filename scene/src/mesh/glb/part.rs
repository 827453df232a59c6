//! Parts of the JSON without which a file can be drawn: they are read when they are used, so that
//! what is wrong in them does not cost the rest.
use serde::de::{DeserializeOwned, Deserializer};
use serde::{Deserialize, de};
use serde_json::value::RawValue;

use super::json::Whole;

/// A part of the JSON that has not been read yet.
#[derive(Debug, Default)]
pub struct Part(Option<Box<RawValue>>);

impl Part {
    /// What it holds; `None` if it is absent or `null`.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    pub fn read<T: DeserializeOwned>(&self) -> Result<Option<T>, String> {
        let Some(text) = &self.0 else { return Ok(None) };
        serde_json::from_str(text.get()).map_err(|error| {
            let error = error.to_string();
            // The place within the part says nothing about the place in the file.
            error.split(" at line ").next().unwrap_or_default().to_owned()
        })
    }
}

impl<'de> Deserialize<'de> for Part {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Part, D::Error> {
        Box::deserialize(deserializer).map(|text| Part(Some(text)))
    }
}

/// The number of something, if there is one: whatever is no whole number counts as none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reference(pub Option<usize>);

impl<'de> Deserialize<'de> for Reference {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Reference, D::Error> {
        let part = Part::deserialize(deserializer).map_err(de::Error::custom)?;
        Ok(Reference(part.read().ok().flatten().map(|Whole(number)| number)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_in_a_part_is_told_when_it_is_read() {
        let parts: Vec<Part> =
            serde_json::from_str(r#"[null, 3, {"a": [1]}]"#).expect("it is JSON");
        let read = |k: usize| parts[k].read::<Whole>();
        assert_eq!((read(0), read(1)), (Ok(None), Ok(Some(Whole(3)))));
        let said = "invalid type: map, expected a whole number from 0 on";
        assert_eq!(read(2), Err(said.to_owned()));
    }

    #[test]
    fn references_that_are_no_numbers_are_none() {
        let all: Vec<Reference> =
            serde_json::from_str(r#"[null, 3.0, -1, "x", {}]"#).expect("it is JSON");
        let numbers: Vec<Option<usize>> = all.into_iter().map(|Reference(number)| number).collect();
        assert_eq!(numbers, [None, Some(3), None, None, None]);
    }
}

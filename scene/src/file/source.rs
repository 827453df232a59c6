//! The text of a scene file, and errors that point into it.
use std::ops::Range;
use std::sync::Arc;

use miette::NamedSource;
use serde::de::DeserializeOwned;

use crate::SceneError;

/// A scene file's name and text, cheap to share.
#[derive(Clone, Debug)]
pub(crate) struct SourceFile(Arc<NamedSource<String>>);

impl SourceFile {
    pub fn new(name: &str, text: String) -> SourceFile {
        SourceFile(Arc::new(NamedSource::new(name, text)))
    }

    pub fn text(&self) -> &str {
        self.0.inner()
    }

    /// Reads the whole text as TOML of a type. `help` is what would be right where it is none.
    pub fn parse<T: DeserializeOwned>(&self, help: &str) -> Result<T, SceneError> {
        toml::from_str(self.text()).map_err(|error| self.toml_error(&error, help))
    }

    /// An error at a range of bytes of the text.
    pub fn error(
        &self,
        at: Range<usize>,
        problem: impl Into<String>,
        help: impl Into<String>,
    ) -> SceneError {
        SceneError::File {
            problem: problem.into(),
            help: help.into(),
            text: self.0.clone(),
            at: at.into(),
        }
    }

    fn toml_error(&self, error: &toml::de::Error, help: &str) -> SceneError {
        let at = error.span().unwrap_or(0..0);
        self.error(at, in_toml_words(error.message()), help)
    }
}

/// serde's words in those of TOML, on one line.
fn in_toml_words(message: &str) -> String {
    let words = [
        ("field", "key"),
        ("a map", "a table"),
        ("a sequence", "an array"),
        ("floating point", "number"),
        ("\n", "; "),
    ];
    words.iter().fold(message.trim().to_owned(), |text, (serde, toml)| text.replace(serde, toml))
}

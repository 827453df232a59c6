//! The text of a file that is TOML, and errors that point into it.
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use miette::NamedSource;
use serde::de::DeserializeOwned;

use crate::{SceneError, mesh};

/// The name and the text of a scene file or a core's, cheap to share.
#[derive(Clone, Debug)]
pub struct SourceFile(Arc<NamedSource<String>>);

impl SourceFile {
    /// A text; `name` is the file's in errors.
    pub fn new(name: &str, text: String) -> SourceFile {
        SourceFile(Arc::new(NamedSource::new(name, text)))
    }

    /// Reads a file that is to be of a `kind`, as errors name it.
    ///
    /// # Errors
    /// [`SceneError::Unreadable`] if the system does not give the file, or it is not text.
    pub fn read(kind: &'static str, path: &Path) -> Result<SourceFile, SceneError> {
        let shown = path.display().to_string();
        let unreadable = |reason: String, help: &str| SceneError::Unreadable {
            kind,
            path: shown.clone(),
            reason,
            help: help.into(),
        };
        let bytes = mesh::read_file(path)
            .map_err(|problem| unreadable(problem.to_string(), "check the path"))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let at = error.utf8_error().valid_up_to();
            let line = error.as_bytes()[..at].iter().filter(|byte| **byte == b'\n').count() + 1;
            unreadable(
                format!("it is not UTF-8 text: byte {at}, in line {line}, is wrong"),
                "scenes and specs are TOML, in UTF-8",
            )
        })?;
        Ok(SourceFile::new(&shown, text))
    }

    /// The text.
    pub fn text(&self) -> &str {
        self.0.inner()
    }

    /// Reads the whole text as TOML of a type. `help` is what would be right where it is none.
    ///
    /// # Errors
    /// A [`SceneError`] that points at what is wrong.
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

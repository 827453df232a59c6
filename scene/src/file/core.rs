//! The `[core]` table of a scene file, which says what hardware to build. Its contents are not
//! looked at here.
use std::ops::Range;

use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::SourceFile;
use crate::SceneError;

/// A scene file's `[core]` table and its place.
#[derive(Clone, Debug)]
pub struct CoreTable {
    source: SourceFile,
    span: Range<usize>,
}

/// A scene file, as far as the core is concerned.
#[derive(Deserialize)]
struct OnlyCore<T> {
    core: T,
}

impl CoreTable {
    pub(super) fn new(source: SourceFile, span: Range<usize>) -> CoreTable {
        CoreTable { source, span }
    }

    /// Bytes of the scene file's text that the table takes.
    pub fn span(&self) -> Range<usize> {
        self.span.clone()
    }

    /// Reads the table as a type.
    ///
    /// `toml::Spanned` fields of the type get ranges of the scene file's text, which
    /// [`CoreTable::error`] takes.
    ///
    /// # Errors
    /// A [`SceneError`] that points at the wrong place in the scene file.
    pub fn parse<T: DeserializeOwned>(&self) -> Result<T, SceneError> {
        self.source.parse::<OnlyCore<T>>(super::KEYS).map(|file| file.core)
    }

    /// An error at a range of bytes of the scene file's text.
    pub fn error(
        &self,
        at: Range<usize>,
        problem: impl Into<String>,
        help: impl Into<String>,
    ) -> SceneError {
        self.source.error(at, problem, help)
    }
}

//! A page of text with its pictures, printed and written.
use std::io::Write;
use std::path::{Path, PathBuf};

use specula_scene::regular::read_regular;

use super::section;
use crate::error::ToolError;
use crate::output::{Interrupts, OutputError, write_file};

/// Largest file, in bytes, that may be a text of this command's.
const LONGEST_TEXT: u64 = 16 << 20;

/// A page.
pub struct Page<'a> {
    /// The name of its file.
    pub name: &'static str,
    /// How its text begins, by which a later run recognises it.
    pub head: &'static str,
    /// Its text.
    pub text: String,
    /// The pictures that it shows.
    pub pictures: Vec<&'a section::File>,
}

impl Page<'_> {
    /// Writes the page into `folder`, if there is one, and prints it.
    pub fn give(
        &self,
        folder: Option<&Path>,
        stdout: &mut dyn Write,
        interrupts: &Interrupts,
    ) -> Result<(), ToolError> {
        if let Some(folder) = folder {
            self.write(folder, interrupts)?;
        }
        write!(stdout, "{}", self.text).and_then(|()| stdout.flush()).map_err(ToolError::Print)
    }

    fn write(&self, folder: &Path, interrupts: &Interrupts) -> Result<(), ToolError> {
        let place = |file: &section::File| Path::new(section::IMAGES).join(&file.name);
        let files = self.pictures.iter().map(|file| place(file));
        self.refuse_foreign(folder, files.chain([PathBuf::from(self.name)]))?;
        // The text is written last, so that it shows no picture that is missing.
        for file in &self.pictures {
            write_file(&folder.join(place(file)), interrupts, |path| file.write(path))?;
        }
        Ok(write_file(&folder.join(self.name), interrupts, |path| {
            std::fs::write(path, &self.text)
        })?)
    }

    /// Refuses to replace files of these names unless a text that this command wrote is there too.
    fn refuse_foreign(
        &self,
        folder: &Path,
        mut names: impl Iterator<Item = PathBuf>,
    ) -> Result<(), OutputError> {
        let earlier = read_regular(&folder.join(self.name), LONGEST_TEXT);
        if earlier.is_ok_and(|text| text.starts_with(self.head.as_bytes())) {
            return Ok(());
        }
        match names.find(|name| folder.join(name).symlink_metadata().is_ok()) {
            Some(name) => Err(OutputError::InTheWay {
                folder: folder.to_owned(),
                name: name.display().to_string(),
            }),
            None => Ok(()),
        }
    }
}

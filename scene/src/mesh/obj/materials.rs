//! The materials that an `.obj` file names, and the libraries that hold them.
use std::collections::BTreeMap;
use std::path::Path;

use super::{mtl, name};
use crate::PartialMaterial;
use crate::mesh::lines::words;
use crate::mesh::warning::{Notices, quoted};
use crate::mesh::{Beside, MeshProblem, Warning};

/// The number of faces' material before any is named.
pub const NONE: u32 = 0;

/// What a file says about materials: `mtllib` and `usemtl`.
#[derive(Debug, Default)]
pub struct Materials {
    /// The lines of libraries, with their numbers.
    libraries: Vec<(usize, Vec<u8>)>,
    /// The number of each name, counted from 1.
    numbers: BTreeMap<Vec<u8>, u32>,
    /// Each name with the line that states it first, in the order of their numbers.
    names: Vec<(usize, Vec<u8>)>,
}

impl Materials {
    /// Adds the libraries that a line states: what follows its keyword.
    pub fn library(&mut self, line: usize, files: &[u8]) {
        if !self.libraries.iter().any(|(_, known)| known == files) {
            self.libraries.push((line, files.to_vec()));
        }
    }

    /// The number of the material that a line states by its name: [`NONE`] for an empty one.
    pub fn number(&mut self, line: usize, name: &[u8]) -> u32 {
        if name.is_empty() {
            return NONE;
        }
        if let Some(&number) = self.numbers.get(name) {
            return number;
        }
        self.names.push((line, name.to_vec()));
        // A file of 2^30 bytes has fewer lines than 2^32.
        let number = self.names.len() as u32;
        self.numbers.insert(name.to_vec(), number);
        number
    }

    /// The material of each number: an open one for [`NONE`], and for a name that no library has.
    /// Empty if no material is named; libraries are then not opened.
    pub fn found(self, beside: &Beside<'_>, notices: &mut Notices) -> Vec<PartialMaterial> {
        if self.names.is_empty() {
            return Vec::new();
        }
        let mut known = BTreeMap::new();
        let mut all_read = true;
        for (line, files) in &self.libraries {
            all_read &= read_line(*line, files, beside, notices, &mut known);
        }
        let named = self.names.iter().map(|(line, name)| {
            let material = known.get(name).cloned();
            if material.is_none() && all_read {
                notices.add("material", Some(*line), || {
                    format!(
                        "no material library has {}; its faces have the default material",
                        quoted(name)
                    )
                });
            }
            material.unwrap_or_default()
        });
        std::iter::once(PartialMaterial::default()).chain(named).collect()
    }
}

/// Reads the libraries of a line, of which the first that has a name counts; whether all could be
/// read.
///
/// A line may state several files, and a file's name may contain blanks.
fn read_line(
    line: usize,
    files: &[u8],
    beside: &Beside<'_>,
    notices: &mut Notices,
    known: &mut BTreeMap<Vec<u8>, PartialMaterial>,
) -> bool {
    let all = match library(files, beside) {
        Ok(read) => vec![(files, Ok(read))],
        Err(problem) if words(files).count() < 2 => vec![(files, Err(problem))],
        Err(_) => words(files).map(|file| (file, library(file, beside))).collect(),
    };
    let mut all_read = true;
    for (file, read) in all {
        match read {
            Ok((materials, warnings)) => {
                for (name, material) in materials {
                    known.entry(name).or_insert(material);
                }
                notices.append(warnings);
            }
            Err(problem) => {
                all_read = false;
                notices.add("library", Some(line), || {
                    format!(
                        "the material library {}: {problem}; its materials are the default",
                        quoted(file)
                    )
                });
            }
        }
    }
    all_read
}

type Library = (Vec<(Vec<u8>, PartialMaterial)>, Vec<Warning>);

/// The materials of a library, and what was skipped in it.
fn library(file: &[u8], beside: &Beside<'_>) -> Result<Library, MeshProblem> {
    // Programs on other systems separate folders by backslashes.
    let file = String::from_utf8_lossy(name(file)).replace('\\', "/");
    let other = beside(Path::new(&file))?;
    let mut notices = Notices::default();
    let materials = mtl::parse(&other.bytes, &mut notices);
    Ok((materials, notices.into_warnings(&other.path)))
}

//! The journal of a sweep: results are written as they come, a line of JSON each, and found again
//! by spec.
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::{self, Write as _};
use std::fs::{File, OpenOptions};
use std::hash::{DefaultHasher, Hasher};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use miette::Diagnostic;
use serde::{Deserialize, Serialize};
use specula_scene::LoadedScene;
use specula_scene::regular::read_regular;
use specula_spec::CoreSpec;
use thiserror::Error;

use super::Measured;

/// Largest file of results that is read, in bytes; a result takes some thousand.
pub const LONGEST_FILE: u64 = 64 << 20;

/// The known results, and the file that contains them.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    scene: SceneKey,
    open: Mutex<Open>,
}

#[derive(Debug)]
struct Open {
    /// The file, open for appending.
    file: File,
    /// The results, by their keys as JSON.
    results: BTreeMap<String, Measured>,
}

/// A line that is not a result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Damaged {
    /// Its number, from 1.
    pub line: usize,
    /// What is wrong with it.
    pub reason: String,
}

/// The reason why results cannot be kept.
#[derive(Debug, Error, Diagnostic)]
#[error("results cannot be kept in `{}`: {reason}", path.display())]
#[diagnostic(
    code(specula::compare::journal),
    help("check the folder's permissions and the room on the disk, or name another with `-o`")
)]
pub struct JournalError {
    path: PathBuf,
    reason: io::Error,
}

/// The part of a result's key that does not concern the core.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SceneKey {
    /// Version of Specula.
    version: String,
    /// A hash of everything that is shaded.
    scene: String,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct Key {
    #[serde(flatten)]
    scene: SceneKey,
    spec: serde_json::Value,
}

#[derive(Debug, Serialize, Deserialize)]
struct Line {
    key: Key,
    measured: Measured,
}

/// The beginning of every line.
const LINE: &[u8] = b"{\"key\":{\"version\":";

impl Journal {
    /// Whether a file is a journal, judged by its bytes: a journal that was just begun is empty; in
    /// any other, a line is a result or a part of one.
    pub fn has_written(bytes: &[u8]) -> bool {
        let is_result =
            |line: &[u8]| !line.is_empty() && line.iter().zip(LINE).all(|(a, b)| a == b);
        bytes.is_empty() || bytes.split(|&byte| byte == b'\n').any(is_result)
    }

    /// The beginning of the name of the file that is written next to the journal `name` before it
    /// replaces it. An interruption may leave it; it contains nothing that the journal does not.
    pub fn replacement_prefix(name: &str) -> String {
        format!(".{name}-")
    }

    /// Opens the file, or creates it. Damaged lines are removed from it and returned; their results
    /// are measured again.
    ///
    /// # Errors
    /// [`JournalError`] if the file cannot be read or written.
    pub fn open(path: &Path, scene: &LoadedScene) -> Result<(Journal, Vec<Damaged>), JournalError> {
        let begin = || {
            let (results, damaged) = read(path)?;
            if !damaged.is_empty() {
                rewrite(path, &results)?;
            }
            let file = OpenOptions::new().create(true).append(true).open(path)?;
            let open = Mutex::new(Open { file, results });
            Ok((Journal { path: path.to_owned(), scene: SceneKey::of(scene), open }, damaged))
        };
        begin().map_err(|reason| JournalError { path: path.to_owned(), reason })
    }

    /// The result of a core on this scene, if it is known.
    ///
    /// # Errors
    /// [`JournalError`] if the spec cannot be put into JSON.
    pub fn find(&self, spec: &CoreSpec) -> Result<Option<Measured>, JournalError> {
        let key = json(&self.key(spec)?).map_err(|reason| self.failed(reason))?;
        Ok(self.lock().results.get(&key).cloned())
    }

    /// Adds a result; once this returns, the result is in the file.
    ///
    /// # Errors
    /// [`JournalError`] if the file cannot be written.
    pub fn add(&self, spec: &CoreSpec, measured: &Measured) -> Result<(), JournalError> {
        let line = Line { key: self.key(spec)?, measured: measured.clone() };
        let write = || {
            let (key, text) = (json(&line.key)?, json(&line)?);
            let mut open = self.lock();
            // A line is written at once, so an interrupted program leaves a whole line or a damaged
            // last one.
            open.file.write_all(format!("{text}\n").as_bytes())?;
            open.file.flush()?;
            open.results.insert(key, line.measured);
            Ok(())
        };
        write().map_err(|reason| self.failed(reason))
    }

    /// All results, a line each, in an order that does not depend on when they came.
    ///
    /// # Errors
    /// [`JournalError`] if one cannot be put into JSON.
    pub fn text(&self) -> Result<String, JournalError> {
        text(&self.lock().results).map_err(|reason| self.failed(reason))
    }

    fn key(&self, spec: &CoreSpec) -> Result<Key, JournalError> {
        let spec = serde_json::to_value(spec).map_err(|error| self.failed(error.into()))?;
        Ok(Key { scene: self.scene.clone(), spec })
    }

    fn failed(&self, reason: io::Error) -> JournalError {
        JournalError { path: self.path.clone(), reason }
    }

    /// Locks the journal; a thread that panicked has left whole lines.
    fn lock(&self) -> MutexGuard<'_, Open> {
        self.open.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl SceneKey {
    fn of(scene: &LoadedScene) -> SceneKey {
        let mut hash = Hash(DefaultHasher::new());
        // Hashing cannot fail.
        let _ = write!(hash, "{:?}{:?}", scene.frame, scene.surfaces);
        SceneKey {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scene: format!("{:016x}", hash.0.finish()),
        }
    }
}

/// Hashes the bytes that are written into it. Another release of Rust may hash otherwise; then
/// known results are measured again.
struct Hash(DefaultHasher);

impl fmt::Write for Hash {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}

/// The results in a file, none if it does not exist, and the lines that are not results.
fn read(path: &Path) -> io::Result<(BTreeMap<String, Measured>, Vec<Damaged>)> {
    let bytes = match read_regular(path, LONGEST_FILE) {
        Err(reason) if reason.is_missing() => return Ok(Default::default()),
        read => read?,
    };
    let (mut results, mut damaged) = (BTreeMap::new(), Vec::new());
    let mut lines: Vec<&[u8]> = bytes.split(|&byte| byte == b'\n').collect();
    // Nothing follows the end of the last line, unless the program was interrupted while it wrote.
    let rest = lines.pop().filter(|rest| !rest.is_empty());
    for (number, line) in lines.into_iter().enumerate() {
        match parsed(line) {
            Ok((key, measured)) => drop(results.insert(key, measured)),
            Err(error) => damaged.push(Damaged { line: number + 1, reason: error.to_string() }),
        }
    }
    let line = bytes.iter().filter(|&&byte| byte == b'\n').count() + 1;
    damaged.extend(rest.map(|_| Damaged { line, reason: "it has no end".to_owned() }));
    Ok((results, damaged))
}

fn parsed(line: &[u8]) -> serde_json::Result<(String, Measured)> {
    let Line { key, measured } = serde_json::from_slice(line)?;
    Ok((serde_json::to_string(&key)?, measured))
}

/// Rewrites the file: first under another name next to it, so that an interruption loses nothing.
fn rewrite(path: &Path, results: &BTreeMap<String, Measured>) -> io::Result<()> {
    let mut beside = replacement_file(path)?;
    beside.write_all(text(results)?.as_bytes())?;
    beside.persist(path)?;
    Ok(())
}

/// An empty file whose name says which file it will replace.
fn replacement_file(path: &Path) -> io::Result<tempfile::NamedTempFile> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    tempfile::Builder::new()
        .prefix(&Journal::replacement_prefix(&name))
        .tempfile_in(folder.unwrap_or(Path::new(".")))
}

fn text(results: &BTreeMap<String, Measured>) -> io::Result<String> {
    let line = |(key, measured): (&String, &Measured)| {
        let key: Key = serde_json::from_str(key)?;
        Ok(json(&Line { key, measured: measured.clone() })? + "\n")
    };
    let lines: io::Result<BTreeSet<String>> = results.iter().map(line).collect();
    Ok(lines?.into_iter().collect())
}

fn json(value: &impl Serialize) -> io::Result<String> {
    Ok(serde_json::to_string(value)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use specula_spec::{Method, SceneCore};
    use std::fs;

    fn with_results(test: impl Fn(&LoadedScene, &Path, &[CoreSpec])) {
        let folder = tempfile::tempdir().unwrap();
        let (path, scene) = (
            folder.path().join("results.jsonl"),
            specula_scene::load("icosahedron", Some((16, 12))).unwrap(),
        );
        let spec = |method| scene.core_spec(Some(method)).unwrap();
        let specs = [Method::Gouraud, Method::Hybrid].map(spec);
        let (journal, damaged) = Journal::open(&path, &scene).unwrap();
        assert_eq!(damaged, []);
        for spec in &specs {
            assert_eq!(journal.find(spec).unwrap(), None);
            journal.add(spec, &Measured::new(&scene, spec).unwrap()).unwrap();
        }
        test(&scene, &path, &specs);
    }

    #[test]
    fn what_is_written_is_found_again() {
        with_results(|scene, path, specs| {
            let (journal, damaged) = Journal::open(path, scene).unwrap();
            assert_eq!(damaged, []);
            for spec in specs {
                assert_eq!(journal.find(spec).unwrap(), Some(Measured::new(scene, spec).unwrap()));
            }
        });
    }

    #[test]
    fn a_journal_is_told_from_another_file() {
        with_results(|_, path, _| {
            let whole = fs::read(path).unwrap();
            let cut_in_its_first_line = &whole[..10];
            let damaged = [b"no result\n", &whole[..]].concat();
            for ours in [&b""[..], &whole, cut_in_its_first_line, &damaged] {
                assert!(Journal::has_written(ours));
            }
            assert!(!Journal::has_written(b"{\"accuracy\":1}\n{\"accuracy\":2}\n"));
        });
    }

    #[test]
    fn what_takes_a_journals_place_is_known_by_its_name() {
        let folder = tempfile::tempdir().unwrap();
        let beside = replacement_file(&folder.path().join("results.jsonl")).unwrap();
        let name = beside.path().file_name().unwrap().to_string_lossy();
        assert!(name.starts_with(".results.jsonl-") && name.len() > 15, "{name}");
        assert_eq!(beside.path().parent(), Some(folder.path()));
    }

    #[test]
    fn another_scene_has_results_of_its_own() {
        with_results(|_, path, specs| {
            let other = specula_scene::load("icosahedron", Some((18, 12))).unwrap();
            let (journal, _) = Journal::open(path, &other).unwrap();
            assert_eq!(journal.find(&specs[0]).unwrap(), None);
        });
    }

    #[test]
    fn damaged_lines_are_told_and_taken_out() {
        with_results(|scene, path, specs| {
            let whole = fs::read_to_string(path).unwrap();
            let cut = &whole[..whole.len() - 9];
            fs::write(path, format!("no result\n{cut}")).unwrap();
            let (journal, damaged) = Journal::open(path, scene).unwrap();
            assert_eq!(damaged.iter().map(|damaged| damaged.line).collect::<Vec<_>>(), [1, 3]);
            assert!(
                journal.find(&specs[0]).unwrap().is_some()
                    && journal.find(&specs[1]).unwrap().is_none()
            );
            journal.add(&specs[1], &Measured::new(scene, &specs[1]).unwrap()).unwrap();
            let (again, damaged) = Journal::open(path, scene).unwrap();
            assert_eq!((damaged, again.find(&specs[1]).unwrap().is_some()), (vec![], true));
        });
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn results_are_kept_in_a_regular_file_and_in_no_other() {
        let folder = tempfile::tempdir().unwrap();
        let scene = specula_scene::load("icosahedron", Some((16, 12))).unwrap();
        let path = folder.path().join("results.jsonl");
        std::os::unix::fs::symlink("/dev/zero", &path).unwrap();
        let error = Journal::open(&path, &scene).unwrap_err().to_string();
        assert_eq!(
            error,
            format!("results cannot be kept in `{}`: it is not a regular file", path.display())
        );
    }
}

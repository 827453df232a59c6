//! Tests of what a kill before any operation leaves, and of what the next program makes of it.
use std::collections::BTreeMap;

use super::super::leftovers::{Settled, settle};
use super::super::own::PROGRAM;
use super::*;

/// The capabilities of a file system.
#[derive(Clone, Copy, Debug)]
struct Able {
    exchange: bool,
    link: bool,
}

const DISKS: [Able; 4] = [
    Able { exchange: true, link: true },
    Able { exchange: true, link: false },
    Able { exchange: false, link: true },
    Able { exchange: false, link: false },
];

/// A disk that copies everything before each operation, as a kill would leave it.
struct Watched<'a> {
    able: Able,
    place: &'a Path,
    kills: &'a Path,
    number: usize,
}

impl Watched<'_> {
    fn step(&mut self) {
        copy(self.place, &self.kills.join(self.number.to_string()));
        self.number += 1;
    }
}

impl Disk for Watched<'_> {
    fn rename(&mut self, from: &Path, to: &Path) -> io::Result<()> {
        self.step();
        System.rename(from, to)
    }

    fn exchange(&mut self, one: &Path, other: &Path) -> io::Result<()> {
        self.step();
        if self.able.exchange {
            System.exchange(one, other)
        } else {
            Err(io::ErrorKind::Unsupported.into())
        }
    }

    fn link(&mut self, file: &Path, name: &Path) -> io::Result<()> {
        self.step();
        if self.able.link {
            System.link(file, name)
        } else {
            Err(io::ErrorKind::PermissionDenied.into())
        }
    }

    fn remove_file(&mut self, file: &Path) -> io::Result<()> {
        self.step();
        System.remove_file(file)
    }

    fn make_folder(&mut self, folder: &Path) -> io::Result<()> {
        self.step();
        System.make_folder(folder)
    }
}

/// Copies a folder; files with several names keep them in the copy.
fn copy(from: &Path, to: &Path) {
    fn copy_into(from: &Path, to: &Path, seen: &mut BTreeMap<u64, PathBuf>) {
        fs::create_dir(to).unwrap();
        for entry in fs::read_dir(from).unwrap().map(|entry| entry.unwrap()) {
            let (path, copied) = (entry.path(), to.join(entry.file_name()));
            if entry.file_type().unwrap().is_dir() {
                copy_into(&path, &copied, seen);
            } else if let Some(first) = seen.get(&number(&path)) {
                fs::hard_link(first, &copied).unwrap();
            } else {
                fs::copy(&path, &copied).unwrap();
                seen.insert(number(&path), copied);
            }
        }
    }
    copy_into(from, to, &mut BTreeMap::new());
}

#[cfg(unix)]
fn number(path: &Path) -> u64 {
    use std::os::unix::fs::MetadataExt;
    path.symlink_metadata().unwrap().ino()
}

#[cfg(not(unix))]
fn number(path: &Path) -> u64 {
    use std::hash::{DefaultHasher, Hash, Hasher};
    let mut hash = DefaultHasher::new();
    path.hash(&mut hash);
    hash.finish()
}

/// Writes files and the report that lists them.
fn write(file: impl Fn(&str) -> PathBuf, names: &[&str], text: &str) {
    names.iter().for_each(|name| fs::write(file(name), text).unwrap());
    let files: Vec<&str> = names.iter().copied().chain([REPORT]).collect();
    let report = serde_json::json!({ "program": PROGRAM, "files": files, "text": text });
    fs::write(file(REPORT), report.to_string()).unwrap();
}

/// A folder of an earlier run, with files of the user's, and a new staged one.
fn staged(place: &Path) -> Staging {
    let out = place.join("out");
    fs::create_dir_all(out.join("notes")).unwrap();
    write(|name| out.join(name), &["old.v", "simulated.png"], "old");
    fs::write(out.join("mine.txt"), "mine").unwrap();
    fs::write(out.join("notes/deep.txt"), "mine too").unwrap();
    let names = ["new.v", "simulated.png", REPORT].map(str::to_owned);
    let destination = Destination::check(&out, &names, &Interrupts::default()).unwrap();
    let staging = destination.stage().unwrap();
    write(|name| staging.file(name), &["new.v", "simulated.png"], "new");
    staging
}

/// Every file below a folder, with its text.
fn files(folder: &Path) -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()) {
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.file_type().unwrap().is_dir() {
            all.extend(
                files(&entry.path())
                    .into_iter()
                    .map(|(below, text)| (format!("{name}/{below}"), text)),
            );
        } else {
            all.insert(name, fs::read_to_string(entry.path()).unwrap());
        }
    }
    all
}

/// Whether the folder contains all files of one run, none of another, and the user's files.
fn is_whole(place: &Path, text: &str, verilog: &str) -> bool {
    let held = files(&place.join("out"));
    let own = [verilog, "simulated.png"]
        .iter()
        .all(|name| held.get(*name).is_some_and(|held| held == text));
    let report =
        held.get(REPORT).is_some_and(|report| report.contains(&format!("\"text\":\"{text}\"")));
    own && report && held.len() == 5 && has_users_files(&held)
}

fn has_users_files(held: &BTreeMap<String, String>) -> bool {
    held.get("mine.txt").is_some_and(|text| text == "mine")
        && held.get("notes/deep.txt").is_some_and(|text| text == "mine too")
}

/// Publishes on such a disk; the result is the folders that kills would have left.
fn killed(able: Able, room: &Path) -> Vec<PathBuf> {
    let (place, kills) = (room.join("place"), room.join("kills"));
    fs::create_dir_all(&kills).unwrap();
    let staging = staged(&place);
    let mut disk = Watched { able, place: &place, kills: &kills, number: 0 };
    staging.publish_by(&mut disk).unwrap();
    assert!(is_whole(&place, "new", "new.v"), "{able:?}: {:?}", files(&place));
    assert_eq!(fs::read_dir(&place).unwrap().count(), 1, "{able:?}: {:?}", files(&place));
    disk.step();
    (0..disk.number).map(|number| kills.join(number.to_string())).collect()
}

#[test]
fn a_kill_at_any_step_hides_nothing() {
    for able in DISKS {
        let room = tempfile::tempdir().unwrap();
        let left = killed(able, room.path());
        assert!(left.len() >= 4, "{able:?}");
        for place in left {
            let held = files(&place.join("out"));
            assert!(held.contains_key("simulated.png"), "{able:?}, {}: {held:?}", place.display());
            // What can have a second name, or is never moved, is always present.
            if able.link || !able.exchange {
                assert_eq!(
                    held.get("mine.txt").map(String::as_str),
                    Some("mine"),
                    "{able:?}, {}",
                    place.display()
                );
            }
            let settled = settle(&place, &mut System);
            assert!(
                settled.iter().all(|settled| !matches!(settled, Settled::Left(..))),
                "{able:?}: {settled:?}"
            );
            let whole = is_whole(&place, "old", "old.v") || is_whole(&place, "new", "new.v");
            assert!(whole, "{able:?}, {}: {:?}", place.display(), files(&place));
            assert_eq!(fs::read_dir(&place).unwrap().count(), 1, "{able:?}, {}", place.display());
        }
    }
}

#[test]
fn a_kill_while_leftovers_are_settled_hides_nothing_either() {
    for able in DISKS {
        let room = tempfile::tempdir().unwrap();
        for place in killed(able, room.path()) {
            let again = tempfile::tempdir().unwrap();
            let mut disk = Watched { able, place: &place, kills: again.path(), number: 0 };
            settle(&place, &mut disk);
            for number in 0..disk.number {
                let place = again.path().join(number.to_string());
                settle(&place, &mut System);
                let whole = is_whole(&place, "old", "old.v") || is_whole(&place, "new", "new.v");
                assert!(whole, "{able:?}, {}: {:?}", place.display(), files(&place));
            }
        }
    }
}

#[test]
fn a_kill_while_the_temporary_folder_goes_leaves_what_is_understood() {
    let room = tempfile::tempdir().unwrap();
    let leftover = room.path().join(".specula-1");
    let record =
        Record { step: Step::Exchange, old: ["a".into()].into(), new: ["b".into()].into() };
    for (has_folder, has_record, has_lock) in
        [(true, true, true), (false, true, true), (false, false, true), (false, false, false)]
    {
        fs::create_dir(&leftover).unwrap();
        if has_folder {
            fs::create_dir_all(leftover.join("folder/out")).unwrap();
            fs::write(leftover.join("folder/out/a"), "old").unwrap();
        }
        if has_record {
            record.write(&leftover, &mut System).unwrap();
        }
        if has_lock {
            fs::write(leftover.join("lock"), "").unwrap();
        }
        settle(room.path(), &mut System);
        assert_eq!(
            fs::read_dir(room.path()).unwrap().count(),
            0,
            "{has_folder}, {has_record}, {has_lock}"
        );
    }
}

#[test]
fn what_is_under_way_or_unknown_is_left_alone() {
    let room = tempfile::tempdir().unwrap();
    let staging = staged(room.path());
    assert!(settle(room.path(), &mut System).is_empty() && staging.file("new.v").exists());
    drop(staging);
    fs::create_dir_all(room.path().join(".specula-old/old")).unwrap();
    fs::write(room.path().join(".specula-old/old/thesis.tex"), "mine").unwrap();
    let said: Vec<String> =
        settle(room.path(), &mut System).iter().map(Settled::to_string).collect();
    assert!(said.len() == 1 && said[0].contains(".specula-old`, and it stays there"), "{said:?}");
    assert!(room.path().join(".specula-old/old/thesis.tex").exists());
}

#[test]
fn what_a_damaged_record_tells_of_is_kept() {
    for record in ["", "{\"step\":\"Later\",\"old\":[],\"new\":[]}"] {
        let room = tempfile::tempdir().unwrap();
        let leftover = room.path().join(".specula-1");
        fs::create_dir_all(leftover.join("folder/out")).unwrap();
        fs::write(leftover.join("folder/out/mine.txt"), "mine").unwrap();
        fs::write(leftover.join("record.json"), record).unwrap();
        fs::write(leftover.join("lock"), "").unwrap();
        let settled = settle(room.path(), &mut System);
        assert!(matches!(&settled[..], [Settled::Left(..)]), "{settled:?}");
        assert_eq!(files(room.path())[".specula-1/folder/out/mine.txt"], "mine");
    }
}

#[test]
fn a_newer_file_of_the_same_name_is_not_replaced() {
    let room = tempfile::tempdir().unwrap();
    let leftover = room.path().join(".specula-1");
    fs::create_dir_all(leftover.join("folder/out")).unwrap();
    fs::create_dir(room.path().join("out")).unwrap();
    Record { step: Step::Exchange, old: BTreeSet::new(), new: BTreeSet::new() }
        .write(&leftover, &mut System)
        .unwrap();
    fs::write(leftover.join("lock"), "").unwrap();
    fs::write(leftover.join("folder/out/mine.txt"), "older").unwrap();
    fs::write(room.path().join("out/mine.txt"), "newer").unwrap();
    let settled = settle(room.path(), &mut System);
    assert!(matches!(&settled[..], [Settled::Left(..)]), "{settled:?}");
    let held = files(room.path());
    assert_eq!(
        (held["out/mine.txt"].as_str(), held[".specula-1/folder/out/mine.txt"].as_str()),
        ("newer", "older")
    );
}

#[test]
fn a_file_that_came_while_results_were_computed_is_not_replaced() {
    let room = tempfile::tempdir().unwrap();
    let staging = staged(room.path());
    fs::write(room.path().join("out/new.v"), "somebody's").unwrap();
    let error = staging.publish().unwrap_err();
    assert!(matches!(&error, OutputError::InTheWay { name, .. } if name == "new.v"), "{error}");
    assert_eq!(files(room.path())["out/new.v"], "somebody's");
    assert_eq!(fs::read_dir(room.path()).unwrap().count(), 1);
}

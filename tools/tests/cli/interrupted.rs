//! `specula run` with a scene that moves, interrupted and started again.
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use crate::program::Place;

/// A torus that turns.
const SCENE: &str = "
size = [40, 30]
[camera]
target = [0, 0, 0]
height = 3
[[object]]
primitive = \"torus\"
level = 5
[core]
method = \"lyon\"
[sequence]
frames = 24
[[sequence.motion]]
of = \"object 1\"
turn = 90
axis = [1, 0, 0]
";

const RUN: [&str; 6] = ["run", "turn.toml", "--trace", "none", "-o", "turn"];
const JOURNAL: &str = "turn.partial/frames.jsonl";

/// A place with the scene.
fn place() -> Place {
    let place = Place::new();
    place.write("turn.toml", SCENE);
    place
}

/// The place of a run that was killed when some frames were done.
fn killed() -> Place {
    // Where the machine stops for a while, a run may be done before it is killed; not ten times.
    let runs = (0..10).map(|_| {
        let place = place();
        let mut running = place.program(".");
        let mut running = running.args(RUN).stderr(Stdio::null()).spawn().expect("it starts");
        while running.try_wait().expect("it runs").is_none() && done(&place).len() < 4 {
            sleep(Duration::from_millis(1));
        }
        running.kill().and_then(|()| running.wait()).expect("it can be killed");
        place
    });
    let mut of_use = runs.filter(|place| (4..20).contains(&done(place).len()));
    of_use.next().expect("a run is killed before it is done")
}

/// The lines of the journal that are whole, the first one apart.
fn done(place: &Place) -> Vec<String> {
    let text = fs::read_to_string(place.path(JOURNAL)).unwrap_or_default();
    let whole = text.rfind('\n').map_or("", |end| &text[..end]);
    whole.lines().skip(1).map(str::to_owned).collect()
}

/// The place of a run that was not interrupted.
fn whole() -> Place {
    let place = place();
    place.succeeds(&RUN);
    place
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("there is room");
    for entry in fs::read_dir(from).expect("it can be read").flatten() {
        fs::copy(entry.path(), to.join(entry.file_name())).expect("there is room");
    }
}

/// Runs again, which has to say `said`, and compares every file with those of a whole run.
fn goes_on(place: &Place, whole: &Place, said: &str) {
    let ended = place.specula(&RUN);
    assert_eq!((ended.status, ended.stderr.as_str()), (Some(0), said));
    assert_eq!(place.names("turn"), whole.names("turn"));
    for name in place.names("turn").iter().filter(|name| !name.starts_with("report.")) {
        let read = |place: &Place| fs::read(place.path("turn").join(name)).expect("it is there");
        assert!(read(place) == read(whole), "{name}");
    }
    assert_eq!(place.report("turn")["sequence"], whole.report("turn")["sequence"]);
    assert_eq!(place.names("."), ["turn", "turn.toml"]);
}

fn known(frames: usize) -> String {
    format!("frames: {frames} of 24 are there from a run that was interrupted\n")
}

/// Whatever is damaged is shaded again, and the result is the same.
#[test]
fn an_interrupted_sequence_goes_on_where_it_stopped() {
    let (whole, killed) = (whole(), killed());
    // What the killed program was writing is settled by the next one.
    assert!(!killed.path("turn").exists());
    let lines = done(&killed);
    let text = fs::read_to_string(killed.path(JOURNAL)).expect("it is there");
    let head = text.lines().next().expect("it has a first line");
    let picture = |line: &str| {
        let line: serde_json::Value = serde_json::from_str(line).expect("it is JSON");
        format!("turn.partial/frame_{:04}.png", line["frame"]["frame"].as_u64().unwrap_or(0))
    };
    let journal = |lines: &[String]| {
        [&[head.to_owned()], lines].concat().iter().map(|line| format!("{line}\n")).collect()
    };
    let left = |text: String| {
        let place = place();
        copy(&killed.path("turn.partial"), &place.path("turn.partial"));
        place.write(JOURNAL, text);
        place
    };
    let all: String = journal(&lines);

    goes_on(&left(all.clone()), &whole, &known(lines.len()));
    let without_end = all[..all.len() - 9].to_owned();
    goes_on(&left(without_end), &whole, &known(lines.len() - 1));
    let damaged_within = all.replacen(&lines[0], &lines[0][1..], 1);
    goes_on(&left(damaged_within), &whole, &known(lines.len() - 1));
    let without_pictures = left(all.clone());
    fs::remove_file(without_pictures.path(&picture(&lines[0]))).expect("it is there");
    without_pictures.write(&picture(&lines[1]), "damaged");
    goes_on(&without_pictures, &whole, &known(lines.len() - 2));
    goes_on(&left(journal(&[])), &whole, "");
    goes_on(&left(String::new()), &whole, "");
}

/// Frames of other scenes, engines and folders are not taken.
#[test]
fn what_another_run_left_is_replaced_or_refused() {
    let (whole, killed) = (whole(), killed());
    let replaced = "frames: all are shaded; `turn.partial` was of another scene, core, engine or \
                    version, and is replaced\n";
    let left = |scene: &str| {
        let place = Place::new();
        place.write("turn.toml", scene);
        copy(&killed.path("turn.partial"), &place.path("turn.partial"));
        place
    };
    let other = left(&SCENE.replace("turn = 90", "turn = 91"));
    let ended = other.specula(&RUN);
    assert_eq!((ended.status, ended.stderr.as_str()), (Some(0), replaced));
    let other = left(SCENE);
    let ended = other.specula(&[&RUN[..], &["--stalls", "7"]].concat());
    assert_eq!((ended.status, ended.stderr.as_str()), (Some(0), replaced));
    let other = left(SCENE);
    let text = fs::read_to_string(other.path(JOURNAL)).expect("it is there");
    other.write(JOURNAL, text.replacen("fingerprint\":\"", "fingerprint\":\"0", 1));
    goes_on(&other, &whole, replaced);

    let mine = left(SCENE);
    mine.write("turn.partial/thesis.tex", "mine");
    let refused = mine.specula(&RUN);
    assert_eq!(refused.status, Some(2));
    let said = "`turn.partial` contains files that Specula did not write, such as `thesis.tex`";
    assert!(refused.stderr.contains(said), "{}", refused.stderr);
}

/// Results of an earlier run stay until those of the next are whole.
#[test]
fn earlier_results_stay_until_the_next_are_whole() {
    let (whole, killed, place) = (whole(), killed(), place());
    copy(&killed.path("turn.partial"), &place.path("turn.partial"));
    copy(&whole.path("turn"), &place.path("turn"));
    goes_on(&place, &whole, &known(done(&killed).len()));
}

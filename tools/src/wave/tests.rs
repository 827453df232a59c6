//! Damaged dumps, thousands of them: each is drawn or refused, none makes the program panic.
use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::*;

const VCD: &[u8] = include_bytes!("../../tests/data/wave/counter.vcd");
const FST: &[u8] = include_bytes!("../../tests/data/wave/counter.fst");

/// A file that is written again and again.
struct Scratch {
    _folder: TempDir,
    path: PathBuf,
}

impl Scratch {
    fn new() -> Scratch {
        let folder = TempDir::new().expect("there is room");
        Scratch { path: folder.path().join("dump"), _folder: folder }
    }

    /// Draws `bytes` in every way; a refusal is as good as a drawing.
    fn draw(&self, bytes: &[u8]) -> Result<String, WaveError> {
        fs::write(&self.path, bytes).expect("a file can be written");
        let figure = figure(&self.path)?;
        svg(&figure);
        Ok(text(&figure, 100))
    }
}

fn figure(path: &Path) -> Result<Figure, WaveError> {
    let mut view = View::open(path)?;
    let choice = view.choose(&Selection { patterns: vec!["*".to_owned()], unit: None })?;
    view.figure(&choice, &Asked { from: None, to: None, usual: 20 })
}

#[test]
fn whole_dumps_are_drawn() {
    let scratch = Scratch::new();
    let [vcd, fst] = [VCD, FST].map(|bytes| scratch.draw(bytes).expect("it is whole"));
    assert_eq!(vcd.lines().count(), fst.lines().count());
}

#[test]
fn dumps_may_end_anywhere() {
    let scratch = Scratch::new();
    for whole in [VCD, FST] {
        let drawn = (0..whole.len()).filter(|&length| scratch.draw(&whole[..length]).is_ok()).count();
        assert!(drawn < whole.len());
    }
}

#[test]
fn any_byte_may_be_wrong() {
    let scratch = Scratch::new();
    for whole in [VCD, FST] {
        for place in 0..whole.len() {
            for wrong in [whole[place] ^ 1, whole[place] ^ 0x80, b'2'] {
                let mut bytes = whole.to_vec();
                bytes[place] = wrong;
                // Drawn or refused: what counts is that it ends.
                let _ = scratch.draw(&bytes);
            }
        }
    }
}

#[test]
fn values_that_make_the_reader_panic_are_refused() {
    let text = String::from_utf8_lossy(VCD).replace("b11010100 !", "b1101q100 !");
    let error = Scratch::new().draw(text.as_bytes()).expect_err("there is no bit q");
    assert!(matches!(error, WaveError::Damaged { .. }), "{error}");
}

#[test]
fn names_do_not_reach_the_terminal_with_control_characters() {
    let text = String::from_utf8_lossy(VCD).replace("enable", "\u{1b}[2J<&>");
    let scratch = Scratch::new();
    assert!(!scratch.draw(text.as_bytes()).expect("it is well formed").contains('\u{1b}'));
    let drawn = svg(&figure(&scratch.path).expect("it is well formed"));
    assert!(drawn.contains("[2J&lt;&amp;&gt;") && !drawn.contains('\u{1b}'), "{drawn}");
}

#[test]
fn huge_times_are_no_trouble() {
    let scratch = Scratch::new();
    for times in [[0, 1, u64::MAX], [u64::MAX - 2, u64::MAX - 1, u64::MAX], [0, u64::MAX / 2, u64::MAX - 1]] {
        for name in ["clock", "other"] {
            let [a, b, c] = times;
            let dump = format!("$var wire 1 ! {name} $end\n$enddefinitions $end\n#{a}\n0!\n#{b}\n1!\n#{c}\n0!\n");
            let _ = scratch.draw(dump.as_bytes());
        }
    }
}

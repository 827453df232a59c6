//! Thousands of damaged dumps: each is drawn or refused; none makes the program panic or hang.
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::*;

const VCD: &[u8] = include_bytes!("../tests/data/wave/counter.vcd");
const FST: &[u8] = include_bytes!("../tests/data/wave/counter.fst");
/// A file that GHDL wrote: compressed as a whole, with text, an enumeration and VHDL's states.
const PACKED: &[u8] = include_bytes!("../tests/data/wave/states.fst");
/// A file with what simulators write although IEEE 1364 does not have it.
const DIALECTS: &[u8] = include_bytes!("../tests/data/wave/dialects.vcd");

/// A temporary file that is rewritten for each dump.
struct Scratch {
    _folder: TempDir,
    path: PathBuf,
}

impl Scratch {
    fn new() -> Scratch {
        let folder = TempDir::new().expect("there is room");
        Scratch { path: folder.path().join("dump"), _folder: folder }
    }

    /// Draws `bytes` in every way; a refusal counts as much as a drawing.
    fn draw(&self, bytes: &[u8]) -> Result<String, WaveError> {
        self.draw_to(bytes, None)
    }

    fn draw_to(&self, bytes: &[u8], to: Option<u64>) -> Result<String, WaveError> {
        fs::write(&self.path, bytes).expect("a file can be written");
        let figure = figure(&self.path, to)?;
        svg(&figure, None);
        Ok(text(&figure, 100))
    }
}

fn figure(path: &Path, to: Option<u64>) -> Result<Figure, WaveError> {
    let mut view = DumpView::open(path)?;
    let choice = view.choose(&Selection { patterns: vec!["*".to_owned()], unit: None })?;
    view.figure(&choice, &WindowRequest { from: None, to, default_columns: 20 })
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
    for whole in [VCD, FST, PACKED, DIALECTS] {
        let drawn =
            (0..whole.len()).filter(|&length| scratch.draw(&whole[..length]).is_ok()).count();
        assert!(drawn < whole.len());
    }
}

#[test]
fn vcd_files_are_drawn_up_to_where_they_are_cut_off() {
    let scratch = Scratch::new();
    let begin = VCD.windows(3).position(|three| three == b"#0\n").expect("it has a first time");
    for length in begin + 20..VCD.len() {
        scratch.draw(&VCD[..length]).expect("some values are there");
    }
}

/// The unpacked contents of the packed file.
fn unpacked() -> Vec<u8> {
    let mut bytes = vec![];
    flate2::read::GzDecoder::new(&PACKED[17..]).read_to_end(&mut bytes).expect("it is whole");
    bytes
}

#[test]
fn any_byte_may_be_wrong() {
    let scratch = Scratch::new();
    for whole in [VCD, FST, PACKED, DIALECTS, &unpacked()] {
        for place in 0..whole.len() {
            for wrong in [whole[place] ^ 1, whole[place] ^ 0x80, b'2'] {
                let mut bytes = whole.to_vec();
                bytes[place] = wrong;
                // The dump may be drawn or refused; the test is that this ends.
                let _ = scratch.draw(&bytes);
            }
        }
    }
}

/// Pseudo-random numbers (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % limit.max(1) as u64) as usize
    }
}

/// Pieces of a dump are removed, repeated, exchanged, and replaced by pieces of another.
#[test]
fn pieces_may_stand_anywhere() {
    const SEED: u64 = 0x5eed_0012;
    let (scratch, mut random) = (Scratch::new(), Random(SEED));
    let unpacked = unpacked();
    let seeds = [VCD, DIALECTS, FST, &unpacked];
    for round in 0..4_000 {
        let mut bytes = seeds[round % seeds.len()].to_vec();
        for _ in 0..=random.below(4) {
            let other = seeds[random.below(seeds.len())];
            let from = random.below(other.len());
            let piece = &other[from..other.len().min(from + 1 + random.below(60))];
            let at = random.below(bytes.len());
            let end = bytes.len().min(at + random.below(60));
            let with: &[u8] = if random.below(3) == 0 { &[] } else { piece };
            bytes.splice(at..end, with.iter().copied());
        }
        let _ = scratch.draw(&bytes);
    }
}

/// A length that an FST file states may have any value.
#[test]
fn lengths_may_be_anything() {
    let scratch = Scratch::new();
    let numbers = [0, 7, 9, 24, 1 << 31, 1 << 40, i64::MAX as u64, u64::MAX - 8, u64::MAX];
    // Everything behind the two lengths is compressed.
    for (whole, places) in [(FST, FST.len() - 8), (PACKED, 10)] {
        for place in 0..places {
            for number in numbers {
                let mut bytes = whole.to_vec();
                bytes[place..place + 8].copy_from_slice(&number.to_be_bytes());
                let _ = scratch.draw(&bytes);
            }
        }
    }
}

#[test]
fn blocks_that_point_backwards_end_it() {
    let scratch = Scratch::new();
    assert!(matches!(scratch.draw(&[0xff; 9]), Err(WaveError::Kind { .. })));
    let backwards = [&FST[..330], &[0xff; 9]].concat();
    assert!(matches!(scratch.draw(&backwards), Err(WaveError::Damaged { .. })));
}

#[test]
fn names_do_not_reach_the_terminal_with_control_characters() {
    let text = String::from_utf8_lossy(VCD).replace("enable", "\u{1b}[2J<&>\u{7}");
    let scratch = Scratch::new();
    // VCD treats the escape character as a blank, so it separates words.
    let text = text.replace("\u{1b}[2J<&>\u{7}", "\u{9b}2J<&>");
    assert!(!scratch.draw(text.as_bytes()).expect("it is well formed").contains('\u{9b}'));
    let drawn = svg(&figure(&scratch.path, None).expect("it is well formed"), None);
    assert!(drawn.contains("2J&lt;&amp;&gt;") && !drawn.contains('\u{9b}'), "{drawn}");
}

#[test]
fn huge_times_are_no_trouble() {
    let scratch = Scratch::new();
    for times in
        [[0, 1, u64::MAX], [u64::MAX - 2, u64::MAX - 1, u64::MAX], [0, u64::MAX / 2, u64::MAX - 1]]
    {
        for name in ["clock", "other"] {
            let [a, b, c] = times;
            let dump = format!(
                "$var wire 1 ! {name} $end\n$enddefinitions $end\n#{a}\n0!\n#{b}\n1!\n#{c}\n0!\n"
            );
            scratch.draw(dump.as_bytes()).expect("times may be as large as they like");
        }
    }
}

/// A small file that states large sizes must not take much memory.
#[test]
fn small_files_that_say_much_are_refused_or_drawn_soon() {
    let scratch = Scratch::new();
    let header = "$timescale 1ns $end\n$scope module top $end\n";
    let deep: String = (0..20_000)
        .map(|number| format!("$scope module s{number} $end $var wire 1 ! a{number} $end\n"))
        .collect();
    assert!(scratch.draw(format!("{header}{deep}#0\n1!\n#1\n").as_bytes()).is_ok());
    let wide = format!("{header}$var wire 1048576 ! w $end\n$var wire 1 \" a $end\n#0\n1\"\n");
    let toggles: String = (0..2_000).map(|time| format!("#{time}\nb{} !\n", time % 2)).collect();
    let drawn = scratch.draw_to(format!("{wide}{toggles}").as_bytes(), Some(2_000));
    assert!(matches!(drawn, Err(WaveError::Large { .. })));
    let long = format!("{header}$var wire 1 ! a $end\n#0\nb{} !\n#1\n1!\n", "1".repeat(4 << 20));
    assert!(scratch.draw(long.as_bytes()).is_ok());
}

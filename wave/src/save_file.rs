//! GTKWave's save file that belongs to a dump: the signals to show, their formats, and the marker.
//!
//! This reads the lines that Specula writes (see `gtkw.rs` in `sim/`) and that GTKWave keeps when
//! it saves. Other lines are skipped.
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use super::value::Notation;
use super::warnings::{Warnings, decoded};

/// Largest number of bytes that are read of a save file.
const MAX_BYTES: u64 = 64 << 20;

/// Bits of GTKWave's flags (`TraceEntFlagBits` of its `analyzer.h`).
mod flag {
    pub const DECIMAL: u64 = 1 << 2;
    pub const BINARY: u64 = 1 << 3;
    pub const SIGNED_DECIMAL: u64 = 1 << 10;
    pub const CLOSED: u64 = 1 << 22;
    pub const GROUP_BEGIN: u64 = 1 << 23;
    pub const GROUP_END: u64 = 1 << 24;
    pub const FIXED_POINT: u64 = 1 << 30;
}

/// A save file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SaveFile {
    /// Its signals, in the file's order.
    pub signals: Vec<SavedSignal>,
    /// The marked time.
    pub marker: Option<u64>,
}

/// A signal of a save file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SavedSignal {
    /// Its full name, without the range of its bits.
    pub name: String,
    /// The notation of its values.
    pub notation: Notation,
    /// Whether it is shown, that is, not in a closed group.
    pub visible: bool,
}

impl SaveFile {
    /// Reads the save file that belongs to a dump: it has the same name with the extension `.gtkw`.
    /// The result is `None` if there is none, or if it cannot be read, which is a warning.
    pub fn of_dump(dump: &Path, warnings: &mut Warnings) -> Option<SaveFile> {
        let path = dump.with_extension("gtkw");
        match read(&path) {
            Ok(text) => Some(SaveFile::parse(&text)),
            Err(reason) if reason.kind() == io::ErrorKind::NotFound => None,
            Err(reason) => {
                warnings.of_file("save file", || {
                    format!("the save file beside it is passed over: {reason}")
                });
                None
            }
        }
    }

    /// Reads a save file's text.
    pub fn parse(text: &str) -> SaveFile {
        let mut reader = Reader::default();
        text.lines().for_each(|line| reader.line(line.trim_end()));
        reader.file
    }
}

/// Reads the text of a regular file: reading a pipe could block, and reading a device might never
/// end.
fn read(path: &Path) -> io::Result<String> {
    if !fs::metadata(path)?.is_file() {
        return Err(io::Error::other("it is not a regular file"));
    }
    let mut bytes = vec![];
    File::open(path)?.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    let long = || io::Error::other(format!("it is longer than {} MiB", MAX_BYTES >> 20));
    if bytes.len() as u64 <= MAX_BYTES { Ok(decoded(&bytes)) } else { Err(long()) }
}

/// The state while a save file is read.
#[derive(Default)]
struct Reader {
    file: SaveFile,
    flags: u64,
    fraction_bits: u32,
    /// For each group around the line, whether it is closed; the outermost comes first.
    closed: Vec<bool>,
}

impl Reader {
    fn line(&mut self, line: &str) {
        match line.as_bytes().first() {
            Some(b'@') => self.begin(u64::from_str_radix(&line[1..], 16).unwrap_or(0)),
            Some(b'[') => self.fraction_bits = fraction_bits(line).unwrap_or(self.fraction_bits),
            Some(b'*') => self.file.marker = marker(line),
            Some(b'-') => self.group(),
            // Groups of bits (#), aliases (+) and translations (^) are GTKWave's own; a dump has no
            // such signals.
            None | Some(b'#' | b'+' | b'^') => {}
            Some(_) => self.signal(line),
        }
    }

    /// Sets the flags that hold for the lines that follow.
    fn begin(&mut self, flags: u64) {
        (self.flags, self.fraction_bits) = (flags, 0);
    }

    fn group(&mut self) {
        if self.flags & flag::GROUP_BEGIN != 0 {
            self.closed.push(self.flags & flag::CLOSED != 0);
        } else if self.flags & flag::GROUP_END != 0 {
            self.closed.pop();
        }
    }

    fn signal(&mut self, line: &str) {
        let visible = !self.closed.contains(&true);
        let name = without_range(line).to_owned();
        self.file.signals.push(SavedSignal { name, notation: self.notation(), visible });
    }

    fn notation(&self) -> Notation {
        let fraction_bits =
            if self.flags & flag::FIXED_POINT != 0 { self.fraction_bits } else { 0 };
        match self.flags {
            flags if flags & flag::SIGNED_DECIMAL != 0 => {
                Notation::Decimal { signed: true, fraction_bits }
            }
            flags if flags & flag::DECIMAL != 0 => {
                Notation::Decimal { signed: false, fraction_bits }
            }
            flags if flags & flag::BINARY != 0 => Notation::Binary,
            _ => Notation::Hexadecimal,
        }
    }
}

fn fraction_bits(line: &str) -> Option<u32> {
    line.strip_prefix("[fpshift_count] ")?.parse().ok().filter(|&bits| bits <= 1024)
}

/// The first marker, which stands behind the zoom; -1 stands for none.
fn marker(line: &str) -> Option<u64> {
    line.split_whitespace().nth(1)?.parse().ok()
}

/// The name without a range such as `[7:0]` at its end.
fn without_range(name: &str) -> &str {
    let Some((base, range)) = name.strip_suffix(']').and_then(|name| name.rsplit_once('[')) else {
        return name;
    };
    let is_range = range
        .split_once(':')
        .is_some_and(|(high, low)| high.parse::<i64>().is_ok() && low.parse::<i64>().is_ok());
    if is_range { base.trim_end() } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
[*] comment
[dumpfile] \"trace.vcd\"
*-4.58 552760 -1 -1
[treeopen] top.
@800200
-control
@28
top.valid
@1000200
-control
@c00200
-span
@800200
-inner
@40000420
[fpshift_count] 17
top.n_x[18:0]
@1000200
-inner
@1000200
-span
@24
top.red[7:0]
@22
top.mem[3]
";

    #[test]
    fn signals_have_their_formats() {
        let decimal = |signed, fraction_bits| Notation::Decimal { signed, fraction_bits };
        let expected = [
            ("top.valid", Notation::Binary, true),
            ("top.n_x", decimal(true, 17), false),
            ("top.red", decimal(false, 0), true),
            ("top.mem[3]", Notation::Hexadecimal, true),
        ];
        let expected = expected.map(|(name, notation, visible)| SavedSignal {
            name: name.to_owned(),
            notation,
            visible,
        });
        assert_eq!(
            SaveFile::parse(TEXT),
            SaveFile { signals: expected.to_vec(), marker: Some(552_760) }
        );
    }

    #[test]
    fn odd_lines_do_no_harm() {
        let text = "@zz\n@\n[fpshift_count] x\n[fpshift_count] 99999999999\n*\n*1\n*1 -1\n-\n@1000200\n-\n]\n[\nx]\n\u{e9}[1:0]\n";
        let names: Vec<String> =
            SaveFile::parse(text).signals.into_iter().map(|signal| signal.name).collect();
        assert_eq!(names, ["]", "x]", "\u{e9}"]);
        assert_eq!(SaveFile::parse("*1 -1"), SaveFile::default());
    }
}

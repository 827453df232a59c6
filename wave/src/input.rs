//! The source of a dump's bytes: a file, or a pipe whose bytes are kept in a temporary file, since
//! a dump is read more than once. A file that is compressed as a whole is unpacked.
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use flate2::read::MultiGzDecoder;
use tempfile::SpooledTempFile;

use super::warnings::Warnings;

/// The file name that stands for standard input.
pub const STANDARD_INPUT: &str = "-";

/// Largest number of bytes that are kept of a pipe or an unpacked file.
const MAX_BYTES: u64 = 1 << 30;
/// The number of these bytes that may be kept in memory.
const IN_MEMORY: usize = 16 << 20;
/// Bytes at the beginning of a file from which its kind is found.
const HEAD: u64 = 1 << 16;
/// How long a named pipe is waited for.
const PATIENCE: Duration = Duration::from_secs(5);

/// Kinds of dumps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Value change dump, IEEE 1364.
    Vcd,
    /// GTKWave's compressed format.
    Fst,
}

/// A dump's bytes, which can be read again.
pub trait Bytes: Read + Seek {}

impl<T: Read + Seek> Bytes for T {}

/// An opened dump.
pub struct Input {
    /// Its bytes, unpacked.
    pub bytes: Box<dyn Bytes>,
    /// Their format.
    pub format: Format,
}

/// The reason why there is nothing to read.
#[derive(Debug)]
pub enum InputError {
    /// The operating system's error.
    Unreadable(io::Error),
    /// The file is not a dump.
    Kind,
    /// The file begins as a dump, but later something is wrong.
    Damaged(String),
}

impl From<io::Error> for InputError {
    fn from(reason: io::Error) -> InputError {
        InputError::Unreadable(reason)
    }
}

impl Input {
    /// Opens the file, or standard input for `-`.
    ///
    /// # Errors
    /// [`InputError`] if it cannot be read, or is neither a VCD nor an FST file.
    pub fn open(path: &Path, warnings: &mut Warnings) -> Result<Input, InputError> {
        let bytes = if path == Path::new(STANDARD_INPUT) {
            buffered(io::stdin(), warnings)?
        } else if fs::metadata(path)?.is_file() {
            Box::new(File::open(path)?)
        } else if fs::metadata(path)?.is_dir() {
            return Err(io::Error::other("it is a folder").into());
        } else {
            buffered(open_pipe(path)?, warnings)?
        };
        unpacked(bytes, warnings)
    }
}

/// Opens what may be a named pipe, for which the operating system waits until a writer opens it.
fn open_pipe(path: &Path) -> io::Result<File> {
    let (sender, receiver) = mpsc::channel();
    let path: PathBuf = path.to_owned();
    // If no writer opens it, the thread waits until the program ends.
    thread::spawn(move || sender.send(File::open(path)));
    let nobody = || {
        io::Error::other(format!(
            "it is a pipe into which no program wrote for {} s",
            PATIENCE.as_secs()
        ))
    };
    receiver.recv_timeout(PATIENCE).map_err(|_| nobody())?
}

/// Keeps the bytes of a pipe if they can be a dump.
fn buffered(mut pipe: impl Read, warnings: &mut Warnings) -> Result<Box<dyn Bytes>, InputError> {
    let mut head = vec![];
    (&mut pipe).take(HEAD).read_to_end(&mut head)?;
    wrapping(&head)?;
    keep(head.chain(pipe), MAX_BYTES, warnings)
}

impl dyn Bytes {
    fn head(&mut self) -> io::Result<Vec<u8>> {
        let mut head = vec![];
        self.rewind()?;
        self.take(HEAD).read_to_end(&mut head)?;
        self.rewind()?;
        Ok(head)
    }
}

/// The compression of a file as a whole.
enum Wrapping {
    None(Format),
    /// Plain gzip.
    Gzip,
    /// The wrapper in which GHDL and nvc leave an FST file: a block with two lengths, then gzip.
    FstBlock,
}

/// Bytes before the compressed data of an FST wrapper: kind, length of the block, unpacked length.
const FST_WRAPPER: u64 = 1 + 8 + 8;
/// No compression in an FST file unpacks one byte to more bytes than this.
pub const BEST_COMPRESSION: u64 = 1100;

fn wrapping(head: &[u8]) -> Result<Wrapping, InputError> {
    const FST_HEADER: [u8; 9] = [0, 0, 0, 0, 0, 0, 0, 1, 73];
    const GZIP: [u8; 2] = [0x1f, 0x8b];
    match head {
        // The writer sets the length after it has compressed everything.
        [254, rest @ ..] if rest.len() >= 16 && rest[..8] == [0; 8] => {
            damaged("it is still being compressed")
        }
        [254, rest @ ..] if rest.get(16..18) == Some(&GZIP) => Ok(Wrapping::FstBlock),
        _ if head.starts_with(&FST_HEADER) => Ok(Wrapping::None(Format::Fst)),
        _ if head.starts_with(&GZIP) => Ok(Wrapping::Gzip),
        _ if is_vcd(head) => Ok(Wrapping::None(Format::Vcd)),
        _ => Err(InputError::Kind),
    }
}

/// Whether a file begins as VCD files do: with a section, or with one among its first words.
fn is_vcd(head: &[u8]) -> bool {
    const SECTIONS: [&str; 7] =
        ["$date", "$version", "$timescale", "$scope", "$var", "$comment", "$enddefinitions"];
    let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    let mut words = text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    words.any(|word| SECTIONS.iter().any(|section| word == section.as_bytes()))
}

fn damaged<T>(what: &str) -> Result<T, InputError> {
    Err(InputError::Damaged(what.to_owned()))
}

fn unpacked(mut bytes: Box<dyn Bytes>, warnings: &mut Warnings) -> Result<Input, InputError> {
    let head = bytes.head()?;
    let bytes = match wrapping(&head)? {
        Wrapping::None(format) => return Ok(Input { bytes, format }),
        Wrapping::Gzip => keep_unpacked(bytes, MAX_BYTES, warnings)?,
        Wrapping::FstBlock => unpack_whole(bytes, &head, warnings)?,
    };
    let mut bytes = bytes;
    match wrapping(&bytes.head()?)? {
        Wrapping::None(format) => Ok(Input { bytes, format }),
        _ => damaged("it is compressed more than once"),
    }
}

/// Unpacks an FST file that is compressed as a whole, after checking the lengths that it states.
fn unpack_whole(
    mut bytes: Box<dyn Bytes>,
    head: &[u8],
    warnings: &mut Warnings,
) -> Result<Box<dyn Bytes>, InputError> {
    let number =
        |at: usize| head[at..at + 8].iter().fold(0, |number, &byte| number << 8 | u64::from(byte));
    let (block, length) = (number(1), number(9));
    let there = bytes.seek(SeekFrom::End(0))?;
    if block.checked_add(1).is_none_or(|end| end < FST_WRAPPER || end > there) {
        return damaged("it is compressed as a whole, and its end is missing");
    }
    if length > there.saturating_mul(BEST_COMPRESSION).min(MAX_BYTES) {
        return damaged("it states a length that no file of its size can have");
    }
    bytes.seek(SeekFrom::Start(FST_WRAPPER))?;
    let packed = bytes.take(block + 1 - FST_WRAPPER);
    let mut unpacked = keep_unpacked(packed, length, warnings)?;
    if unpacked.seek(SeekFrom::End(0))? < length {
        damaged("what is compressed in it ends too early")
    } else {
        Ok(unpacked)
    }
}

/// Keeps at most `most` unpacked bytes, up to the place where the compressed data are damaged.
fn keep_unpacked(
    packed: impl Read,
    most: u64,
    warnings: &mut Warnings,
) -> Result<Box<dyn Bytes>, InputError> {
    let mut unpacker = MultiGzDecoder::new(packed);
    let mut first = [0];
    if !matches!(unpacker.read(&mut first), Ok(1)) {
        return damaged("what is compressed in it cannot be unpacked");
    }
    keep(io::Cursor::new(first).chain(unpacker), most, warnings)
}

/// Keeps at most `most` bytes.
fn keep(from: impl Read, most: u64, warnings: &mut Warnings) -> Result<Box<dyn Bytes>, InputError> {
    let mut kept = SpooledTempFile::new(IN_MEMORY);
    let (mut from, mut piece, mut length) = (from.take(most), vec![0; 1 << 16], 0);
    loop {
        match from.read(&mut piece) {
            Ok(0) => break,
            Ok(count) => {
                kept.write_all(&piece[..count])?;
                length += count as u64;
            }
            Err(reason) if reason.kind() == io::ErrorKind::Interrupted => {}
            // Compressed data are shown up to the place where they are damaged, as other files are.
            Err(_) => {
                warnings.of_file("packed", || {
                    "it cannot be read to its end, and is drawn up to there".to_owned()
                });
                break;
            }
        }
    }
    if length == MAX_BYTES {
        warnings.of_file("too long", || format!("only its first {} MiB are read", MAX_BYTES >> 20));
    }
    kept.rewind()?;
    Ok(Box::new(kept))
}

//! `.stl`, binary and text, through the `stl_io` crate.
//!
//! Its triangles share no vertices, so the caller joins them. The normals it states are left aside: they are those of the
//! faces, and many programs write zeros.
use std::io::{Cursor, Read, Seek, SeekFrom};

use glam::DVec3;
use stl_io::{Triangle, create_stl_reader};

use super::Mesh;
use super::error::{Located, MeshProblem};
use super::polygons::{Corner, Polygons};
use super::warning::Notices;

/// Bytes before the first triangle of a binary file: a comment of 80 bytes and the number of triangles.
const HEADER: usize = 84;

/// Bytes a triangle takes in a binary file.
const TRIANGLE: usize = 50;

/// Reads an `.stl` file.
///
/// # Errors
/// A file that is neither kind of `.stl`, ends early, or has a wrong line.
pub(super) fn parse(bytes: &[u8], notices: &mut Notices) -> Result<Mesh, Located> {
    let polygons = if is_text(bytes) { parse_text(bytes)? } else { parse_binary(bytes)? };
    polygons.welded().into_mesh(notices, &|_| None)
}

/// Whether a file is of the text kind: it starts with `solid` and its length is not what a binary header says, since some
/// programs start binary files with `solid` too.
fn is_text(bytes: &[u8]) -> bool {
    let binary_length = stated_triangles(bytes).and_then(binary_length);
    bytes.starts_with(b"solid") && binary_length != Some(bytes.len())
}

fn binary_length(triangles: usize) -> Option<usize> {
    triangles.checked_mul(TRIANGLE)?.checked_add(HEADER)
}

/// The number of triangles that a binary header states.
fn stated_triangles(bytes: &[u8]) -> Option<usize> {
    let count: [u8; 4] = bytes.get(HEADER - 4..HEADER)?.try_into().ok()?;
    Some(u32::from_le_bytes(count) as usize)
}

fn parse_binary(bytes: &[u8]) -> Result<Polygons, MeshProblem> {
    let short = || MeshProblem::Truncated(format!("a binary .stl has {HEADER} bytes before its first triangle"));
    let triangles = stated_triangles(bytes).ok_or_else(short)?;
    let needed = binary_length(triangles).unwrap_or(usize::MAX);
    if needed > bytes.len() {
        let text = format!("its header states {triangles} triangles, {needed} bytes; the file has {}", bytes.len());
        return Err(MeshProblem::Truncated(text));
    }
    // The comment is blanked so that the crate does not take `solid` in it for the text kind.
    let mut blanked = Cursor::new([0; HEADER - 4]).chain(&bytes[HEADER - 4..]);
    let mut whole = Vec::with_capacity(bytes.len());
    blanked.read_to_end(&mut whole).map_err(|e| MeshProblem::Unreadable(e.to_string()))?;
    collect(&mut Cursor::new(whole))
}

fn parse_text(bytes: &[u8]) -> Result<Polygons, Located> {
    let mut lines = LineByLine::new(bytes);
    collect(&mut lines).map_err(|problem| {
        let number = lines.line.max(1);
        quoting(problem, bytes, number).at_line(number)
    })
}

/// Adds the line to what is wrong with it, which the crate does not always do.
fn quoting(problem: MeshProblem, bytes: &[u8], number: usize) -> MeshProblem {
    let line = bytes.split(|b| *b == b'\n').nth(number - 1).unwrap_or_default();
    match problem {
        MeshProblem::Syntax(text) => {
            let start: String = String::from_utf8_lossy(line).trim().chars().take(60).collect();
            MeshProblem::Syntax(format!("{text}, in `{start}`"))
        }
        other => other,
    }
}

fn collect<R: Read + Seek>(source: &mut R) -> Result<Polygons, MeshProblem> {
    let problem = |error: std::io::Error| match error.kind() {
        std::io::ErrorKind::UnexpectedEof => MeshProblem::Truncated(error.to_string()),
        _ => MeshProblem::Syntax(error.to_string()),
    };
    let mut polygons = Polygons::default();
    for triangle in create_stl_reader(source).map_err(problem)? {
        push(&mut polygons, &triangle.map_err(problem)?);
    }
    Ok(polygons)
}

fn push(polygons: &mut Polygons, triangle: &Triangle) {
    // At most 2^30 bytes are read, at 50 bytes a triangle: indices fit.
    let first = polygons.positions.len() as u32;
    polygons.positions.extend(triangle.vertices.iter().map(|v| DVec3::from_array(v.0.map(f64::from))));
    polygons.push((first..first + 3).map(|vertex| Corner { vertex, normal: None }));
}

/// Hands out one line at a time, so that the line a parser is at is known although the parser does not tell.
///
/// A name is put after a bare `solid`, which the crate asks for and the format does not.
struct LineByLine<'a> {
    bytes: &'a [u8],
    position: usize,
    /// The line handed out last, counted from 1.
    line: usize,
    /// What is still to come of the name put in.
    inserted: &'static [u8],
}

impl<'a> LineByLine<'a> {
    fn new(bytes: &'a [u8]) -> LineByLine<'a> {
        LineByLine { bytes, position: 0, line: 0, inserted: b"" }
    }

    /// Bytes to the end of the current line, or of the word `solid` if a name has to follow it.
    fn rest_of_line(&self) -> &'a [u8] {
        let rest = &self.bytes[self.position..];
        if self.position == 0 && rest.get("solid".len()).is_none_or(|b| *b != b' ') {
            return &rest[.."solid".len().min(rest.len())];
        }
        let end = rest.iter().position(|b| *b == b'\n').map_or(rest.len(), |at| at + 1);
        &rest[..end]
    }
}

impl Read for LineByLine<'_> {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        if !self.inserted.is_empty() {
            return self.inserted.read(out);
        }
        let line = self.rest_of_line();
        let starts = self.position == 0 || self.bytes[self.position - 1] == b'\n';
        self.line += usize::from(starts && !line.is_empty());
        let read = (&mut &*line).read(out)?;
        self.position += read;
        if line == b"solid" {
            self.inserted = b" ";
        }
        Ok(read)
    }
}

impl Seek for LineByLine<'_> {
    fn seek(&mut self, to: SeekFrom) -> std::io::Result<u64> {
        match to {
            SeekFrom::Start(0) => *self = LineByLine::new(self.bytes),
            _ => return Err(std::io::Error::other("only the start can be gone back to")),
        }
        Ok(0)
    }
}

//! `.stl`, binary and text.
//!
//! The triangles share no vertices, so vertices at the same place are joined. The stated normals
//! are ignored: they are those of the faces, and many programs write zeros. The `stl_io` crate is
//! not used: it reads only one `solid` of a text, in lower case
//! (docs/decisions/0015-stl-files-are-read-by-our-own-code.md).
use glam::DVec3;

use super::error::{Located, MeshProblem};
use super::indexed::Mesh;
use super::limits::FARTHEST;
use super::lines::{Lines, is_blank, words};
use super::number::number;
use super::polygons::{Corner, Polygons};
use super::text::unmarked;
use super::warning::{Notices, quoted};

/// Bytes before the first triangle of a binary file: a comment of 80 bytes and the number of
/// triangles.
const HEADER: usize = 84;

/// Bytes of a triangle in a binary file: normal and three vertices of three floats each, and two
/// bytes for any purpose.
const TRIANGLE: usize = 50;

/// Bytes at the start of a file by which text is distinguished from binary.
const BEGINNING: usize = 1024;

/// Reads an `.stl` file.
///
/// # Errors
/// A file that is neither kind of `.stl`, ends early, or has a wrong line.
pub(super) fn parse(bytes: &[u8], notices: &mut Notices) -> Result<Mesh, Located> {
    let text = unmarked(bytes);
    let polygons = if !is_whole_binary(bytes) && is_text(&text) {
        Text::new(&text, notices).read()?
    } else {
        parse_binary(bytes, notices)?
    };
    polygons.welded().into_mesh(notices, &|_| None)
}

/// Whether the triangles that a binary header states fit into the file. For a text of allowed
/// length, they never do.
fn is_whole_binary(bytes: &[u8]) -> bool {
    stated_triangles(bytes).and_then(binary_length).is_some_and(|length| length <= bytes.len())
}

/// Whether a file looks like text: it has no zeros at its beginning, and a line that opens a solid
/// or a facet.
fn is_text(text: &[u8]) -> bool {
    // Some programs pad a text with zeros.
    let end = text.iter().rposition(|byte| !is_blank(byte)).map_or(0, |last| last + 1);
    let opens =
        |line: &[u8]| words(line).next().is_some_and(|word| is(word, "solid") || is(word, "facet"));
    !text[..end.min(BEGINNING)].contains(&0) && Lines::new(text).any(opens)
}

fn binary_length(triangles: usize) -> Option<usize> {
    triangles.checked_mul(TRIANGLE)?.checked_add(HEADER)
}

/// The number of triangles that a binary header states.
fn stated_triangles(bytes: &[u8]) -> Option<usize> {
    let count: [u8; 4] = bytes.get(HEADER - 4..HEADER)?.try_into().ok()?;
    Some(u32::from_le_bytes(count) as usize)
}

fn parse_binary(bytes: &[u8], notices: &mut Notices) -> Result<Polygons, MeshProblem> {
    let short = || {
        MeshProblem::Truncated(format!(
            "a binary .stl has {HEADER} bytes before its first triangle"
        ))
    };
    let triangles = stated_triangles(bytes).ok_or_else(short)?;
    let needed = binary_length(triangles).unwrap_or(usize::MAX);
    let Some(content) = bytes.get(HEADER..needed) else {
        let text = format!(
            "its header states {triangles} triangles, {needed} bytes; the file has {}",
            bytes.len()
        );
        return Err(MeshProblem::Truncated(text));
    };
    if triangles == 0 && bytes.len() >= needed + TRIANGLE {
        return Err(MeshProblem::Syntax(format!(
            "its header states 0 triangles, but {} bytes follow",
            bytes.len() - needed
        )));
    }
    if bytes.len() > needed {
        let text =
            || format!("{} bytes behind the last triangle are passed over", bytes.len() - needed);
        notices.add("bytes behind the end", None, text);
    }
    let mut polygons = Polygons::default();
    for triangle in content.as_chunks::<TRIANGLE>().0 {
        // The first of four vectors is the normal.
        let vectors = triangle.as_chunks::<4>().0.as_chunks::<3>().0;
        let vertices = vectors[1..4]
            .iter()
            .map(|v| DVec3::from_array(v.map(|x| f64::from(f32::from_le_bytes(x)))));
        push(&mut polygons, vertices);
    }
    Ok(polygons)
}

/// Adds a face with vertices of its own.
fn push(polygons: &mut Polygons, vertices: impl IntoIterator<Item = DVec3>) {
    // At most 2^30 bytes are read, and a vertex takes at least 12 of them, so indices fit.
    let first = polygons.positions.len() as u32;
    polygons.positions.extend(vertices);
    let end = polygons.positions.len() as u32;
    polygons.push((first..end).map(|vertex| Corner { vertex, normal: None }));
}

/// A text that is read word by word: `solid`, `facet normal x y z`, `outer loop`, three times
/// `vertex x y z`, `endloop`, `endfacet`, and so on to `endsolid`, in lower or upper case, and
/// repeated for each solid.
struct Text<'a> {
    rest: &'a [u8],
    /// The line that `rest` starts in, counted from 1.
    line: usize,
    notices: &'a mut Notices,
    polygons: Polygons,
}

impl<'a> Text<'a> {
    fn new(text: &'a [u8], notices: &'a mut Notices) -> Text<'a> {
        Text { rest: text, line: 1, notices, polygons: Polygons::default() }
    }

    fn read(mut self) -> Result<Polygons, Located> {
        let mut is_open = false;
        // The last unknown word since a facet ended, which may be meant to start another.
        let mut unknown = None;
        while let Some(word) = self.word() {
            match keyword(word) {
                Some(word @ ("solid" | "endsolid")) => {
                    is_open = word == "solid";
                    self.skip_name();
                }
                Some("facet") => {
                    self.facet()?;
                    unknown = None;
                }
                Some(_) => return Err(self.unexpected("`facet` or `endsolid`", Some(word))),
                None => {
                    unknown = Some(self.unexpected("`facet` or `endsolid`", Some(word)));
                    self.pass_over(word);
                }
            }
        }
        match unknown.filter(|_| is_open) {
            Some(wrong) => return Err(wrong),
            None if is_open => self.notices.add("no end", Some(self.line), || {
                "the last solid has no `endsolid`; the file may be cut off".into()
            }),
            None => {}
        }
        Ok(self.polygons)
    }

    /// Reads a facet after the word `facet`, to its end.
    fn facet(&mut self) -> Result<(), Located> {
        let line = self.line;
        self.skip_normal();
        self.expect("outer")?;
        self.expect("loop")?;
        let vertices = self.vertices()?;
        self.expect("endfacet")?;
        if vertices.len() < 3 {
            let text = || {
                format!("a facet has {} vertices, fewer than three; it is left out", vertices.len())
            };
            self.notices.add("short facet", Some(line), text);
        }
        push(&mut self.polygons, vertices);
        Ok(())
    }

    /// Reads the vertices of a facet, to the end of its loop.
    fn vertices(&mut self) -> Result<Vec<DVec3>, Located> {
        let mut vertices = Vec::with_capacity(3);
        // An unknown word that may be meant as what is missing: a vertex, or the end of the loop.
        let mut unknown = None;
        loop {
            let word = self.word();
            let wanted = if vertices.len() < 3 { "`vertex`" } else { "`endloop`" };
            match (word.and_then(keyword), word) {
                (Some("vertex"), _) => vertices.push(self.vertex()?),
                (Some("endloop"), _) => break,
                (None, Some(word)) if !vertices.is_empty() && number(word).is_some() => {
                    let text = || "numbers behind a vertex's third are passed over".into();
                    self.notices.add("fourth number", Some(self.line), text);
                }
                (None, Some(word)) => {
                    if unknown.is_none() || vertices.len() >= 3 {
                        unknown = Some(self.unexpected(wanted, Some(word)));
                    }
                    self.pass_over(word);
                }
                _ => return Err(unknown.unwrap_or_else(|| self.unexpected(wanted, word))),
            }
        }
        match unknown {
            Some(wrong) if vertices.len() < 3 => Err(wrong),
            _ => Ok(vertices),
        }
    }

    /// Skips `normal` and the words for its numbers, whatever they are.
    fn skip_normal(&mut self) {
        let mut ahead = (self.rest, self.line);
        for _ in 0..4 {
            match self.word().and_then(keyword) {
                Some("normal") | None => ahead = (self.rest, self.line),
                Some(_) => break,
            }
        }
        (self.rest, self.line) = ahead;
    }

    fn vertex(&mut self) -> Result<DVec3, Located> {
        let mut coordinate = || {
            let word = self.word();
            let value = word.and_then(number).filter(|x| x.abs() <= FARTHEST);
            value.ok_or_else(|| self.unexpected("a finite number", word))
        };
        Ok(DVec3::new(coordinate()?, coordinate()?, coordinate()?))
    }

    /// Advances to a word; words that are not keywords are skipped.
    fn expect(&mut self, wanted: &str) -> Result<(), Located> {
        let quoted = format!("`{wanted}`");
        let mut unknown = None;
        loop {
            let word = self.word();
            match word {
                Some(word) if is(word, wanted) => return Ok(()),
                Some(word) if keyword(word).is_none() => {
                    unknown = Some(self.unexpected(&quoted, Some(word)));
                    self.pass_over(word);
                }
                _ => return Err(unknown.unwrap_or_else(|| self.unexpected(&quoted, word))),
            }
        }
    }

    /// Skips the line of an unknown word; if it is a number, only the number.
    fn pass_over(&mut self, word: &[u8]) {
        if number(word).is_some() {
            let text = || format!("the number {} is passed over", quoted(word));
            return self.notices.add("number", Some(self.line), text);
        }
        let text = || {
            format!("{} is none of the words of a text .stl; its line is passed over", quoted(word))
        };
        self.notices.add("unknown word", Some(self.line), text);
        self.skip_line();
    }

    fn unexpected(&self, wanted: &str, word: Option<&[u8]>) -> Located {
        let problem = match word {
            Some(word) => {
                MeshProblem::Syntax(format!("{wanted} is expected here, not {}", quoted(word)))
            }
            None => MeshProblem::Truncated(format!("{wanted} is expected here")),
        };
        problem.at_line(self.line)
    }

    /// The next word. At the end of the text, `line` stays that of the last word.
    fn word(&mut self) -> Option<&'a [u8]> {
        let start = self.rest.iter().position(|b| !is_blank(b))?;
        let (blanks, rest) = self.rest.split_at(start);
        // A CR before an LF does not end a line: the LF does.
        let ends = |k: &usize| {
            blanks[*k] == b'\n' || blanks[*k] == b'\r' && blanks.get(k + 1) != Some(&b'\n')
        };
        self.line += (0..start).filter(ends).count();
        let length = rest.iter().position(is_blank).unwrap_or(rest.len());
        let (word, behind) = rest.split_at(length);
        self.rest = behind;
        Some(word)
    }

    /// Skips a solid's name, which may be anything, to the end of the line or to where the line
    /// opens a facet.
    fn skip_name(&mut self) {
        let line = Lines::new(self.rest).next().unwrap_or_default();
        let opens_facet = |at: &usize| {
            let mut words = words(&line[*at..]);
            words.next().is_some_and(|word| is(word, "facet"))
                && words.next().is_some_and(|word| is(word, "normal"))
        };
        let ends = (0..line.len()).filter(|&at| is_blank(&line[at])).find(opens_facet);
        self.rest = &self.rest[ends.unwrap_or(line.len())..];
    }

    fn skip_line(&mut self) {
        let line = Lines::new(self.rest).next().unwrap_or_default();
        self.rest = &self.rest[line.len()..];
    }
}

/// The keywords of a text.
const KEYWORDS: [&str; 9] =
    ["solid", "facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet", "endsolid"];

/// The keyword that a word is, in lower or upper case.
fn keyword(word: &[u8]) -> Option<&'static str> {
    KEYWORDS.into_iter().find(|known| is(word, known))
}

fn is(word: &[u8], known: &str) -> bool {
    word.eq_ignore_ascii_case(known.as_bytes())
}

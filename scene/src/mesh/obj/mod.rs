//! Wavefront `.obj`: the lines `v`, `vn`, `f`, `mtllib` and `usemtl`. Other lines about the
//! appearance or grouping of faces (texture, groups) are ignored; geometry other than faces (lines,
//! points, curves) is skipped with a warning.
//!
//! The `tobj` crate is not used: its errors do not state the line, it reads polylines (`l`) as
//! faces, gives a corner without normal its neighbour's, and overflows on texture indices far below
//! zero.
mod materials;
mod mtl;

use std::borrow::Cow;

use glam::DVec3;

use materials::Materials;

use super::Beside;
use super::error::{Item, Located, MeshProblem};
use super::indexed::Mesh;
use super::lines::{Lines, is_blank, words};
use super::number::number;
use super::polygons::{Corner, Polygons};
use super::text::unmarked;
use super::warning::{Notices, quoted};

/// Keywords of what is drawn; before version 3, faces were called `fo`.
const DRAWN: [&[u8]; 4] = [b"v", b"vn", b"f", b"fo"];

/// Keywords of lines that state names, in `.obj` files and in material libraries; names may contain
/// a `#`.
const NAMED: [&[u8]; 3] = [b"usemtl", b"mtllib", b"newmtl"];

/// Keywords of lines that are ignored without a warning.
const SKIPPED: [&[u8]; 17] = [
    b"vt",
    b"g",
    b"o",
    b"s",
    b"mg",
    b"usemap",
    b"maplib",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"shadow_obj",
    b"trace_obj",
    b"vp",
    b"cstype",
    b"deg",
    b"end",
];

/// Reads an `.obj` file, with its material libraries from `beside` it.
///
/// # Errors
/// Malformed lines, and all errors of [`Polygons::into_mesh`].
pub(super) fn parse(
    bytes: &[u8],
    beside: &Beside<'_>,
    notices: &mut Notices,
) -> Result<Mesh, Located> {
    let text = unmarked(bytes);
    let mut reader = Reader {
        notices,
        polygons: Polygons::default(),
        line_numbers: LineNumbers::default(),
        materials: Materials::default(),
    };
    for (number, line) in joined_lines(&text) {
        reader.line(number, &line).map_err(|problem| problem.at_line(number))?;
    }
    let Reader { mut polygons, line_numbers, materials, notices } = reader;
    polygons.materials = materials.found(beside, notices);
    let mesh = polygons.into_mesh(notices, &|item| line_numbers.of(item));
    mesh.map_err(|at| Located { problem: as_counted_here(at.problem), ..at })
}

/// Lines without their comments, each with its number, counted from 1; a line that ends in a
/// backslash continues in the next.
fn joined_lines(text: &[u8]) -> impl Iterator<Item = (usize, Cow<'_, [u8]>)> {
    let plain = |line| named_line(without_mark(line));
    let mut numbered = Lines::new(text).map(plain).enumerate().peekable();
    std::iter::from_fn(move || {
        let (index, line) = numbered.next()?;
        let Some(first) = continued(line) else { return Some((index + 1, Cow::Borrowed(line))) };
        let mut joined = first.to_vec();
        // A name may itself end in a backslash; then the next line is separate.
        while let Some((_, next)) = numbered.next_if(|(_, next)| !has_keyword(next)) {
            joined.push(b' ');
            let goes_on = continued(next);
            joined.extend_from_slice(goes_on.unwrap_or(next));
            if goes_on.is_none() {
                break;
            }
        }
        Some((index + 1, Cow::Owned(joined)))
    })
}

/// A line without a byte order mark at its start, which remains where files were concatenated.
fn without_mark(line: &[u8]) -> &[u8] {
    line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line)
}

/// A line without its comment, which a `#` starts: anywhere, but not within a name.
fn named_line(line: &[u8]) -> &[u8] {
    let has_name = words(line).next().is_some_and(|keyword| NAMED.contains(&keyword));
    let starts = |at: &usize| line[*at] == b'#' && (!has_name || is_blank(&line[*at - 1]));
    (0..line.len()).find(starts).map_or(line, |at| &line[..at])
}

/// A name as it is compared: without blanks around it, and without backslashes at its end, which may
/// stand for a continuation.
fn name(text: &[u8]) -> &[u8] {
    let around = |b: &u8| is_blank(b) || *b == b'\\';
    let end = text.iter().rposition(|b| !around(b)).map_or(0, |last| last + 1);
    let start = text[..end].iter().position(|b| !is_blank(b)).unwrap_or(end);
    &text[start..end]
}

/// A line without the backslash at its end, if it has one.
fn continued(line: &[u8]) -> Option<&[u8]> {
    let end = line.iter().rposition(|b| !is_blank(b))?;
    (line[end] == b'\\').then_some(&line[..end])
}

/// Whether a line starts with a keyword.
fn has_keyword(line: &[u8]) -> bool {
    words(line).next().is_none_or(|word| {
        word == b"l" || [&DRAWN[..], &NAMED, &SKIPPED].iter().any(|all| all.contains(&word))
    })
}

/// The line numbers of vertices, normals and faces.
#[derive(Default)]
struct LineNumbers {
    vertices: Vec<usize>,
    normals: Vec<usize>,
    faces: Vec<usize>,
}

impl LineNumbers {
    fn of(&self, item: Item) -> Option<usize> {
        let line = match item {
            Item::Vertex(index) => self.vertices.get(index),
            Item::Normal(index) => self.normals.get(index),
            Item::Face(index) => self.faces.get(index),
        };
        line.copied()
    }
}

/// The problem with indices counted from 1, as in the file.
fn as_counted_here(problem: MeshProblem) -> MeshProblem {
    match problem {
        MeshProblem::Index { what, index, count, .. } => syntax(format!(
            "the face names {what} {}; the last one is {count}",
            u64::from(index) + 1
        )),
        other => other,
    }
}

struct Reader<'n> {
    notices: &'n mut Notices,
    polygons: Polygons,
    line_numbers: LineNumbers,
    materials: Materials,
}

impl Reader<'_> {
    fn line(&mut self, number: usize, line: &[u8]) -> Result<(), MeshProblem> {
        let mut words = words(line);
        match words.next() {
            Some(b"v") => {
                self.polygons.positions.push(position(words)?);
                self.line_numbers.vertices.push(number);
            }
            Some(b"vn") => {
                self.polygons.normals.push(normal(words));
                self.line_numbers.normals.push(number);
            }
            Some(b"f" | b"fo") => self.face(number, words)?,
            Some(b"usemtl") => {
                self.polygons.material = self.materials.number(number, name(words.rest()))
            }
            Some(b"mtllib") => self.materials.library(number, name(words.rest())),
            Some(keyword) if !SKIPPED.contains(&keyword) => self.pass_over(number, keyword),
            _ => {}
        }
        Ok(())
    }

    fn face<'w>(
        &mut self,
        number: usize,
        words: impl Iterator<Item = &'w [u8]>,
    ) -> Result<(), MeshProblem> {
        let counts = (self.polygons.positions.len(), self.polygons.normals.len());
        let corners = words.map(|word| corner(word, counts)).collect::<Result<Vec<Corner>, _>>()?;
        if corners.len() < 3 {
            let text = || {
                format!("a face has fewer than three corners: {}; it is left out", corners.len())
            };
            self.notices.add("short face", Some(number), text);
            return Ok(());
        }
        self.polygons.push(corners);
        self.line_numbers.faces.push(number);
        Ok(())
    }

    fn pass_over(&mut self, number: usize, keyword: &[u8]) {
        let what = quoted(keyword);
        self.notices.add(&what, Some(number), || {
            format!("lines {what} are passed over; only `v`, `vn` and `f` are drawn")
        });
    }
}

fn syntax(text: String) -> MeshProblem {
    MeshProblem::Syntax(text)
}

/// The first three numbers of a line; a weight or colours after them are skipped.
fn position<'w>(mut words: impl Iterator<Item = &'w [u8]>) -> Result<DVec3, MeshProblem> {
    let mut component = || {
        let word = words
            .next()
            .ok_or_else(|| syntax("three numbers are needed here, the line ends early".into()))?;
        number(word).ok_or_else(|| syntax(format!("{} is not a number", quoted(word))))
    };
    Ok(DVec3::new(component()?, component()?, component()?))
}

/// A normal. A word that is not a number makes a normal without direction, which does no harm if no
/// corner names it.
fn normal<'w>(mut words: impl Iterator<Item = &'w [u8]>) -> DVec3 {
    let mut component = || words.next().and_then(number).unwrap_or(f64::NAN);
    DVec3::new(component(), component(), component())
}

/// A corner, `vertex`, `vertex/texture`, `vertex/texture/normal` or `vertex//normal`; texture
/// indices are ignored.
fn corner(word: &[u8], (vertices, normals): (usize, usize)) -> Result<Corner, MeshProblem> {
    let mut parts = word.split(|&b| b == b'/');
    let (vertex, _texture, normal) = (parts.next().unwrap_or_default(), parts.next(), parts.next());
    if parts.next().is_some() {
        return Err(syntax(format!(
            "{} is not a corner: at most vertex/texture/normal",
            quoted(word)
        )));
    }
    let normal = normal
        .filter(|text| !text.is_empty())
        .map(|text| normal_index(text, normals))
        .transpose()?;
    Ok(Corner { vertex: vertex_index(vertex, vertices)?, normal })
}

/// An index counted from 0, made from one counted from 1 or, if negative, counted back from the
/// last.
fn vertex_index(text: &[u8], count: usize) -> Result<u32, MeshProblem> {
    let wrong = |why: &str| syntax(format!("{} is not an index: {why}", quoted(text)));
    let index = index(text).ok_or_else(|| wrong("it is not a whole number"))?;
    if index == 0 {
        return Err(wrong("indices count from 1"));
    }
    from_zero(index, count).ok_or_else(|| wrong("nothing is there"))
}

/// An index of a normal, converted as by [`vertex_index`]; one that leads nowhere becomes an index
/// that no normal has.
fn normal_index(text: &[u8], count: usize) -> Result<u32, MeshProblem> {
    let index = index(text)
        .ok_or_else(|| syntax(format!("{} is not an index of a normal", quoted(text))))?;
    Ok(from_zero(index, count).unwrap_or(u32::MAX))
}

fn index(text: &[u8]) -> Option<i64> {
    std::str::from_utf8(text).ok()?.parse().ok()
}

fn from_zero(index: i64, count: usize) -> Option<u32> {
    // Counts are lengths of vectors, far below the largest i64.
    let from_zero = if index > 0 { index - 1 } else { (count as i64).saturating_add(index) };
    u32::try_from(from_zero).ok().filter(|_| index != 0)
}

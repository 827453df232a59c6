//! Wavefront `.obj`: the lines `v`, `vn` and `f`; everything else (texture, groups, materials, lines, points) is skipped.
//!
//! Read here and not by the `tobj` crate, whose errors do not know their line, which takes polylines (`l`) for faces,
//! gives a corner without normal its neighbour's, and overflows on texture indices far below zero.
use std::str::SplitWhitespace;

use glam::DVec3;

use super::Mesh;
use super::error::{Item, Located, MeshProblem};
use super::polygons::{Corner, Polygons};
use super::warning::{Notices, quoted};

/// Reads an `.obj` file.
///
/// # Errors
/// Text that is not UTF-8, lines that are not as the format has them, and all that [`Polygons::into_mesh`] finds.
pub(super) fn parse(bytes: &[u8], notices: &mut Notices) -> Result<Mesh, Located> {
    let text = std::str::from_utf8(bytes).map_err(|error| not_text(bytes, error.valid_up_to()))?;
    let mut reader = Reader { notices, polygons: Polygons::default(), lines: Lines::default() };
    for (index, line) in text.lines().enumerate() {
        reader.line(index + 1, line).map_err(|problem| problem.at_line(index + 1))?;
    }
    let Reader { polygons, lines, notices } = reader;
    let mesh = polygons.into_mesh(notices, &|item| lines.of(item));
    mesh.map_err(|at| Located { problem: as_counted_here(at.problem), ..at })
}

/// Says which line the first byte that is no UTF-8 is on.
fn not_text(bytes: &[u8], at: usize) -> Located {
    let lines_before = bytes[..at].iter().filter(|byte| **byte == b'\n').count();
    MeshProblem::NotText(at).at_line(lines_before + 1)
}

/// The lines that vertices, normals and faces stand on.
#[derive(Default)]
struct Lines {
    vertices: Vec<usize>,
    normals: Vec<usize>,
    faces: Vec<usize>,
}

impl Lines {
    fn of(&self, item: Item) -> Option<usize> {
        let line = match item {
            Item::Vertex(index) => self.vertices.get(index),
            Item::Normal(index) => self.normals.get(index),
            Item::Face(index) => self.faces.get(index),
        };
        line.copied()
    }
}

/// The same problem with indices from 1, as the file has them.
fn as_counted_here(problem: MeshProblem) -> MeshProblem {
    match problem {
        MeshProblem::Index { what, index, count, .. } => {
            syntax(format!("the face names {what} {}; the last one is {count}", u64::from(index) + 1))
        }
        other => other,
    }
}

struct Reader<'n> {
    notices: &'n mut Notices,
    polygons: Polygons,
    lines: Lines,
}

impl Reader<'_> {
    fn line(&mut self, number: usize, line: &str) -> Result<(), MeshProblem> {
        // A `#` starts a comment anywhere.
        let content = line.split('#').next().unwrap_or_default();
        let mut words = content.split_whitespace();
        match words.next() {
            Some("v") => {
                self.polygons.positions.push(vector(words)?);
                self.lines.vertices.push(number);
            }
            Some("vn") => {
                self.polygons.normals.push(vector(words)?);
                self.lines.normals.push(number);
            }
            Some("f") => self.face(number, words)?,
            _ => {}
        }
        Ok(())
    }

    fn face(&mut self, number: usize, words: SplitWhitespace<'_>) -> Result<(), MeshProblem> {
        let counts = (self.polygons.positions.len(), self.polygons.normals.len());
        let corners = words.map(|word| corner(word, counts)).collect::<Result<Vec<Corner>, _>>()?;
        if corners.len() < 3 {
            let text = || format!("a face has fewer than three corners: {}; it is left out", corners.len());
            self.notices.add("short face", Some(number), text);
            return Ok(());
        }
        self.polygons.push(corners);
        self.lines.faces.push(number);
        Ok(())
    }
}

fn syntax(text: String) -> MeshProblem {
    MeshProblem::Syntax(text)
}

/// The first three numbers of a line; a weight or colours after them are skipped.
fn vector(mut words: SplitWhitespace<'_>) -> Result<DVec3, MeshProblem> {
    let mut component = || {
        let word = words.next().ok_or_else(|| syntax("three numbers are needed here, the line ends early".into()))?;
        word.parse::<f64>().map_err(|_| syntax(format!("{} is not a number", quoted(word.as_bytes()))))
    };
    Ok(DVec3::new(component()?, component()?, component()?))
}

/// A corner, `vertex`, `vertex/texture`, `vertex/texture/normal` or `vertex//normal`; texture indices are not looked at.
fn corner(word: &str, (vertices, normals): (usize, usize)) -> Result<Corner, MeshProblem> {
    let mut parts = word.split('/');
    let (vertex, _texture, normal) = (parts.next().unwrap_or_default(), parts.next(), parts.next());
    if parts.next().is_some() {
        return Err(syntax(format!("{} is not a corner: at most vertex/texture/normal", quoted(word.as_bytes()))));
    }
    let normal = normal.filter(|text| !text.is_empty()).map(|text| index(text, normals)).transpose()?;
    Ok(Corner { vertex: index(vertex, vertices)?, normal })
}

/// An index counted from 0, from one counted from 1, or counted back from the last with a minus sign.
fn index(text: &str, count: usize) -> Result<u32, MeshProblem> {
    let wrong = |why: &str| syntax(format!("{} is not an index: {why}", quoted(text.as_bytes())));
    let number: i64 = text.parse().map_err(|_| wrong("it is not a whole number"))?;
    let from_zero = match number {
        0 => return Err(wrong("indices count from 1")),
        1.. => number - 1,
        // Counts are lengths of vectors, far below i64's end.
        _ => (count as i64).saturating_add(number),
    };
    u32::try_from(from_zero).map_err(|_| wrong("nothing is there"))
}

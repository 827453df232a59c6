//! Errors in meshes.
use std::path::Path;

use thiserror::Error;

use super::limits::{self, EXTENSIONS, FARTHEST, LONGEST_FILE, MAX_TRIANGLES};
use super::triangulate::MAX_CROSSINGS;

/// What is wrong with a mesh, without saying where.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MeshProblem {
    /// The file cannot be opened or read; contains the system's reason.
    #[error("it cannot be read: {0}")]
    Unreadable(String),
    /// The path names a folder, pipe or device.
    #[error("it is not a regular file")]
    NotAFile,
    /// The file is too long; contains its length in bytes.
    #[error("it is {0} bytes long; files up to {limit} bytes are read", limit = LONGEST_FILE)]
    TooLong(u64),
    /// The file's extension is not that of a mesh.
    #[error("its extension is not that of a mesh")]
    Extension,
    /// The file does not follow its format.
    #[error("{0}")]
    Syntax(String),
    /// The file ends early.
    #[error("it ends early: {0}")]
    Truncated(String),
    /// The file uses a part of the format that is not supported.
    #[error("it uses {0}, which is not read")]
    Unsupported(String),
    /// A number is not finite, or beyond [`FARTHEST`].
    #[error("{what} {index} (counted from 0) has the coordinate {value:?}")]
    Coordinate {
        /// `vertex` or `normal`.
        what: &'static str,
        /// Counted from 0.
        index: usize,
        /// The offending number.
        value: f64,
    },
    /// A face names a vertex or normal that does not exist.
    #[error("face {face} names {what} {}, but there are only {count} (all counted from 0)", shown(*index))]
    Index {
        /// The face, counted from 0.
        face: usize,
        /// `vertex` or `normal`.
        what: &'static str,
        /// The index that it names, counted from 0; `u32::MAX` for an index below 0.
        index: u32,
        /// How many exist.
        count: usize,
    },
    /// A polygon has too many crossings to be split into triangles.
    #[error(
        "face {face} (counted from 0), a polygon of {corners} corners, crosses or covers itself too often; \
         all faces of a file together may do so {limit} times",
        limit = MAX_CROSSINGS
    )]
    Tangled {
        /// The face, counted from 0.
        face: usize,
        /// Its number of corners.
        corners: usize,
    },
    /// The file contains nothing with an area.
    #[error("it has no triangles with an area")]
    Empty,
    /// The mesh has too many triangles; contains the number.
    #[error("it has {0} triangles; at most {limit} are taken", limit = MAX_TRIANGLES)]
    TooManyTriangles(usize),
}

impl MeshProblem {
    /// What would be right.
    fn help(&self) -> String {
        match self {
            MeshProblem::Unreadable(_) => "check the path; a mesh named in a scene file is looked for beside that file".into(),
            MeshProblem::NotAFile => "name a file that ends in .obj, .ply, .stl or .glb".into(),
            MeshProblem::TooLong(_) | MeshProblem::TooManyTriangles(_) => "simplify the mesh with a mesh tool first".into(),
            MeshProblem::Extension => format!("readable are {}; convert the mesh to one of them", listed(&EXTENSIONS)),
            MeshProblem::Syntax(_) => "the file is damaged, or of another format than its extension says".into(),
            MeshProblem::Truncated(_) => "the file was cut off, or its header is damaged; fetch or export it again".into(),
            MeshProblem::Unsupported(_) => "export the mesh as plain triangles, uncompressed, in one file".into(),
            MeshProblem::Coordinate { .. } => {
                format!("coordinates are finite numbers from -{0:e} to {0:e}", FARTHEST)
            }
            MeshProblem::Index { .. } => "every face may name only what the file defines; export the mesh again".into(),
            MeshProblem::Tangled { .. } => "faces go around their outline once; export the mesh again, as triangles".into(),
            MeshProblem::Empty => {
                "a mesh needs at least one triangle whose corners are not on one line; points and lines are not drawn".into()
            }
        }
    }
}

/// An index as text for an error.
fn shown(index: u32) -> String {
    if index == u32::MAX { "below 0".to_owned() } else { index.to_string() }
}

/// Names in backquotes, separated by commas.
pub(crate) fn listed(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    quoted.join(", ")
}

/// What is wrong with a mesh, and where.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{place}: {problem}")]
pub struct MeshError {
    place: String,
    /// The file's extension, if it is that of a mesh.
    extension: Option<&'static str>,
    /// What is wrong.
    pub problem: MeshProblem,
}

impl MeshError {
    /// An error in the file `path`, at `line` (counted from 1) where one is known.
    pub fn new(path: &Path, line: Option<usize>, problem: MeshProblem) -> MeshError {
        let place = match line {
            Some(line) => format!("mesh `{}`, line {line}", path.display()),
            None => format!("mesh `{}`", path.display()),
        };
        MeshError { place, extension: limits::extension(path), problem }
    }

    /// What would be right.
    pub fn help(&self) -> String {
        match (&self.problem, self.extension.and_then(shape)) {
            (MeshProblem::Syntax(_), Some(shape)) => shape.to_owned(),
            _ => self.problem.help(),
        }
    }
}

/// A description of a file with `extension`.
fn shape(extension: &str) -> Option<&'static str> {
    match extension {
        "obj" => Some(
            "lines are `v x y z`, `vn x y z` and `f a b c`, where a corner is vertex, vertex/texture, vertex//normal or \
             vertex/texture/normal; indices count from 1, or back from the last with a minus sign",
        ),
        "ply" => Some(
            "the header has an element `vertex` with the numbers x, y, z and an element `face` with the list of integers \
             `vertex_indices`; the vertices and faces follow, in a text file one a line",
        ),
        "stl" => Some(
            "a text .stl is `solid name`, triangles, `endsolid`; a triangle is the lines `facet normal x y z`, `outer loop`, \
             three times `vertex x y z`, `endloop`, `endfacet`; a binary one is 80 bytes, the number of triangles in 4, and \
             50 for each",
        ),
        "glb" => Some(
            "a .glb is binary glTF 2.0 with uncompressed geometry inside; export the mesh again",
        ),
        _ => None,
    }
}

/// A problem and its line, if it is known. Readers return it, since they do not know the file's
/// name.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Located {
    pub line: Option<usize>,
    pub problem: MeshProblem,
}

impl From<MeshProblem> for Located {
    fn from(problem: MeshProblem) -> Located {
        Located { line: None, problem }
    }
}

/// An item of a file, which stands on a line of its own if the file is text; counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Item {
    /// A vertex.
    Vertex(usize),
    /// A normal.
    Normal(usize),
    /// A face; only faces with three corners or more are counted.
    Face(usize),
}

impl MeshProblem {
    /// The item that is wrong.
    pub(crate) fn item(&self) -> Option<Item> {
        match self {
            MeshProblem::Coordinate { what: "vertex", index, .. } => Some(Item::Vertex(*index)),
            MeshProblem::Coordinate { index, .. } => Some(Item::Normal(*index)),
            MeshProblem::Index { face, .. } | MeshProblem::Tangled { face, .. } => {
                Some(Item::Face(*face))
            }
            _ => None,
        }
    }

    /// Adds the line, counted from 1.
    pub(crate) fn at_line(self, line: usize) -> Located {
        Located { line: Some(line), problem: self }
    }
}

//! Triangle meshes and the files they come from.
pub mod error;
mod glb;
mod indexed;
mod limits;
mod lines;
mod model;
pub mod normals;
mod number;
mod obj;
mod ply;
pub mod polygons;
mod shared;
mod stl;
mod text;
mod triangulate;
mod vertices;
mod warning;
mod weld;

use std::path::{Path, PathBuf};

use error::Located;
pub use error::{MeshError, MeshProblem};
pub use indexed::Mesh;
pub use limits::{EXTENSIONS, FARTHEST, LONGEST_FILE, MAX_TRIANGLES, extension};
pub use model::{Model, Movement};
pub use shared::SharedMesh;
pub(crate) use vertices::Vertices;
use warning::Notices;
pub use warning::Warning;

use crate::regular::{NotRead, read_regular};

/// Another file that belongs to a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OtherFile {
    /// Its path, for warnings about it.
    pub path: PathBuf,
    /// Its contents.
    pub bytes: Vec<u8>,
}

/// Gives a file that belongs to a mesh by the name that the mesh states, which is relative to the
/// mesh's folder; or what is wrong with it.
pub type Beside<'a> = dyn Fn(&Path) -> Result<OtherFile, MeshProblem> + 'a;

impl Mesh {
    /// Reads a mesh by its file name extension: `.obj`, `.ply`, `.stl` or `.glb`.
    ///
    /// If the file has no normals, they are computed from the faces (methods A1, A2). Parts of the
    /// file that are not needed are skipped, with a warning for each kind.
    ///
    /// # Errors
    /// A [`MeshError`] for a file that cannot be read, is damaged, or contains no triangle with an
    /// area.
    pub fn read(path: &Path) -> Result<(Mesh, Vec<Warning>), MeshError> {
        let wrong = |problem| MeshError::new(path, None, problem);
        let extension = extension(path).ok_or_else(|| wrong(MeshProblem::Extension))?;
        let bytes = read_file(path).map_err(wrong)?;
        warned(path, extension, &bytes, &|name| file_beside(path, name))
    }

    /// Reads a mesh from bytes as if they were the contents of the file `path`, which is not
    /// opened, without other files.
    ///
    /// # Errors
    /// The errors of [`Mesh::read`].
    pub fn from_bytes(path: &Path, bytes: &[u8]) -> Result<(Mesh, Vec<Warning>), MeshError> {
        let none = |_: &Path| Err(MeshProblem::Unreadable("it is not given".into()));
        Mesh::from_bytes_beside(path, bytes, &none)
    }

    /// Reads a mesh as [`Mesh::from_bytes`] does, with the other files that `beside` gives.
    ///
    /// # Errors
    /// The errors of [`Mesh::read`].
    pub fn from_bytes_beside(
        path: &Path,
        bytes: &[u8],
        beside: &Beside<'_>,
    ) -> Result<(Mesh, Vec<Warning>), MeshError> {
        let extension =
            extension(path).ok_or_else(|| MeshError::new(path, None, MeshProblem::Extension))?;
        warned(path, extension, bytes, beside)
    }
}

/// Reads a mesh from the bytes of the file `path`, with warnings about what was skipped.
fn warned(
    path: &Path,
    extension: &str,
    bytes: &[u8],
    beside: &Beside<'_>,
) -> Result<(Mesh, Vec<Warning>), MeshError> {
    let mut notices = Notices::default();
    let mesh = parse(extension, bytes, beside, &mut notices)
        .map_err(|at| MeshError::new(path, at.line, at.problem))?;
    Ok((mesh, notices.into_warnings(path)))
}

/// Reads a mesh from the bytes of a file with `extension`.
fn parse(
    extension: &str,
    bytes: &[u8],
    beside: &Beside<'_>,
    notices: &mut Notices,
) -> Result<Mesh, Located> {
    match extension {
        "obj" => obj::parse(bytes, beside, notices),
        "ply" => ply::parse(bytes, notices),
        "stl" => stl::parse(bytes, notices),
        "glb" => glb::parse(bytes, notices),
        _ => Err(MeshProblem::Extension.into()),
    }
}

/// Reads the file that a mesh calls by a name, relative to the mesh's folder.
fn file_beside(mesh: &Path, name: &Path) -> Result<OtherFile, MeshProblem> {
    let path = mesh.parent().unwrap_or(Path::new("")).join(name);
    Ok(OtherFile { bytes: read_file(&path)?, path })
}

/// Reads a whole regular file, up to [`LONGEST_FILE`] bytes.
///
/// # Errors
/// A path that is not a regular file, or a file that is too long or cannot be read.
pub(crate) fn read_file(path: &Path) -> Result<Vec<u8>, MeshProblem> {
    read_regular(path, LONGEST_FILE).map_err(|problem| match problem {
        NotRead::NotRegular => MeshProblem::NotAFile,
        NotRead::TooLong { bytes, .. } => MeshProblem::TooLong(bytes),
        NotRead::System(error) => MeshProblem::Unreadable(reason(&error)),
    })
}

/// The system's reason without its error number, which differs between systems.
fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".into(),
        std::io::ErrorKind::PermissionDenied => "permission is denied".into(),
        _ => error.to_string(),
    }
}

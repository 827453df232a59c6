//! A mesh that does not change any more, with what is worked out of it once.
use std::fmt;
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

use super::Mesh;
use super::vertices::Vertices;

/// A mesh that does not change any more. Clones are the same mesh: frames of a sequence share it, and
/// what is worked out of it.
#[derive(Clone)]
pub struct SharedMesh(Arc<Shared>);

struct Shared {
    mesh: Mesh,
    vertices: OnceLock<Vertices>,
}

impl SharedMesh {
    /// Its vertices, with the faces around each.
    pub(crate) fn vertices(&self) -> &Vertices {
        self.0.vertices.get_or_init(|| Vertices::of(&self.0.mesh))
    }
}

impl From<Mesh> for SharedMesh {
    fn from(mesh: Mesh) -> SharedMesh {
        SharedMesh(Arc::new(Shared { mesh, vertices: OnceLock::new() }))
    }
}

impl Deref for SharedMesh {
    type Target = Mesh;

    fn deref(&self) -> &Mesh {
        &self.0.mesh
    }
}

impl PartialEq for SharedMesh {
    fn eq(&self, other: &SharedMesh) -> bool {
        **self == **other
    }
}

impl fmt::Debug for SharedMesh {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        (**self).fmt(f)
    }
}

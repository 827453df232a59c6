//! A mesh that does not change any more, with what is worked out of it once.
use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

use glam::DVec3;

use super::Mesh;
use super::vertices::Vertices;

/// A mesh that does not change any more. Clones are the same mesh: frames of a sequence share it, and
/// what is worked out of it.
#[derive(Clone)]
pub struct SharedMesh(Arc<Shared>);

struct Shared {
    mesh: Mesh,
    vertices: OnceLock<Vertices>,
    is_used: OnceLock<Option<Vec<bool>>>,
}

impl SharedMesh {
    /// Its vertices, with the faces around each.
    pub(crate) fn vertices(&self) -> &Vertices {
        self.0.vertices.get_or_init(|| Vertices::of(&self.0.mesh))
    }

    /// The smallest and largest coordinates of places, of which each is that of a vertex, as far as
    /// triangles use them.
    pub(crate) fn bounds(&self, places: &[DVec3]) -> Option<[DVec3; 2]> {
        let is_used = self.0.is_used.get_or_init(|| is_used(&self.0.mesh));
        let used = |(k, place): (usize, &DVec3)| {
            is_used.as_ref().is_none_or(|is_used| is_used[k]).then_some([*place; 2])
        };
        let used = places.iter().enumerate().filter_map(used);
        used.reduce(|[low, high], [place, _]| [low.min(place), high.max(place)])
    }
}

/// Whether each position is used by a triangle; `None` if all are.
fn is_used(mesh: &Mesh) -> Option<Vec<bool>> {
    let mut is_used = vec![false; mesh.positions.len()];
    mesh.triangles.iter().flatten().for_each(|&k| is_used[k as usize] = true);
    is_used.contains(&false).then_some(is_used)
}

impl From<Mesh> for SharedMesh {
    fn from(mesh: Mesh) -> SharedMesh {
        SharedMesh(Arc::new(Shared { mesh, vertices: OnceLock::new(), is_used: OnceLock::new() }))
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

/// A hash of everything in the mesh, in place of millions of numbers: two that are shown alike are
/// alike. Another release of Rust may hash otherwise.
impl fmt::Debug for SharedMesh {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Mesh { positions, triangles, normals, facets, materials, material_indices } = &**self;
        let mut hasher = DefaultHasher::new();
        let mut add = |vector: &DVec3| vector.to_array().map(f64::to_bits).hash(&mut hasher);
        positions.iter().for_each(&mut add);
        normals.iter().flatten().for_each(&mut add);
        facets.iter().flat_map(|facet| [&facet.normal, &facet.middle]).for_each(&mut add);
        (triangles, material_indices, format!("{materials:?}")).hash(&mut hasher);
        write!(f, "SharedMesh({:016x})", hasher.finish())
    }
}

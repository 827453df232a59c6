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
    unused: OnceLock<Unused>,
}

/// Which positions no triangle uses.
enum Unused {
    None,
    /// For each whether it is used.
    Some(Vec<bool>),
}

impl SharedMesh {
    /// Its vertices, with the faces around each.
    pub(crate) fn vertices(&self) -> &Vertices {
        self.0.vertices.get_or_init(|| Vertices::of(&self.0.mesh))
    }

    /// The smallest and largest coordinates of places, of which each is that of a vertex, as far as
    /// triangles use them.
    pub(crate) fn bounds(&self, places: &[DVec3]) -> Option<[DVec3; 2]> {
        let around = |places: &mut dyn Iterator<Item = DVec3>| {
            let first = places.next()?;
            Some(places.fold([first; 2], |[low, high], p| [low.min(p), high.max(p)]))
        };
        match self.0.unused.get_or_init(|| Unused::of(&self.0.mesh)) {
            Unused::None => around(&mut places.iter().copied()),
            Unused::Some(is_used) => {
                let used = places.iter().zip(is_used).filter(|(_, is_used)| **is_used);
                around(&mut used.map(|(place, _)| *place))
            }
        }
    }
}

impl Unused {
    fn of(mesh: &Mesh) -> Unused {
        let mut is_used = vec![false; mesh.positions.len()];
        mesh.triangles.iter().flatten().for_each(|&k| is_used[k as usize] = true);
        if is_used.iter().all(|&is_used| is_used) { Unused::None } else { Unused::Some(is_used) }
    }
}

impl From<Mesh> for SharedMesh {
    fn from(mesh: Mesh) -> SharedMesh {
        SharedMesh(Arc::new(Shared { mesh, vertices: OnceLock::new(), unused: OnceLock::new() }))
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

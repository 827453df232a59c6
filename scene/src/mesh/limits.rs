//! What is read of meshes at all.
use std::path::Path;

/// File name extensions of meshes that can be read.
pub const EXTENSIONS: [&str; 4] = ["obj", "ply", "stl", "glb"];

/// Largest file that is read, in bytes.
pub const LONGEST_FILE: u64 = 1 << 30;

/// Largest number of triangles of a mesh.
pub const MAX_TRIANGLES: usize = 10_000_000;

/// Coordinates farther from 0 than this are refused, so that products of them stay finite.
pub const FARTHEST: f64 = 1e30;

/// The mesh extension of a path, in lower case, if it has one that can be read.
pub fn extension(path: &Path) -> Option<&'static str> {
    let extension = path.extension()?.to_str()?.to_ascii_lowercase();
    EXTENSIONS.into_iter().find(|known| *known == extension)
}

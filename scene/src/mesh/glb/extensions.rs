//! Extensions of glTF: those that change geometry are supported or refused, all others ignored.
use super::json::Document;
use crate::mesh::error::MeshProblem;
use crate::mesh::warning::{Notices, quoted};

/// Supported extensions.
const READ: [&str; 4] = [
    "EXT_mesh_gpu_instancing",
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_node_visibility",
];

/// Extensions without which a file has no geometry, or a different one.
const REFUSED: [&str; 5] = [
    "EXT_mesh_primitive_restart",
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_meshopt_compression",
    "WEB3D_quantized_attributes",
];

/// Largest number of names that a warning lists.
const MAX_TOLD: usize = 5;

/// Adds one note about the extensions that are ignored.
///
/// # Errors
/// The file requires an extension that changes geometry and is not supported.
pub fn check(document: &Document, notices: &mut Notices) -> Result<(), MeshProblem> {
    let (used, required) = (&document.extensions_used.0, &document.extensions_required.0);
    if let Some(name) = REFUSED.into_iter().find(|name| required.contains(*name)) {
        return Err(unread(name));
    }
    let left_out: Vec<&str> =
        used.union(required).map(String::as_str).filter(|name| !READ.contains(name)).collect();
    if !left_out.is_empty() {
        notices.add("extensions", None, || format!("extensions are left out: {}", told(&left_out)));
    }
    Ok(())
}

/// The error for geometry that exists only in an unsupported extension.
pub fn unread(name: &str) -> MeshProblem {
    MeshProblem::Unsupported(format!("the extension `{name}`"))
}

fn told(names: &[&str]) -> String {
    let (told, more) = names.split_at(names.len().min(MAX_TOLD));
    let mut words: Vec<String> = told.iter().map(|name| quoted(name.as_bytes())).collect();
    if !more.is_empty() {
        words.push(format!("{} more", more.len()));
    }
    words.join(", ")
}

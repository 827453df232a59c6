//! Binary glTF 2.0, `.glb` (decision 0013).
mod accessors;
mod buffers;
mod container;
mod draw;
mod extensions;
mod json;
mod nodes;
mod primitives;

use std::collections::BTreeSet;

use buffers::Buffers;
use container::Container;
use json::{Document, Whole};
use nodes::Placed;
use primitives::Accessors;

use super::error::{Located, MeshProblem};
use super::indexed::Mesh;
use super::polygons::Polygons;
use super::warning::{Notices, quoted};

/// Reads a `.glb` file: every triangle of the default scene's meshes, moved where its nodes put it.
///
/// If a primitive lacks normals, vertices at the same place are joined, so that normals are shared
/// across seams.
///
/// A file that is not a valid `.glb`, or that keeps its geometry compressed or in other files, and
/// all errors of `Polygons::into_mesh`.
pub(super) fn parse(bytes: &[u8], notices: &mut Notices) -> Result<Mesh, Located> {
    let polygons = polygons(bytes, notices)?;
    let all = if polygons.has_all_normals() { polygons } else { polygons.welded() };
    all.into_mesh(notices, &|_| None)
}

fn polygons(bytes: &[u8], notices: &mut Notices) -> Result<Polygons, MeshProblem> {
    let container = Container::read(bytes, notices)?;
    let document = json::parse(container.json)?;
    check_version(&document)?;
    extensions::check(&document, notices)?;
    let placed = nodes::placed(&document)?;
    note_movement(&document, &placed, notices);
    let buffers = Buffers::new(&document, container.binary);
    let mut accessors = Accessors::new(&document, &buffers);
    look_up(&placed, &mut accessors, notices)?;
    draw::draw(&placed, &accessors, notices)
}

/// Checks that the JSON is for version 2 of glTF, as the container is; many files state less than
/// they must.
fn check_version(document: &Document) -> Result<(), MeshProblem> {
    let asset = &document.asset;
    let (version, least) =
        (asset.version.as_deref().unwrap_or("2.0"), asset.min_version.as_deref().unwrap_or("2.0"));
    if version.split('.').next() != Some("2") || least != "2.0" {
        let version = if least == "2.0" { version } else { least };
        return Err(MeshProblem::Syntax(format!(
            "it is for version {} of glTF; 2.0 is read",
            quoted(version.as_bytes())
        )));
    }
    Ok(())
}

/// Adds notes about what would move the mesh.
fn note_movement(document: &Document, placed: &[Placed<'_>], notices: &mut Notices) {
    if !document.animations.is_empty() {
        notices.add("animations", None, || {
            "animations are left out; the mesh stands as its nodes place it".into()
        });
    }
    for one in placed.iter().filter(|one| one.has_skin) {
        notices
            .add("skins", None, || format!("mesh {} has a skin; it is drawn without it", one.mesh));
    }
}

/// Looks up the accessors of meshes and their places.
fn look_up(
    placed: &[Placed<'_>],
    accessors: &mut Accessors<'_>,
    notices: &mut Notices,
) -> Result<(), MeshProblem> {
    let meshes: BTreeSet<usize> = placed.iter().map(|one| one.mesh).collect();
    meshes.into_iter().try_for_each(|mesh| accessors.look_up_mesh(mesh, notices))?;
    for instancing in placed.iter().filter_map(|one| one.instancing) {
        let attributes = &instancing.attributes;
        let numbers: [Option<Whole>; 3] =
            [attributes.translation, attributes.rotation, attributes.scale];
        numbers.into_iter().flatten().try_for_each(|number| accessors.look_up(number))?;
    }
    Ok(())
}

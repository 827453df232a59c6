//! Binary glTF 2.0, `.glb` (decision 0013).
mod accessors;
mod animation;
mod buffers;
mod cameras;
mod container;
mod draw;
mod extensions;
mod json;
mod lights;
mod materials;
mod movement;
mod nodes;
mod part;
mod primitives;

use std::collections::BTreeSet;

use buffers::Buffers;
use container::Container;
use json::{Document, Whole};
use materials::Materials;
use movement::Still;
use nodes::Placed;
use primitives::Accessors;
use serde::de::IgnoredAny;

use super::error::{Located, MeshProblem};
use super::indexed::Mesh;
use super::model::Model;
use super::warning::{Notices, quoted};

/// Reads a `.glb` file: every triangle of the default scene's meshes, moved where its nodes put it.
///
/// If a primitive lacks normals, vertices at the same place are joined, so that normals are shared
/// across seams.
///
/// A file that is not a valid `.glb`, or that keeps its geometry compressed or in other files, and
/// all errors of `Polygons::into_mesh`.
pub(super) fn parse(bytes: &[u8], notices: &mut Notices) -> Result<Mesh, Located> {
    let container = Container::read(bytes, notices)?;
    let document = checked(container.json, notices)?;
    let placed = nodes::placed(&document, &|_| false)?;
    if matches!(document.animations.read::<Vec<IgnoredAny>>(), Ok(Some(all)) if !all.is_empty()) {
        notices.add("animations", None, || {
            "animations are left out; the mesh stands as its nodes place it".into()
        });
    }
    if !placed.lights.is_empty() {
        notices.add("lights", None, || {
            "its lights are left out; they count where the file itself is the scene".into()
        });
    }
    let buffers = Buffers::new(&document, container.binary);
    mesh(&document, &mut Accessors::new(&document, &buffers), &placed.meshes, notices)
}

/// Reads a `.glb` file with its lights, its camera and its animation.
///
/// The errors of [`parse`].
pub(super) fn model(bytes: &[u8], notices: &mut Notices) -> Result<Model, Located> {
    let container = Container::read(bytes, notices)?;
    let document = checked(container.json, notices)?;
    let placed = nodes::placed(&document, &|_| false)?;
    let buffers = Buffers::new(&document, container.binary);
    let mut accessors = Accessors::new(&document, &buffers);
    let mesh = mesh(&document, &mut accessors, &placed.meshes, notices)?;
    let lights = lights::lights(&document, &placed.lights, &mesh, notices);
    let camera = cameras::camera(&document, &placed.cameras, notices);
    let (lights, light_nodes) = lights.into_iter().unzip();
    let (camera, camera_node) = camera.unzip();
    let movement = match animation::animation(&document, &mut accessors, notices) {
        Some(animation) => {
            let still = Still { document: &document, lights: light_nodes, camera: camera_node };
            still.moved(animation, &mut accessors, notices)?
        }
        None => None,
    };
    Ok(Model { mesh, lights, camera, movement })
}

/// The document of a JSON text, if it is of a version and has extensions that can be drawn.
fn checked(json: &[u8], notices: &mut Notices) -> Result<Document, MeshProblem> {
    let document = json::parse(json)?;
    check_version(&document)?;
    extensions::check(&document, notices)?;
    Ok(document)
}

/// All placed meshes as one.
fn mesh(
    document: &Document,
    accessors: &mut Accessors<'_>,
    placed: &[Placed<'_>],
    notices: &mut Notices,
) -> Result<Mesh, Located> {
    note_skins(placed, notices);
    look_up(placed, accessors, notices)?;
    let materials = look_up_materials(document, placed, notices);
    let mut polygons = draw::draw(placed, accessors, &materials, notices)?;
    polygons.materials = materials.all();
    let all = if polygons.has_all_normals() { polygons } else { polygons.welded() };
    all.into_mesh(notices, &|_| None)
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

/// Adds notes about what would bend the mesh.
fn note_skins(placed: &[Placed<'_>], notices: &mut Notices) {
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

/// The materials of a document, those of placed meshes looked up.
fn look_up_materials(
    document: &Document,
    placed: &[Placed<'_>],
    notices: &mut Notices,
) -> Materials {
    let mut materials = Materials::new(document, notices);
    let meshes: BTreeSet<usize> = placed.iter().map(|one| one.mesh).collect();
    let primitives = meshes.iter().filter_map(|&mesh| document.meshes.get(mesh));
    for primitive in primitives.flat_map(|mesh| &mesh.primitives) {
        if let Some(number) = primitive.material.0 {
            materials.look_up(number, notices);
        }
    }
    materials
}

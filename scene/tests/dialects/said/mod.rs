//! What mesh files say beside their shape.
mod animation;
mod glb_materials;
mod obj_materials;
mod stage;

use std::path::Path;

use serde_json::json;
use specula_scene::mesh::{Mesh, MeshProblem, OtherFile, Warning};
use specula_scene::{LoadedScene, Material, load};

/// The mesh of a file beside which there is `other`, by its name, and what is passed over in both.
fn read(name: &str, bytes: &[u8], other: (&str, &[u8])) -> (Mesh, Vec<String>) {
    let beside = |name: &Path| match other {
        (known, bytes) if Path::new(known) == name => {
            Ok(OtherFile { path: name.to_owned(), bytes: bytes.to_vec() })
        }
        _ => Err(MeshProblem::Unreadable("there is no such file".into())),
    };
    let (mesh, warnings) = Mesh::from_bytes_beside(Path::new(name), bytes, &beside)
        .unwrap_or_else(|error| panic!("{error}"));
    (mesh, warnings.iter().map(Warning::to_string).collect())
}

/// The materials of the triangles of a mesh, in their order.
fn of_triangles(mesh: &Mesh) -> Vec<Material> {
    let stated = mesh.material_indices.iter().map(|&k| mesh.materials[k as usize].complete());
    stated.collect()
}

/// A `.glb` file that says all that is read.
pub fn staged() -> Vec<u8> {
    let shift = [0.0, 0.0, 0.0, 0.0, 6.0, 0.0];
    let mut glb = animation::animated("translation", "LINEAR", &[0.0, 0.5], &shift);
    glb.primitive()["material"] = json!(0);
    glb.root["materials"] = json!([{
        "pbrMetallicRoughness": {
            "baseColorFactor": [0.5, 0.25, 0, 1],
            "metallicFactor": 0.5,
            "roughnessFactor": 0.5,
            "baseColorTexture": {"index": 0},
        },
        "emissiveFactor": [0, 0, 0],
        "alphaMode": "BLEND",
    }]);
    glb.root["cameras"] = json!([{"type": "orthographic", "orthographic": {"xmag": 8, "ymag": 6}}]);
    let light = json!({
        "type": "spot",
        "color": [1, 0.5, 0],
        "intensity": 100,
        "range": 9,
        "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2},
    });
    glb.root["extensions"] = json!({"KHR_lights_punctual": {"lights": [light]}});
    glb.root["nodes"][1]["camera"] = json!(0);
    glb.root["nodes"][2]["extensions"] = json!({"KHR_lights_punctual": {"light": 0}});
    glb.file()
}

/// A scene that is written to files, each with its name; the first one is loaded.
fn loaded(files: &[(&str, &[u8])]) -> LoadedScene {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    for (name, bytes) in files {
        std::fs::write(folder.path().join(name), bytes).expect("it can be written");
    }
    let path = folder.path().join(files[0].0);
    load(path.to_str().expect("it is a plain name"), Some((64, 48)))
        .unwrap_or_else(|error| panic!("{error}"))
}

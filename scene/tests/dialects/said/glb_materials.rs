//! Materials of `.glb` files.
use serde_json::{Value, json};
use specula_scene::{Material, defaults};

use super::{of_triangles, read};
use crate::glb_files::{Glb, U16};
use crate::shape::wedge;

/// A file of three triangles beside each other, each a primitive with one of these references to a
/// material.
fn file(references: [Value; 3], materials: &Value) -> Vec<u8> {
    let mut glb = Glb::plain(&wedge());
    let primitives = references.map(|material| {
        let triangle = wedge().triangles[0];
        let indices = glb.indices(&triangle, U16);
        json!({"attributes": {"POSITION": 0}, "indices": indices, "material": material})
    });
    glb.root["meshes"][0]["primitives"] = json!(primitives);
    glb.root["materials"] = materials.clone();
    glb.file()
}

/// The materials of the three triangles, and what is told of them.
fn shown(references: [Value; 3], materials: Value) -> (Vec<Material>, Vec<String>) {
    let (mesh, warnings) = read("a.glb", &file(references, &materials), ("", b""));
    (of_triangles(&mesh), warnings)
}

#[test]
fn primitives_have_the_materials_they_name() {
    let red = json!({"pbrMetallicRoughness": {"baseColorFactor": [0.75, 0.25, 0, 1], "metallicFactor": 0, "roughnessFactor": 0.5}});
    let gold = json!({"pbrMetallicRoughness": {"baseColorFactor": [1, 0.75, 0.25, 1], "roughnessFactor": 0.25}});
    let (all, warnings) = shown([json!(1), json!(null), json!(0)], json!([red, gold]));
    assert_eq!(warnings, [""; 0]);
    let hue = [1.0, 0.75, 0.25];
    // α² = 1/256: highlights of 64 times the hue end at 1, and n = (256 - 1)/2.
    let gold = Material { ambient: hue, diffuse: [0.0; 3], specular: hue, shininess: 128 };
    assert_eq!(all[..2], [gold, defaults::material()]);
    assert_eq!((all[2].diffuse, all[2].shininess), ([0.75, 0.25, 0.0], 8));
}

/// An empty material has all defaults of glTF: a white, rough metal.
#[test]
fn a_material_of_nothing_is_a_white_metal() {
    let (all, _) = shown([json!(0), json!(0), json!(0)], json!([{}]));
    let white =
        Material { ambient: [1.0; 3], diffuse: [0.0; 3], specular: [0.25; 3], shininess: 1 };
    assert_eq!(all, [white.clone(), white.clone(), white]);
}

#[test]
fn files_that_say_nothing_have_no_materials() {
    for references in [[json!(null), json!(null), json!(null)], [json!("x"), json!(-1), json!({})]]
    {
        assert_eq!(shown(references, json!([{}, {}])), (vec![], vec![]));
    }
}

#[test]
fn what_is_not_shown_is_told() {
    let textured = json!({
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1},
                                 "baseColorFactor": [1.5, 0.5, 0.5, 1]},
        "normalTexture": {"index": 2}, "emissiveFactor": [1, 0, 0], "alphaMode": "BLEND",
    });
    let wrong = json!({"pbrMetallicRoughness": {"metallicFactor": "much"}});
    let (all, warnings) = shown([json!(0), json!(1), json!(9)], json!([textured, wrong]));
    // What a texture would make of metal and dielectric is taken as a dielectric.
    assert_eq!(all[0].diffuse, [1.0, 0.5, 0.5]);
    assert_eq!(all[1..], [defaults::material(), defaults::material()]);
    let (_, list) = shown([json!(0), json!(0), json!(0)], json!("none"));
    insta::assert_snapshot!([warnings, list].concat().join("\n"));
}

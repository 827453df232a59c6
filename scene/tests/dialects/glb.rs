//! Binary glTF 2.0.
use glam::DVec3;
use serde_json::{Value, json};
use specula_scene::mesh::{MAX_TRIANGLES, Mesh};

use crate::glb_files::{self, F32, Glb, I8, I16, U16, floats, written};
use crate::shape::wedge;
use crate::{check_dialects, check_same, read, refused};

#[test]
fn every_dialect_gives_the_mesh_and_the_picture_of_the_plain_file() {
    check_dialects(&glb_files::dialects(&wedge()));
}

/// What is passed over is told once, and nothing else is.
#[test]
fn what_is_left_out_is_told_once() {
    let said: Vec<String> = glb_files::dialects(&wedge())
        .iter()
        .map(|(name, bytes)| (name, read(name, bytes).1))
        .filter(|(_, warnings)| !warnings.is_empty())
        .map(|(_, warnings)| warnings.join("\n"))
        .collect();
    insta::assert_snapshot!(said.join("\n"));
}

/// The plain wedge after a change.
fn changed(change: impl FnOnce(&mut Glb)) -> Vec<u8> {
    let mut glb = Glb::plain(&wedge());
    change(&mut glb);
    glb.file()
}

fn set(path: &str, value: Value) -> impl FnOnce(&mut Glb) {
    let path = path.to_owned();
    move |glb| {
        let (parent, key) = path.rsplit_once('/').expect("it is a path");
        let parent = glb.root.pointer_mut(parent).expect("it is there");
        match parent {
            Value::Array(list) => list[key.parse::<usize>().expect("it is an index")] = value,
            other => other[key] = value,
        }
    }
}

fn plain() -> Mesh {
    read("a.glb", &changed(|_| {})).0
}

#[test]
fn positions_may_be_quantized() {
    for lists in [&["extensionsUsed", "extensionsRequired"][..], &["extensionsRequired"]] {
        check_same("quantized", &read("a.glb", &quantized(lists)).0, &plain());
    }
}

/// The plain wedge in shorts; the lists name the extension by which it may be.
fn quantized(lists: &[&str]) -> Vec<u8> {
    changed(|glb| {
        // Quarters, in shorts that are a number of floats apart.
        let bytes: Vec<u8> = wedge()
            .positions
            .iter()
            .flat_map(|p| {
                p.map(|x| (x * 4.0) as i16)
                    .into_iter()
                    .chain([77])
                    .flat_map(i16::to_le_bytes)
                    .collect::<Vec<u8>>()
            })
            .collect();
        let accessor = glb.accessor(&bytes, I16, "VEC3", 5);
        let view =
            glb.root["accessors"][accessor]["bufferView"].as_u64().expect("it has one") as usize;
        glb.root["bufferViews"][view]["byteStride"] = json!(8);
        glb.primitive()["attributes"]["POSITION"] = json!(accessor);
        glb.root["nodes"][0]["scale"] = json!([0.25, 0.25, 0.25]);
        for list in lists {
            glb.root[*list] = json!(["KHR_mesh_quantization"]);
        }
    })
}

/// c / 127, and -1 for -128 [glTF 2.0, 3.6.2.1].
#[test]
fn integers_may_stand_for_fractions() {
    let file = changed(|glb| {
        let bytes = [[127_i8, 0, 0], [0, 127, 0], [-127, 0, 0], [-128, 127, 0], [0, 0, -64]];
        let padded: Vec<u8> =
            bytes.iter().flat_map(|[x, y, z]| [*x as u8, *y as u8, *z as u8, 0]).collect();
        let accessor = glb.accessor(&padded, I8, "VEC3", 5);
        glb.root["accessors"][accessor]["normalized"] = json!(true);
        let view =
            glb.root["accessors"][accessor]["bufferView"].as_u64().expect("it has one") as usize;
        glb.root["bufferViews"][view]["byteStride"] = json!(4);
        glb.primitive()["attributes"]["NORMAL"] = json!(accessor);
        glb.root["extensionsUsed"] = json!(["KHR_mesh_quantization"]);
    });
    let (mesh, warnings) = read("a.glb", &file);
    assert!(warnings.is_empty(), "{warnings:?}");
    let half = 0.5_f64.sqrt();
    let expected = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::new(-half, half, 0.0), DVec3::NEG_Z];
    for (corners, normals) in mesh.triangles.iter().zip(&mesh.normals) {
        for (&corner, normal) in corners.iter().zip(normals) {
            let place = mesh.positions[corner as usize];
            let vertex =
                wedge().positions.iter().position(|p| DVec3::from_array(p.map(f64::from)) == place);
            assert!(normal.distance(expected[vertex.expect("it is one of the wedge's")]) < 1e-12);
        }
    }
}

/// A turn of a right angle about z, by a quaternion of length 2, at two places, one of them twice
/// as large.
#[test]
fn a_mesh_may_be_instanced() {
    let file = changed(|glb| {
        let shift = glb.accessor(&floats(&[[10.0, 0.0, 0.0], [-10.0, 0.0, 0.0]]), F32, "VEC3", 2);
        let scale = glb.accessor(&floats(&[[1.0; 3], [2.0; 3]]), F32, "VEC3", 2);
        let quaternions: Vec<u8> = [0.0, 0.0, 2_f32.sqrt(), 2_f32.sqrt()]
            .repeat(2)
            .iter()
            .flat_map(|x| x.to_le_bytes())
            .collect();
        let turn = glb.accessor(&quaternions, F32, "VEC4", 2);
        let attributes = json!({"TRANSLATION": shift, "SCALE": scale, "ROTATION": turn});
        glb.root["nodes"][0]["extensions"] =
            json!({"EXT_mesh_gpu_instancing": {"attributes": attributes}});
    });
    let (mesh, _) = read("a.glb", &file);
    assert_eq!(mesh.triangles.len(), 12);
    // (2, 0, 0) becomes (0, 2, 0) and (0, 4, 0), before it is shifted.
    for expected in [
        DVec3::new(10.0, 2.0, 0.0),
        DVec3::new(-10.0, 4.0, 0.0),
        DVec3::new(8.5, 0.0, 0.0),
        DVec3::new(-13.0, 0.0, 0.0),
    ] {
        assert!(mesh.positions.iter().any(|p| p.distance(expected) < 1e-6), "{expected}");
    }
}

/// Only what is drawn counts: a mesh of no triangles may be placed as often as it likes.
#[test]
fn nodes_without_triangles_cost_nothing() {
    let file = changed(|glb| {
        let zeros = json!({"componentType": F32, "type": "VEC3", "count": 1_000_000});
        glb.root["accessors"].as_array_mut().expect("it is a list").push(zeros);
        glb.root["meshes"]
            .as_array_mut()
            .expect("it is a list")
            .push(json!({"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]}));
        let attributes = json!({"TRANSLATION": 2});
        let extensions = json!({"EXT_mesh_gpu_instancing": {"attributes": attributes}});
        let node = json!({"mesh": 1, "extensions": extensions});
        glb.root["nodes"] = json!(
            std::iter::once(json!({"mesh": 0}))
                .chain(std::iter::repeat_n(node, 1000))
                .collect::<Vec<Value>>()
        );
        glb.root["scenes"][0]["nodes"] = json!((0..1001).collect::<Vec<usize>>());
    });
    check_same("no triangles", &read("a.glb", &file).0, &plain());
}

/// A mesh of 10 000 triangles that is named by `times` primitives of as many nodes each as `nodes`.
fn repeated(times: usize, nodes: usize) -> Vec<u8> {
    let shape = wedge();
    let mut glb = Glb::plain(&shape);
    let corners: Vec<[f32; 3]> =
        (0..30_000).map(|k| [(k as f32).cos(), (k as f32).sin(), k as f32 / 30_000.0]).collect();
    let accessor = glb.positions(&corners);
    let part = json!({"attributes": {"POSITION": accessor}});
    glb.root["meshes"] = json!([{"primitives": vec![part; times]}]);
    glb.root["nodes"] = json!(vec![json!({"mesh": 0}); nodes]);
    glb.root["scenes"] = json!([{"nodes": (0..nodes).collect::<Vec<usize>>()}]);
    glb.file()
}

/// The files take less than a megabyte; copied, their triangles would take more than 10 GB.
#[test]
fn triangles_are_counted_before_they_are_copied() {
    for (times, nodes, triangles) in [
        (20_000, 1, 200_000_000_usize),
        (1, 20_000, 200_000_000),
        (1000, 1000, 10_000_000_000),
        (1001, 1, 10_010_000),
    ] {
        let said = refused("a.glb", &repeated(times, nodes));
        assert_eq!(
            said,
            format!(
                "mesh `a.glb`: it has {triangles} triangles; at most {MAX_TRIANGLES} are taken"
            )
        );
    }
}

/// Primitives of one node that name the same accessors share the vertices copied.
#[test]
fn shared_accessors_are_copied_once() {
    let mut glb = Glb::plain(&wedge());
    let normals = glb.accessor(&floats(&[[0.0, 0.0, 1.0]; 5]), F32, "VEC3", 5);
    let part = json!({"attributes": {"POSITION": 0, "NORMAL": normals}, "indices": 1});
    glb.root["meshes"][0]["primitives"] = json!(vec![part; 100]);
    let (mesh, _) = read("a.glb", &glb.file());
    assert_eq!((mesh.positions.len(), mesh.triangles.len()), (5, 600));
}

/// What keeps geometry from being read is named.
#[test]
fn what_cannot_be_drawn_is_named() {
    let required = |name: &str| changed(set("/extensionsRequired", json!([name])));
    let files = [
        required("KHR_draco_mesh_compression"),
        required("EXT_meshopt_compression"),
        required("KHR_meshopt_compression"),
        changed(|glb| {
            glb.primitive()["extensions"] = json!({"KHR_draco_mesh_compression": {}});
            glb.root["accessors"][0] = json!({"componentType": F32, "type": "VEC3", "count": 5});
        }),
        changed(|glb| {
            glb.root["buffers"] = json!([{"byteLength": 9}, {"byteLength": 9}]);
            glb.root["bufferViews"][0]["buffer"] = json!(1);
            glb.root["bufferViews"][0]["extensions"] =
                json!({"EXT_meshopt_compression": {"buffer": 0}});
        }),
        changed(set("/buffers/0/uri", json!("wedge.bin"))),
        changed(set("/buffers/0/uri", json!("data:;base64,?"))),
        changed(set("/asset/version", json!("1.0"))),
        changed(set("/asset/minVersion", json!("2.1"))),
        changed(set("/scene", json!(3))),
        changed(set("/scenes/0/nodes", json!([3]))),
        changed(set("/nodes/0/children", json!([3]))),
        changed(set("/nodes", json!([{"children": [1]}, {"children": [0]}]))),
        changed(|glb| {
            glb.root["nodes"] = json!([{"children": [1]}, {"children": [0]}]);
            glb.root["scenes"] = json!([]);
            glb.root["scene"] = json!(null);
        }),
        changed(set("/nodes/0/mesh", json!(3))),
        changed(set("/nodes/0/mesh", json!("x"))),
        changed(set("/meshes/0/primitives/0/mode", json!(9))),
        changed(set("/accessors/0/componentType", json!(U16))),
        changed(set(
            "/accessors/1",
            json!({"bufferView": 1, "componentType": F32, "type": "SCALAR", "count": 9}),
        )),
        changed(set("/accessors/0/type", json!("VEC5"))),
        changed(set("/accessors/0/bufferView", json!(9))),
        changed(set("/accessors/0/byteOffset", json!(u64::MAX))),
        changed(set("/accessors/1/count", json!(u64::MAX))),
        changed(set("/bufferViews/0/byteStride", json!(8))),
        changed(set("/bufferViews/0/byteStride", json!(u64::MAX))),
        changed(set("/bufferViews/0/buffer", json!(1))),
        changed(set("/accessors/0/sparse", json!({"count": 1}))),
        changed(set(
            "/accessors/0/sparse",
            json!({"count": 9, "indices": {"bufferView": 1, "componentType": U16}, "values": {"bufferView": 0}}),
        )),
        changed(|glb| {
            glb.root["accessors"][0] =
                json!({"componentType": F32, "type": "VEC3", "count": u64::MAX})
        }),
        // A few bytes that would take a gigabyte.
        changed(|glb| {
            glb.root["accessors"][0] =
                json!({"componentType": F32, "type": "VEC3", "count": 1_000_001});
            glb.root["meshes"][0]["primitives"] = json!([{"attributes": {"POSITION": 0}}]);
        }),
        changed(|glb| {
            glb.root["buffers"] = json!([{"byteLength": 9}, {"byteLength": 9}]);
            glb.root["bufferViews"][0]["buffer"] = json!(1);
            glb.root["bufferViews"][0]["extensions"] =
                json!({"KHR_meshopt_compression": {"buffer": 0}});
        }),
        changed(|glb| glb.root["nodes"][0]["matrix"] = json!([1, 2, 3])),
        changed(|glb| glb.root["nodes"][0]["scale"] = json!([1e300, 1, 1])),
        written(&b"{".repeat(2_000_001), &[]),
    ];
    let said: Vec<String> = files.iter().map(|file| refused("a.glb", file)).collect();
    insta::assert_snapshot!(said.join("\n"));
}

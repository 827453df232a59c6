//! `.glb` files as different programs write them, each of the same shape.
use serde_json::{Value, json};

use super::shape::Shape;

/// The JSON of a `.glb` file, and the bytes beside it.
#[derive(Clone, Debug)]
pub struct Glb {
    pub root: Value,
    pub bytes: Vec<u8>,
}

/// Codes of component types.
pub const I8: u32 = 5120;
pub const U8: u32 = 5121;
pub const I16: u32 = 5122;
pub const U16: u32 = 5123;
pub const U32: u32 = 5125;
pub const F32: u32 = 5126;

impl Glb {
    /// A file of a node, a mesh and a primitive: accessor 0 has positions in floats, accessor 1
    /// indices in 16 bits.
    pub fn plain(shape: &Shape) -> Glb {
        let root = json!({
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
            "accessors": [],
            "bufferViews": [],
            "buffers": [{"byteLength": 0}],
        });
        let mut glb = Glb { root, bytes: Vec::new() };
        glb.positions(&shape.positions);
        let indices: Vec<u32> = shape.triangles.iter().flatten().copied().collect();
        glb.indices(&indices, U16);
        glb
    }

    /// Appends a view of some bytes; its number.
    pub fn view(&mut self, bytes: &[u8]) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let view = json!({"buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len()});
        self.bytes.extend(bytes);
        self.root["buffers"][0]["byteLength"] = json!(self.bytes.len());
        self.push("bufferViews", view)
    }

    /// Appends an accessor of a view; its number.
    pub fn accessor(&mut self, bytes: &[u8], component: u32, kind: &str, count: usize) -> usize {
        let view = self.view(bytes);
        self.push(
            "accessors",
            json!({"bufferView": view, "componentType": component, "type": kind, "count": count}),
        )
    }

    /// Appends positions in floats with their bounds; the accessor's number.
    pub fn positions(&mut self, positions: &[[f32; 3]]) -> usize {
        let accessor = self.accessor(&floats(positions), F32, "VEC3", positions.len());
        let bound = |pick: fn(f32, f32) -> f32| {
            [0, 1, 2].map(|k| positions.iter().map(|p| p[k]).reduce(pick).unwrap_or(0.0))
        };
        self.root["accessors"][accessor]["min"] = json!(bound(f32::min));
        self.root["accessors"][accessor]["max"] = json!(bound(f32::max));
        accessor
    }

    /// Appends indices of a type; the accessor's number.
    pub fn indices(&mut self, indices: &[u32], component: u32) -> usize {
        let size = match component {
            U8 => 1,
            U16 => 2,
            _ => 4,
        };
        let bytes: Vec<u8> =
            indices.iter().flat_map(|index| index.to_le_bytes()[..size].to_vec()).collect();
        self.accessor(&bytes, component, "SCALAR", indices.len())
    }

    fn push(&mut self, list: &str, value: Value) -> usize {
        if self.root[list].is_null() {
            self.root[list] = json!([]);
        }
        let list = self.root[list].as_array_mut().expect("it is a list");
        list.push(value);
        list.len() - 1
    }

    /// The only primitive.
    pub fn primitive(&mut self) -> &mut Value {
        &mut self.root["meshes"][0]["primitives"][0]
    }

    /// The file.
    pub fn file(&self) -> Vec<u8> {
        written(self.root.to_string().as_bytes(), &[(b"BIN\0", &self.bytes)])
    }
}

/// A file of JSON text, padded with blanks, and other chunks, padded with zeros.
pub fn written(json: &[u8], others: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
    let mut chunks = Vec::new();
    for (kind, data, padding) in std::iter::once((b"JSON", json, b' '))
        .chain(others.iter().map(|(kind, data)| (*kind, *data, 0)))
    {
        let length = data.len().next_multiple_of(4);
        chunks.extend((length as u32).to_le_bytes());
        chunks.extend(kind);
        chunks.extend(data);
        chunks.resize(chunks.len() + length - data.len(), padding);
    }
    let mut file = b"glTF".to_vec();
    file.extend(2_u32.to_le_bytes());
    file.extend((chunks.len() as u32 + 12).to_le_bytes());
    file.extend(chunks);
    file
}

/// Vectors of floats as bytes.
pub fn floats(vectors: &[[f32; 3]]) -> Vec<u8> {
    vectors.iter().flatten().flat_map(|x| x.to_le_bytes()).collect()
}

/// Bytes in base64, padded.
pub fn base64(bytes: &[u8]) -> String {
    let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for three in bytes.chunks(3) {
        let bits =
            (0..3).fold(0_u32, |bits, k| bits << 8 | u32::from(three.get(k).copied().unwrap_or(0)));
        for k in 0..4 {
            let digit = digits[(bits >> (18 - 6 * k) & 63) as usize];
            text.push(if k <= three.len() { char::from(digit) } else { '=' });
        }
    }
    text
}

/// A change to the plain file.
type Change = fn(&mut Glb, &Shape);

/// Files that show the shape, each in a dialect of its own, with its name. Their triangles are
/// those of the shape; vertices may be stated several times. At most 255 vertices.
pub fn dialects(shape: &Shape) -> Vec<(String, Vec<u8>)> {
    let changed = |&(name, change): &(&str, Change)| {
        let mut glb = Glb::plain(shape);
        change(&mut glb, shape);
        (format!("{name}.glb"), glb.file())
    };
    let all = [BESIDE, SCENES, GEOMETRY].concat();
    all.iter().map(changed).chain(containers(shape)).collect()
}

/// What stands beside the geometry and does not matter for it.
const BESIDE: &[(&str, Change)] = &[
    ("plain", |_, _| {}),
    ("custom-attribute", |glb, shape| {
        let ids: Vec<u8> =
            (0..shape.positions.len()).flat_map(|k| (k as f32).to_le_bytes()).collect();
        let accessor = glb.accessor(&ids, F32, "SCALAR", shape.positions.len());
        glb.primitive()["attributes"]["_BATCHID"] = json!(accessor);
    }),
    ("other-attributes", |glb, _| {
        glb.primitive()["attributes"]["TEXCOORD_7"] = json!(77);
        glb.primitive()["attributes"]["COLOR_0"] = json!(78);
        glb.primitive()["material"] = json!(5);
    }),
    ("extras", |glb, _| glb.root["nodes"][0]["extras"] = json!("x")),
    ("extras-everywhere", |glb, _| {
        for (path, extras) in [
            ("/asset", json!(null)),
            ("/scenes/0", json!([1, 2])),
            ("/nodes/0", json!({"children": [9], "mesh": "x"})),
            ("/meshes/0", json!(7)),
            ("/meshes/0/primitives/0", json!("attributes")),
            ("/accessors/0", json!([[], {}])),
            ("/bufferViews/0", json!(true)),
            ("/buffers/0", json!({"uri": 3})),
            ("", json!(["scene", {"nodes": 1}])),
        ] {
            glb.root.pointer_mut(path).expect("it is there")["extras"] = extras;
        }
    }),
    ("extras-deep", |glb, _| {
        glb.root["nodes"][0]["extras"] = (0..1000).fold(json!(0), |inner, _| json!([inner]));
    }),
    ("texture-webp", |glb, _| requires(glb, "EXT_texture_webp")),
    ("texture-transform", |glb, _| requires(glb, "KHR_texture_transform")),
    ("texture-empty", |glb, _| {
        glb.root["textures"] = json!([{}, {"extensions": {"EXT_texture_webp": {"source": 0}}}])
    }),
    ("materials", |glb, _| {
        requires(glb, "KHR_materials_unlit");
        glb.root["materials"] = json!([{"extensions": {"KHR_materials_unlit": {}}, "alphaMode": "FUZZY", "pbrMetallicRoughness": 1}]);
        glb.primitive()["material"] = json!(0);
    }),
    ("lights", |glb, _| {
        requires(glb, "KHR_lights_punctual");
        glb.root["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "laser"}]}});
        glb.root["nodes"][0]["extensions"] = json!({"KHR_lights_punctual": {"light": 0}});
    }),
    ("animation-pointer", |glb, _| {
        let target = json!({"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": "/nodes/0/scale"}}});
        let channels = json!([{"sampler": 0, "target": target}]);
        glb.root["animations"] =
            json!([{"samplers": [{"input": 0, "output": 0}], "channels": channels}]);
        requires(glb, "KHR_animation_pointer");
    }),
    ("cameras-and-names", |glb, _| {
        glb.root["cameras"] = json!([{"type": "fish-eye"}]);
        glb.root["nodes"][0]["camera"] = json!(3);
        glb.root["nodes"][0]["name"] = json!("\u{1f98a} \u{0} \" \\");
    }),
    ("unused-accessors", |glb, _| {
        glb.push("accessors", json!({"componentType": 1, "type": "MAT9"}));
        glb.push("buffers", json!({"uri": "elsewhere.bin", "byteLength": 5}));
        glb.push("bufferViews", json!({"buffer": 1, "byteLength": 5}));
    }),
];

fn requires(glb: &mut Glb, name: &str) {
    glb.root["extensionsUsed"] = json!([name]);
    glb.root["extensionsRequired"] = json!([name]);
}

/// Scenes and nodes.
const SCENES: &[(&str, Change)] = &[
    ("scene-without-nodes", |glb, _| {
        glb.push("scenes", json!({"name": "empty"}));
    }),
    ("no-default-scene", |glb, _| {
        take(&mut glb.root, "scene");
    }),
    ("shared-roots", |glb, _| {
        take(&mut glb.root, "scene");
        glb.push("scenes", json!({"nodes": [0, 0]}));
    }),
    ("no-scenes", |glb, _| {
        take(&mut glb.root, "scene");
        take(&mut glb.root, "scenes");
        glb.root["nodes"] = json!([{"mesh": 0}, {"children": [0]}]);
    }),
    ("no-nodes", |glb, _| {
        for list in ["scene", "scenes", "nodes"] {
            take(&mut glb.root, list);
        }
    }),
    ("scenes-without-roots", |glb, _| {
        take(&mut glb.root, "scene");
        glb.root["scenes"] = json!([{"name": "empty"}, {"nodes": []}]);
    }),
    ("scenes-without-nodes-at-all", |glb, _| {
        take(&mut glb.root, "scene");
        take(&mut glb.root, "nodes");
        glb.root["scenes"] = json!([{}]);
    }),
    ("other-scene", |glb, _| {
        glb.root["scene"] = json!(1);
        glb.root["scenes"] = json!([{"nodes": [1]}, {"nodes": [0]}]);
        glb.push("nodes", json!({"mesh": 0, "translation": [9, 9, 9]}));
    }),
    ("fractions", |glb, _| {
        glb.root["scene"] = json!(0.0);
        glb.root["nodes"][0]["mesh"] = json!(0.0);
        glb.root["accessors"][0]["componentType"] = json!(5126.0);
        glb.root["nodes"][0]["scale"] = json!([1, 1.0, 1e0]);
    }),
    ("scaled", |glb, shape| {
        replace_positions(glb, &shape.scaled([0.5, 0.25, 2.0]));
        glb.root["nodes"] = json!([{"children": [1], "scale": [2, 4, 1]}, {"mesh": 0, "scale": [1, 1, 0.5], "rotation": [0, 0, 0, 1]}]);
    }),
    ("matrices", |glb, shape| {
        replace_positions(glb, &shape.scaled([0.5, 0.5, 0.5]));
        let there = [2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 8, 0, 0, 1];
        let back = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -4, 0, 0, 1];
        glb.root["nodes"] =
            json!([{"children": [1], "matrix": there}, {"mesh": 0, "matrix": back}]);
    }),
    ("mirrored", |glb, shape| {
        *glb = Glb::plain(&shape.scaled([-1.0, 1.0, 1.0]).turned_around());
        glb.root["nodes"][0]["scale"] = json!([-1, 1, 1]);
    }),
    ("hidden-node", |glb, _| {
        requires(glb, "KHR_node_visibility");
        let hidden = json!({"KHR_node_visibility": {"visible": false}});
        glb.push("nodes", json!({"translation": [9, 9, 9], "children": [2], "extensions": hidden}));
        glb.push("nodes", json!({"mesh": 0}));
        glb.root["scenes"][0]["nodes"] = json!([0, 1]);
    }),
    ("one-instance", |glb, _| {
        requires(glb, "EXT_mesh_gpu_instancing");
        let shift = glb.accessor(&floats(&[[1.0, 0.0, 0.0]]), F32, "VEC3", 1);
        let attributes = json!({"TRANSLATION": shift, "_ID": 99});
        glb.root["nodes"][0]["extensions"] =
            json!({"EXT_mesh_gpu_instancing": {"attributes": attributes}});
        glb.root["nodes"][0]["translation"] = json!([-1, 0, 0]);
    }),
];

fn take(root: &mut Value, key: &str) {
    root.as_object_mut().expect("the root is an object").remove(key);
}

fn replace_positions(glb: &mut Glb, shape: &Shape) {
    let accessor = glb.positions(&shape.positions);
    glb.primitive()["attributes"]["POSITION"] = json!(accessor);
}

/// How vertices and triangles are written.
const GEOMETRY: &[(&str, Change)] = &[
    ("bytes-as-indices", |glb, shape| replace_indices(glb, &shape.triangles.concat(), U8)),
    ("long-indices", |glb, shape| replace_indices(glb, &shape.triangles.concat(), U32)),
    ("indices-left-over", |glb, shape| {
        replace_indices(glb, &[shape.triangles.concat(), vec![0, 1]].concat(), U16)
    }),
    ("unindexed", |glb, shape| *glb = unindexed(shape)),
    ("no-bounds", |glb, _| {
        take(&mut glb.root["accessors"][0], "min");
        take(&mut glb.root["accessors"][0], "max");
    }),
    ("strip", |glb, shape| {
        replace_indices(glb, &shape.strip(), U16);
        glb.primitive()["mode"] = json!(5);
    }),
    ("odd-strips", |glb, shape| {
        // The second triangle of each strip is the one that is turned around.
        primitives(glb, shape, 5, |&[a, b, c]| vec![a, a, c, b]);
    }),
    ("fans", |glb, shape| primitives(glb, shape, 6, |triangle| triangle.to_vec())),
    ("many-primitives", |glb, shape| primitives(glb, shape, 4, |triangle| triangle.to_vec())),
    ("points-and-lines", |glb, _| {
        for mode in [0, 1, 2, 3] {
            let part = json!({"attributes": {"POSITION": 0}, "indices": 1, "mode": mode});
            glb.root["meshes"][0]["primitives"].as_array_mut().expect("it is a list").push(part);
        }
    }),
    ("no-positions", |glb, _| {
        let part = json!({"attributes": {}, "indices": 1});
        glb.root["meshes"][0]["primitives"].as_array_mut().expect("it is a list").insert(0, part);
    }),
    ("interleaved", |glb, shape| {
        let bytes: Vec<u8> = shape
            .positions
            .iter()
            .flat_map(|p| [&[7; 8][..], &floats(&[*p]), &[9; 4]].concat())
            .collect();
        let accessor = glb.accessor(&bytes, F32, "VEC3", shape.positions.len());
        let view =
            glb.root["accessors"][accessor]["bufferView"].as_u64().expect("it has one") as usize;
        glb.root["bufferViews"][view]["byteStride"] = json!(24);
        glb.root["accessors"][accessor]["byteOffset"] = json!(8);
        glb.primitive()["attributes"]["POSITION"] = json!(accessor);
    }),
    ("sparse", |glb, shape| {
        // Every other place is wrong in the buffer, and replaced.
        let mut wrong = shape.positions.clone();
        let replaced: Vec<usize> = (0..wrong.len()).step_by(2).collect();
        replaced.iter().for_each(|&k| wrong[k] = [99.0; 3]);
        replace_positions(glb, &Shape { positions: wrong, ..shape.clone() });
        let right: Vec<[f32; 3]> = replaced.iter().map(|&k| shape.positions[k]).collect();
        replace_some(glb, &replaced, &right);
    }),
    ("all-sparse", |glb, shape| {
        let count = shape.positions.len();
        let accessor =
            glb.push("accessors", json!({"componentType": F32, "type": "VEC3", "count": count}));
        glb.primitive()["attributes"]["POSITION"] = json!(accessor);
        replace_some(glb, &(0..count).collect::<Vec<usize>>(), &shape.positions);
    }),
    ("data-uri", |glb, _| {
        let text = format!("data:application/octet-stream;base64,{}", base64(&glb.bytes));
        glb.root["buffers"][0]["uri"] = json!(text);
        glb.bytes.clear();
    }),
    ("data-uri-without-padding", |glb, _| {
        // Of every length.
        glb.bytes.push(0);
        let text = format!("data:application/gltf-buffer;base64,{}", base64(&glb.bytes));
        glb.root["buffers"][0]["uri"] = json!(text.trim_end_matches('='));
        glb.bytes.clear();
    }),
    ("data-uri-in-capitals", |glb, _| {
        let text = format!("DATA:application/octet-stream;BASE64,{}", base64(&glb.bytes));
        glb.root["buffers"][0]["uri"] = json!(text);
        glb.bytes.clear();
    }),
    ("compressed-twice-beside", |glb, _| {
        glb.root["bufferViews"][0]["extensions"] = json!({"EXT_meshopt_compression": {"buffer": 0}, "KHR_meshopt_compression": {"buffer": 0}});
    }),
    ("two-buffers", |glb, shape| {
        let text = format!("data:;base64,{}", base64(&floats(&shape.positions)));
        let buffer =
            glb.push("buffers", json!({"uri": text, "byteLength": 12 * shape.positions.len()}));
        glb.root["bufferViews"][0] =
            json!({"buffer": buffer, "byteLength": 12 * shape.positions.len()});
    }),
    ("compressed-beside", |glb, _| {
        glb.root["extensionsUsed"] = json!(["KHR_draco_mesh_compression"]);
        glb.primitive()["extensions"] = json!({"KHR_draco_mesh_compression": {"bufferView": 7}});
    }),
    ("unused-vertices", |glb, shape| {
        let unused = [[f32::NAN; 3], [1e35, 0.0, 0.0]];
        replace_positions(
            glb,
            &Shape { positions: [&shape.positions[..], &unused].concat(), ..shape.clone() },
        );
    }),
    ("normals-without-direction", |glb, shape| {
        let count = shape.positions.len();
        let normals: Vec<[f32; 3]> =
            (0..count).map(|k| [[f32::NAN; 3], [0.0; 3], [f32::INFINITY; 3]][k % 3]).collect();
        let accessor = glb.accessor(&floats(&normals), F32, "VEC3", count);
        glb.primitive()["attributes"]["NORMAL"] = json!(accessor);
    }),
];

fn replace_indices(glb: &mut Glb, indices: &[u32], component: u32) {
    let accessor = glb.indices(indices, component);
    glb.primitive()["indices"] = json!(accessor);
}

fn replace_some(glb: &mut Glb, which: &[usize], right: &[[f32; 3]]) {
    let accessor = glb.primitive()["attributes"]["POSITION"].as_u64().expect("it has one") as usize;
    let indices: Vec<u8> = which.iter().flat_map(|&k| (k as u16).to_le_bytes()).collect();
    let (indices, values) = (glb.view(&indices), glb.view(&floats(right)));
    glb.root["accessors"][accessor]["sparse"] = json!({
        "count": which.len(),
        "indices": {"bufferView": indices, "componentType": U16},
        "values": {"bufferView": values},
    });
}

fn unindexed(shape: &Shape) -> Glb {
    let mut glb = Glb::plain(&shape.unshared());
    take(glb.primitive(), "indices");
    glb
}

/// A primitive for each triangle, all of the same vertices.
fn primitives(glb: &mut Glb, shape: &Shape, mode: u32, indices: fn(&[u32; 3]) -> Vec<u32>) {
    let parts = shape.triangles.iter().map(|triangle| {
        let accessor = glb.indices(&indices(triangle), U16);
        json!({"attributes": {"POSITION": 0}, "indices": accessor, "mode": mode})
    });
    let parts: Vec<Value> = parts.collect();
    glb.root["meshes"][0]["primitives"] = json!(parts);
}

/// Containers other than the usual.
fn containers(shape: &Shape) -> Vec<(String, Vec<u8>)> {
    let glb = Glb::plain(shape);
    let mut json = glb.root.to_string();
    let binary: (&[u8; 4], &[u8]) = (b"BIN\0", &glb.bytes);
    let plain = written(json.as_bytes(), &[binary]);
    let named: Vec<u8> =
        json.replacen("\"mesh\":0", "\"mesh\":0,\"name\":\"caf?\"", 1).into_bytes();
    let latin1: Vec<u8> =
        named.into_iter().map(|byte| if byte == b'?' { 0xe9 } else { byte }).collect();
    let padded = format!("\u{feff}{json}{}", " ".repeat(41));
    json.push_str("\0\0\0\0");
    let files = [
        (
            "chunks-behind",
            written(
                glb.root.to_string().as_bytes(),
                &[binary, (b"LOGO", b"?"), (b"BIN\0", b"again")],
            ),
        ),
        ("chunk-between", written(glb.root.to_string().as_bytes(), &[(b"LOGO", b"?"), binary])),
        ("bytes-behind", [&plain[..], b"behind the stated length"].concat()),
        ("latin-1-name", written(&latin1, &[binary])),
        ("mark-and-blanks", written(padded.as_bytes(), &[binary])),
        ("zeros-behind", written(json.as_bytes(), &[binary])),
    ];
    files.into_iter().map(|(name, file)| (format!("{name}.glb"), file)).collect()
}

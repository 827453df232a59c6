//! What is read of the JSON of glTF 2.0: what geometry needs, and no more.
//!
//! What is not named here (materials, cameras, `extras`, extensions that nothing here knows) is
//! skipped whatever it holds, and what is named may be left out wherever its use can be refused
//! more clearly than its absence.
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt;

use serde::Deserialize;
use serde::de::{self, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};

use crate::mesh::error::MeshProblem;

/// The most objects in the JSON: what is read of each takes some hundred bytes of memory at most.
const MOST_OBJECTS: usize = 2_000_000;

/// The most extensions that a file may name.
const MOST_EXTENSIONS: usize = 1000;

/// Reads the JSON text.
///
/// # Errors
/// Text that is not JSON, or in which something needed is of a wrong type.
pub fn parse(bytes: &[u8]) -> Result<Document, MeshProblem> {
    let objects = bytes.iter().filter(|byte| **byte == b'{').count();
    if objects > MOST_OBJECTS {
        let text = format!("its JSON has {objects} objects; at most {MOST_OBJECTS} are read");
        return Err(MeshProblem::Syntax(text));
    }
    // Names in other encodings are not needed. Some programs pad with zeros.
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}').trim_end_matches(['\0', ' ']);
    serde_json::from_str(text)
        .map_err(|error| MeshProblem::Syntax(format!("its JSON is wrong: {error}")))
}

/// The whole file.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
pub struct Document {
    /// What the file says about itself.
    pub asset: Asset,
    /// The scene to be shown.
    pub scene: Option<Whole>,
    /// All scenes.
    pub scenes: Vec<Scene>,
    /// All nodes.
    pub nodes: Vec<Node>,
    /// All meshes.
    pub meshes: Vec<Mesh>,
    /// All accessors.
    pub accessors: Vec<Accessor>,
    /// All buffer views.
    pub buffer_views: Vec<BufferView>,
    /// All buffers.
    pub buffers: Vec<Buffer>,
    /// How many animations there are.
    pub animations: Vec<IgnoredAny>,
    /// Extensions that something in the file makes use of.
    pub extensions_used: Names,
    /// Extensions that the file says it cannot do without.
    pub extensions_required: Names,
}

/// What a file says about itself.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
pub struct Asset {
    /// The version of glTF that it is for.
    pub version: Option<String>,
    /// The version of glTF that it cannot do without.
    pub min_version: Option<String>,
}

/// A scene.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Scene {
    /// The roots of its trees.
    pub nodes: Vec<Whole>,
}

/// A node of a tree.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Node {
    /// The nodes below it.
    pub children: Vec<Whole>,
    /// What is drawn there.
    pub mesh: Option<Whole>,
    /// What moves the mesh's vertices.
    pub skin: Option<IgnoredAny>,
    /// The way to the parent's coordinates, column by column.
    pub matrix: Option<Box<[Number; 16]>>,
    /// The same in three parts.
    pub translation: Option<[Number; 3]>,
    /// A quaternion x, y, z, w.
    pub rotation: Option<[Number; 4]>,
    /// Factors.
    pub scale: Option<[Number; 3]>,
    /// What extensions add.
    pub extensions: Option<Box<NodeExtensions>>,
}

/// What extensions add to a node.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct NodeExtensions {
    /// The mesh is drawn many times.
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub instancing: Option<Instancing>,
    /// The node is hidden.
    #[serde(rename = "KHR_node_visibility")]
    pub visibility: Option<Visibility>,
}

/// Where a mesh is drawn many times.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Instancing {
    /// Accessors with a value for each time.
    pub attributes: InstanceAttributes,
}

/// Accessors with a value for each time that a mesh is drawn.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct InstanceAttributes {
    /// Shifts.
    #[serde(rename = "TRANSLATION")]
    pub translation: Option<Whole>,
    /// Quaternions x, y, z, w.
    #[serde(rename = "ROTATION")]
    pub rotation: Option<Whole>,
    /// Factors.
    #[serde(rename = "SCALE")]
    pub scale: Option<Whole>,
}

/// Whether a node is seen.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Visibility {
    /// It is where nothing is said.
    pub visible: Option<bool>,
}

/// A mesh.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Mesh {
    /// The parts of it.
    pub primitives: Vec<Primitive>,
}

/// A part of a mesh.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Primitive {
    /// Accessors with a value for each vertex.
    pub attributes: Attributes,
    /// The accessor with the order of vertices.
    pub indices: Option<Whole>,
    /// Points, lines or triangles.
    pub mode: Option<Whole>,
    /// What vertices may move to.
    pub targets: Vec<IgnoredAny>,
    /// What extensions add.
    pub extensions: PrimitiveExtensions,
}

/// What extensions add to a part of a mesh.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct PrimitiveExtensions {
    /// Its vertices are compressed.
    #[serde(rename = "KHR_draco_mesh_compression")]
    pub draco: Option<IgnoredAny>,
}

/// Numbers of one type, one or several for each element.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
pub struct Accessor {
    /// Where they are; all are 0 if nowhere.
    pub buffer_view: Option<Whole>,
    /// Where the first starts in the view, in bytes.
    pub byte_offset: Whole,
    /// The type of a number.
    pub component_type: Option<Whole>,
    /// Whether integers stand for fractions.
    pub normalized: bool,
    /// How many elements.
    pub count: Option<Whole>,
    /// How many numbers an element has.
    #[serde(rename = "type")]
    pub kind: Option<String>,
    /// The smallest of all elements.
    pub min: Option<IgnoredAny>,
    /// The largest of all elements.
    pub max: Option<IgnoredAny>,
    /// Elements that are replaced.
    pub sparse: Option<Box<Sparse>>,
}

/// Elements of an accessor that are replaced.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Sparse {
    /// How many.
    pub count: Whole,
    /// Which.
    pub indices: SparsePart,
    /// By what.
    pub values: SparsePart,
}

/// Where indices or values of replaced elements are.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
pub struct SparsePart {
    /// The view.
    pub buffer_view: Option<Whole>,
    /// Where the first starts in the view, in bytes.
    pub byte_offset: Whole,
    /// The type of indices.
    pub component_type: Option<Whole>,
}

/// A part of a buffer.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
pub struct BufferView {
    /// The buffer.
    pub buffer: Whole,
    /// Where it starts in the buffer, in bytes.
    pub byte_offset: Whole,
    /// How long it is, in bytes.
    pub byte_length: Whole,
    /// From the start of one element to the next, in bytes.
    pub byte_stride: Option<Whole>,
    /// What extensions add.
    pub extensions: ViewExtensions,
}

/// What extensions add to a part of a buffer.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct ViewExtensions {
    /// It is compressed.
    #[serde(rename = "EXT_meshopt_compression")]
    pub meshopt: Option<IgnoredAny>,
    /// It is compressed, by the extension's later name; files may have both.
    #[serde(rename = "KHR_meshopt_compression")]
    pub meshopt_khr: Option<IgnoredAny>,
}

/// Bytes.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Buffer {
    /// Where they are, unless beside the JSON.
    pub uri: Option<String>,
}

/// A whole number from 0 on, also written as a fraction (`5.0`), as JSON allows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Whole(pub usize);

impl<'de> Deserialize<'de> for Whole {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Whole, D::Error> {
        struct Reader;
        impl Visitor<'_> for Reader {
            type Value = Whole;

            fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                out.write_str("a whole number from 0 on")
            }

            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Whole, E> {
                usize::try_from(value)
                    .map(Whole)
                    .map_err(|_| E::invalid_value(de::Unexpected::Unsigned(value), &self))
            }

            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Whole, E> {
                // 2^53: whole numbers up to there are exact.
                let is_whole = value.fract() == 0.0 && (0.0..=9007199254740992.0).contains(&value);
                if is_whole {
                    Ok(Whole(value as usize))
                } else {
                    Err(E::invalid_value(de::Unexpected::Float(value), &self))
                }
            }
        }
        deserializer.deserialize_any(Reader)
    }
}

/// A number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Number(pub f64);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Number, D::Error> {
        struct Reader;
        impl Visitor<'_> for Reader {
            type Value = Number;

            fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                out.write_str("a number")
            }

            fn visit_f64<E>(self, value: f64) -> Result<Number, E> {
                Ok(Number(value))
            }

            fn visit_u64<E>(self, value: u64) -> Result<Number, E> {
                Ok(Number(value as f64))
            }

            fn visit_i64<E>(self, value: i64) -> Result<Number, E> {
                Ok(Number(value as f64))
            }
        }
        deserializer.deserialize_any(Reader)
    }
}

/// The attributes of a part of a mesh that are used, and the first of those that no version of glTF
/// knows.
#[derive(Debug, Default, PartialEq)]
pub struct Attributes {
    /// Places.
    pub position: Option<Whole>,
    /// Normals.
    pub normal: Option<Whole>,
    /// An application's own: its name starts with `_`.
    pub custom: Option<String>,
}

impl<'de> Deserialize<'de> for Attributes {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Attributes, D::Error> {
        struct Reader;
        impl<'de> Visitor<'de> for Reader {
            type Value = Attributes;

            fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                out.write_str("an object")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Attributes, A::Error> {
                let mut attributes = Attributes::default();
                while let Some(Text(name)) = map.next_key()? {
                    match &*name {
                        "POSITION" => attributes.position = map.next_value()?,
                        "NORMAL" => attributes.normal = map.next_value()?,
                        _ => {
                            map.next_value::<IgnoredAny>()?;
                            if name.starts_with('_') && attributes.custom.is_none() {
                                attributes.custom = Some(name.into_owned());
                            }
                        }
                    }
                }
                Ok(attributes)
            }
        }
        deserializer.deserialize_map(Reader)
    }
}

/// A string that is copied only where it has escapes.
#[derive(Deserialize)]
#[serde(transparent)]
struct Text<'a>(#[serde(borrow)] Cow<'a, str>);

/// Names of extensions, each once.
#[derive(Debug, Default, PartialEq)]
pub struct Names(pub BTreeSet<String>);

impl<'de> Deserialize<'de> for Names {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Names, D::Error> {
        struct Reader;
        impl<'de> Visitor<'de> for Reader {
            type Value = Names;

            fn expecting(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
                out.write_str("a list of names")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Names, A::Error> {
                let mut names = BTreeSet::new();
                while let Some(Text(name)) = list.next_element()? {
                    if names.len() == MOST_EXTENSIONS {
                        return Err(de::Error::custom(format!(
                            "more than {MOST_EXTENSIONS} extensions"
                        )));
                    }
                    if !names.contains(&*name) {
                        names.insert(name.into_owned());
                    }
                }
                Ok(Names(names))
            }
        }
        deserializer.deserialize_seq(Reader)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_needed_may_hold_anything() {
        let text = r#"{"extras": [1, {"nodes": 3}], "asset": {"version": "2.0", "extras": null}, "textures": [{}, 7],
            "animations": [{"channels": [{"target": {}}]}], "nodes": [{"mesh": 0.0, "name": "caf?", "extras": "x"}],
            "accessors": [{"count": 3e0, "type": "VEC3", "min": "?"}], "materials": "\ud800", "scenes": [{}]}"#;
        // A name in Latin-1.
        let text: Vec<u8> =
            text.bytes().map(|byte| if byte == b'?' { 0xe9 } else { byte }).collect();
        let document = parse(&text).expect("it is JSON");
        assert_eq!(document.nodes[0].mesh, Some(Whole(0)));
        assert_eq!(document.accessors[0].count, Some(Whole(3)));
        assert_eq!((document.scenes.len(), document.scenes[0].nodes.len()), (1, 0));
    }

    #[test]
    fn what_is_needed_has_its_type() {
        for (text, said) in [
            (r#"{"scene": -1}"#, "expected a whole number from 0 on"),
            (r#"{"scene": 0.5}"#, "expected a whole number from 0 on"),
            (r#"{"scene": "0"}"#, "expected a whole number from 0 on"),
            (r#"{"nodes": [{"scale": [1, 2, "3"]}]}"#, "expected a number"),
            (r#"{"nodes": [{"matrix": [1]}]}"#, "expected an array of length 16"),
            (r#"{"nodes": [7]}"#, "expected an object"),
            (r#"{"extensionsUsed": [7]}"#, "expected a string"),
            ("{", "EOF while parsing an object"),
        ] {
            let problem = parse(text.as_bytes()).expect_err("it is wrong").to_string();
            assert!(
                problem.starts_with("its JSON is wrong: ") && problem.contains(said),
                "{text}: {problem}"
            );
        }
    }
}

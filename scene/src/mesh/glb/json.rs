//! The part of glTF 2.0's JSON that is shown.
//!
//! What is not declared here (`extras`, unknown extensions) is skipped, whatever it contains, and a
//! [`Part`] is what a file can be drawn without. What is declared may be absent wherever its use can be refused more
//! clearly than its absence.
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt;

use serde::Deserialize;
use serde::de::{self, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::part::{Part, Reference};
use crate::mesh::error::MeshProblem;

/// Largest number of objects in the JSON: each of them takes at most some hundred bytes of memory.
const MAX_OBJECTS: usize = 2_000_000;

/// Largest number of extensions that a file may name.
const MAX_EXTENSIONS: usize = 1000;

/// Reads the JSON text.
///
/// # Errors
/// Text that is not JSON, or in which something needed has a wrong type.
pub fn parse(bytes: &[u8]) -> Result<Document, MeshProblem> {
    let objects = bytes.iter().filter(|byte| **byte == b'{').count();
    if objects > MAX_OBJECTS {
        let text = format!("its JSON has {objects} objects; at most {MAX_OBJECTS} are read");
        return Err(MeshProblem::Syntax(text));
    }
    // Names in other encodings are not needed. Some programs pad with zeros.
    let text = String::from_utf8_lossy(bytes);
    let text = text.trim_start_matches('\u{feff}').trim_end_matches(['\0', ' ']);
    serde_json::from_str(text)
        .map_err(|error| MeshProblem::Syntax(format!("its JSON is wrong: {error}")))
}

/// The whole document.
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
    /// The list of materials.
    pub materials: Part,
    /// The list of cameras.
    pub cameras: Part,
    /// Extensions of the document.
    pub extensions: Part,
    /// The list of animations.
    pub animations: Part,
    /// Extensions that the file uses.
    pub extensions_used: Names,
    /// Extensions that the file requires.
    pub extensions_required: Names,
}

/// The file's metadata.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
pub struct Asset {
    /// The version of glTF that it was written for.
    pub version: Option<String>,
    /// The least version of glTF that it requires.
    pub min_version: Option<String>,
}

/// A scene.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Scene {
    /// The roots of its node trees.
    pub nodes: Vec<Whole>,
}

/// A node of a tree.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Node {
    /// The nodes below it.
    pub children: Vec<Whole>,
    /// The mesh that is drawn there.
    pub mesh: Option<Whole>,
    /// The camera that is there.
    pub camera: Reference,
    /// The skin that moves the mesh's vertices.
    pub skin: Option<IgnoredAny>,
    /// The matrix from its coordinates to the parent's, column by column.
    pub matrix: Option<Box<[Number; 16]>>,
    /// The translation, if there is no matrix.
    pub translation: Option<[Number; 3]>,
    /// The rotation as a quaternion x, y, z, w.
    pub rotation: Option<[Number; 4]>,
    /// The scale factors.
    pub scale: Option<[Number; 3]>,
    /// Extensions of the node.
    pub extensions: Option<Box<NodeExtensions>>,
}

/// Extensions of a node.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct NodeExtensions {
    /// Instances: the mesh is drawn many times.
    #[serde(rename = "EXT_mesh_gpu_instancing")]
    pub instancing: Option<Instancing>,
    /// Visibility: the node may be hidden.
    #[serde(rename = "KHR_node_visibility")]
    pub visibility: Option<Visibility>,
    /// A light that is there.
    #[serde(rename = "KHR_lights_punctual")]
    pub light: Part,
}

/// The instances of a mesh.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Instancing {
    /// Accessors with a value for each instance.
    pub attributes: InstanceAttributes,
}

/// Accessors with a value for each instance of a mesh.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct InstanceAttributes {
    /// Translations.
    #[serde(rename = "TRANSLATION")]
    pub translation: Option<Whole>,
    /// Quaternions x, y, z, w.
    #[serde(rename = "ROTATION")]
    pub rotation: Option<Whole>,
    /// Scale factors.
    #[serde(rename = "SCALE")]
    pub scale: Option<Whole>,
}

/// The visibility of a node.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Visibility {
    /// Whether it is visible; true by default.
    pub visible: Option<bool>,
}

/// A mesh.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Mesh {
    /// Its parts.
    pub primitives: Vec<Primitive>,
}

/// A part of a mesh.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Primitive {
    /// Accessors with a value for each vertex.
    pub attributes: Attributes,
    /// The accessor with the indices of vertices.
    pub indices: Option<Whole>,
    /// Points, lines or triangles.
    pub mode: Option<Whole>,
    /// The material.
    pub material: Reference,
    /// Morph targets of the vertices.
    pub targets: Vec<IgnoredAny>,
    /// Extensions of the part.
    pub extensions: PrimitiveExtensions,
}

/// Extensions of a part of a mesh.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct PrimitiveExtensions {
    /// Draco compression of its vertices.
    #[serde(rename = "KHR_draco_mesh_compression")]
    pub draco: Option<IgnoredAny>,
}

/// An accessor: numbers of one type, one or several for each element.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
pub struct Accessor {
    /// The view that contains them; without one, all are 0.
    pub buffer_view: Option<Whole>,
    /// Offset of the first element in the view, in bytes.
    pub byte_offset: Whole,
    /// The type of a number.
    pub component_type: Option<Whole>,
    /// Whether integers represent fractions.
    pub normalized: bool,
    /// Number of elements.
    pub count: Option<Whole>,
    /// The kind of element, which determines how many numbers it has.
    #[serde(rename = "type")]
    pub kind: Option<String>,
    /// The smallest of all elements.
    pub min: Option<IgnoredAny>,
    /// The largest of all elements.
    pub max: Option<IgnoredAny>,
    /// Elements that replace others.
    pub sparse: Option<Box<Sparse>>,
}

/// Elements of an accessor that replace others.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Sparse {
    /// How many exist.
    pub count: Whole,
    /// Indices of the replaced elements.
    pub indices: SparsePart,
    /// Their values.
    pub values: SparsePart,
}

/// The place of indices or values of replacing elements.
#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
pub struct SparsePart {
    /// The view.
    pub buffer_view: Option<Whole>,
    /// Offset of the first one in the view, in bytes.
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
    /// Offset in the buffer, in bytes.
    pub byte_offset: Whole,
    /// Length in bytes.
    pub byte_length: Whole,
    /// Distance from the start of one element to the next, in bytes.
    pub byte_stride: Option<Whole>,
    /// Extensions of the view.
    pub extensions: ViewExtensions,
}

/// Extensions of a buffer view.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct ViewExtensions {
    /// Compression by meshopt.
    #[serde(rename = "EXT_meshopt_compression")]
    pub meshopt: Option<IgnoredAny>,
    /// Compression by meshopt, under the extension's later name; files may have both.
    #[serde(rename = "KHR_meshopt_compression")]
    pub meshopt_khr: Option<IgnoredAny>,
}

/// A buffer of bytes.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct Buffer {
    /// The URI of its bytes, unless they are in the binary chunk.
    pub uri: Option<String>,
}

/// An integer from 0, which JSON may also write as a fraction (`5.0`).
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
                // Integers up to 2^53 are exact.
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

/// The attributes of a part of a mesh that are used, and the first one that no version of glTF has.
#[derive(Debug, Default, PartialEq)]
pub struct Attributes {
    /// Positions.
    pub position: Option<Whole>,
    /// Normals.
    pub normal: Option<Whole>,
    /// An application's own attribute, whose name starts with `_`.
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

/// A string that is copied only if it has escapes.
#[derive(Deserialize)]
#[serde(transparent)]
struct Text<'a>(#[serde(borrow)] Cow<'a, str>);

/// Names of extensions without repetition.
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
                    if names.len() == MAX_EXTENSIONS {
                        return Err(de::Error::custom(format!(
                            "more than {MAX_EXTENSIONS} extensions"
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
        // The name is in Latin-1.
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

//! Binary glTF 2.0, `.glb`, through the `gltf` crate.
use glam::{DMat3, DMat4, DVec3};
use gltf::accessor::{DataType, Dimensions};
use gltf::mesh::Mode;
use gltf::{Accessor, Document, Gltf, Node, Primitive, Semantic};

use super::Mesh;
use super::error::{Located, MeshProblem};
use super::normals::normal_matrix;
use super::polygons::{Corner, Polygons};
use super::warning::Notices;

/// Bytes of a `.glb` file's header.
const HEADER: usize = 12;

/// Nodes that may be visited in all, and levels they may be nested.
const MOST_NODES: usize = 1_000_000;

/// Reads a `.glb` file: every triangle of the scene's meshes, moved where its nodes put it.
///
/// Where a primitive lacks normals, vertices at the same place are joined, so that normals are shared across seams.
///
/// # Errors
/// A file that is not a valid `.glb`, or that keeps its geometry compressed, sparse or in other files.
pub(super) fn parse(bytes: &[u8], notices: &mut Notices) -> Result<Mesh, Located> {
    let polygons = polygons(bytes)?;
    let all = if polygons.has_all_normals() { polygons } else { polygons.welded() };
    all.into_mesh(notices, &|_| None)
}

fn polygons(bytes: &[u8]) -> Result<Polygons, MeshProblem> {
    check_header(bytes)?;
    let syntax = |error: gltf::Error| MeshProblem::Syntax(error.to_string().trim_end_matches([';', ' ']).to_owned());
    let Gltf { document, blob } = Gltf::from_slice_without_validation(bytes).map_err(syntax)?;
    check_attributes(document.as_json())?;
    let document = Document::from_json(document.into_json()).map_err(syntax)?;
    let blob = blob.as_deref().unwrap_or_default();
    let mut polygons = Polygons::default();
    for (node, place) in placed_nodes(&document)? {
        for primitive in node.mesh().iter().flat_map(|mesh| mesh.primitives()) {
            add(&mut polygons, &primitive, place, blob)?;
        }
    }
    Ok(polygons)
}

/// Checks what the crate subtracts from without looking: the total length has to hold the header.
fn check_header(bytes: &[u8]) -> Result<(), MeshProblem> {
    if !bytes.starts_with(b"glTF") {
        return Err(MeshProblem::Syntax("it does not start with `glTF`".into()));
    }
    let length: Option<[u8; 4]> = bytes.get(HEADER - 4..HEADER).and_then(|b| b.try_into().ok());
    match length.map(|b| u32::from_le_bytes(b) as usize) {
        None => Err(MeshProblem::Truncated(format!("a .glb has a header of {HEADER} bytes"))),
        Some(stated) if stated > bytes.len() => {
            let text = format!("its header states {stated} bytes; the file has {}", bytes.len());
            Err(MeshProblem::Truncated(text))
        }
        Some(stated) if stated < HEADER => Err(MeshProblem::Syntax(format!("its header states {stated} bytes"))),
        Some(_) => Ok(()),
    }
}

/// Checks that accessors which primitives name are there: the crate's validation indexes with them before it checks them.
fn check_attributes(root: &gltf::json::Root) -> Result<(), MeshProblem> {
    let primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    let mut accessors = primitives.flat_map(|primitive| primitive.attributes.values());
    match accessors.find(|accessor| accessor.value() >= root.accessors.len()) {
        Some(accessor) => Err(MeshProblem::Syntax(format!("a primitive names accessor {}, which is not there", accessor.value()))),
        None => Ok(()),
    }
}

/// The nodes of the default scene (else of all scenes), each with the transform to the scene's coordinates.
fn placed_nodes(document: &Document) -> Result<Vec<(Node<'_>, DMat4)>, MeshProblem> {
    let roots: Vec<Node<'_>> = match document.default_scene() {
        Some(scene) => scene.nodes().collect(),
        None => document.scenes().flat_map(|scene| scene.nodes()).collect(),
    };
    let mut waiting: Vec<(Node<'_>, DMat4)> = roots.into_iter().map(|node| (node, DMat4::IDENTITY)).collect();
    let mut seen = vec![false; document.nodes().count()];
    let mut placed = Vec::new();
    while let Some((node, parent)) = waiting.pop() {
        // The format asks for a tree; a node met twice could be its own ancestor.
        if std::mem::replace(&mut seen[node.index()], true) || placed.len() >= MOST_NODES {
            return Err(MeshProblem::Syntax(format!("node {} is in the scene twice", node.index())));
        }
        let place = parent * DMat4::from_cols_array_2d(&node.transform().matrix().map(|c| c.map(f64::from)));
        waiting.extend(node.children().map(|child| (child, place)));
        placed.push((node, place));
    }
    Ok(placed)
}

/// Adds the triangles of a primitive; points and lines are left out.
fn add(polygons: &mut Polygons, primitive: &Primitive<'_>, place: DMat4, blob: &[u8]) -> Result<(), MeshProblem> {
    if !matches!(primitive.mode(), Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
        return Ok(());
    }
    let Some(positions) = vectors(primitive, &Semantic::Positions, blob)? else {
        return Err(MeshProblem::Syntax("a primitive has no positions".into()));
    };
    let normals = vectors(primitive, &Semantic::Normals, blob)?.unwrap_or_default();
    let indices = match indices(primitive, blob)? {
        Some(indices) => indices,
        None => (0..positions.len() as u32).collect(),
    };
    if let Some(&index) = indices.iter().find(|&&i| i as usize >= positions.len()) {
        let face = polygons.faces().count();
        return Err(MeshProblem::Index { face, what: "vertex", index, count: positions.len() });
    }
    let linear = DMat3::from_mat4(place);
    let to_normals = normal_matrix(linear);
    let (first, first_normal) = (polygons.positions.len() as u32, polygons.normals.len() as u32);
    polygons.positions.extend(positions.iter().map(|&p| place.transform_point3(p)));
    polygons.normals.extend(normals.iter().map(|&n| to_normals * n));
    let corner = |index: u32| Corner { vertex: first + index, normal: normals.get(index as usize).map(|_| first_normal + index) };
    for triangle in triangles(primitive.mode(), &indices) {
        // A mirror turns triangles around [glTF 2.0, 3.7.4].
        let [a, b, c] = if linear.determinant() < 0.0 { swapped(triangle) } else { triangle };
        polygons.push([a, b, c].map(corner));
    }
    Ok(())
}

fn swapped([a, b, c]: [u32; 3]) -> [u32; 3] {
    [a, c, b]
}

/// Triangles of a list, strip or fan [glTF 2.0, 3.7.2.1]; indices left over at the end are left out.
fn triangles(mode: Mode, indices: &[u32]) -> Vec<[u32; 3]> {
    match mode {
        Mode::TriangleStrip => {
            let strip = indices.windows(3).enumerate();
            strip.map(|(i, t)| [t[0], t[1 + i % 2], t[2 - i % 2]]).collect()
        }
        Mode::TriangleFan => indices.windows(2).skip(1).map(|t| [t[0], t[1], indices[0]]).collect(),
        _ => indices.as_chunks::<3>().0.to_vec(),
    }
}

/// The vectors of an attribute, if the primitive has it.
fn vectors(primitive: &Primitive<'_>, semantic: &Semantic, blob: &[u8]) -> Result<Option<Vec<DVec3>>, MeshProblem> {
    let Some(accessor) = primitive.get(semantic) else { return Ok(None) };
    if (accessor.data_type(), accessor.dimensions()) != (DataType::F32, Dimensions::Vec3) {
        return Err(MeshProblem::Unsupported("positions or normals that are not three 32-bit floats".into()));
    }
    let component = |bytes: &[u8], k: usize| {
        // Elements of this type have 12 bytes.
        let bytes = [bytes[4 * k], bytes[4 * k + 1], bytes[4 * k + 2], bytes[4 * k + 3]];
        f64::from(f32::from_le_bytes(bytes))
    };
    let vector = |bytes: &[u8]| DVec3::new(component(bytes, 0), component(bytes, 1), component(bytes, 2));
    Ok(Some(elements(&accessor, blob)?.map(vector).collect()))
}

/// A primitive's indices, if it has them.
fn indices(primitive: &Primitive<'_>, blob: &[u8]) -> Result<Option<Vec<u32>>, MeshProblem> {
    let Some(accessor) = primitive.indices() else { return Ok(None) };
    if accessor.dimensions() != Dimensions::Scalar {
        return Err(MeshProblem::Syntax("indices are not single numbers".into()));
    }
    let integer = |bytes: &[u8]| bytes.iter().rev().fold(0_u32, |n, &byte| n << 8 | u32::from(byte));
    match accessor.data_type() {
        DataType::U8 | DataType::U16 | DataType::U32 => Ok(Some(elements(&accessor, blob)?.map(integer).collect())),
        _ => Err(MeshProblem::Syntax("indices are not unsigned integers".into())),
    }
}

/// The bytes of each element of an accessor, after checking that all of them are there.
fn elements<'b>(accessor: &Accessor<'_>, blob: &'b [u8]) -> Result<impl Iterator<Item = &'b [u8]> + use<'b>, MeshProblem> {
    if accessor.sparse().is_some() {
        return Err(MeshProblem::Unsupported("sparse accessors".into()));
    }
    let view = accessor.view().ok_or_else(|| MeshProblem::Unsupported("compressed geometry".into()))?;
    if !matches!(view.buffer().source(), gltf::buffer::Source::Bin) {
        return Err(MeshProblem::Unsupported("geometry in another file".into()));
    }
    let (count, size) = (accessor.count(), accessor.size());
    let stride = view.stride().unwrap_or(size).max(size);
    let in_view = blob.get(view.offset()..).and_then(|rest| rest.get(..view.length()));
    let data = in_view.and_then(|bytes| bytes.get(accessor.offset()..));
    let needed = count.checked_sub(1).and_then(|gaps| gaps.checked_mul(stride)?.checked_add(size));
    match (data, needed) {
        (Some(data), Some(needed)) if needed <= data.len() => Ok((0..count).map(move |i| &data[i * stride..i * stride + size])),
        _ => Err(MeshProblem::Truncated(format!("accessor {} reaches beyond its data", accessor.index()))),
    }
}

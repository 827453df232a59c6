//! The triangles of a mesh's parts.
use std::collections::BTreeMap;

use super::accessors::{Component, Elements, is_index};
use super::buffers::Buffers;
use super::extensions::unread;
use super::json::{Document, Primitive, Whole};
use crate::mesh::error::MeshProblem;
use crate::mesh::limits::MAX_TRIANGLES;
use crate::mesh::warning::{Notices, quoted};

/// The extension by which positions and normals may be integers.
const QUANTIZATION: &str = "KHR_mesh_quantization";

/// Largest total number of elements that accessors replace.
const MAX_REPLACED: usize = 3 * MAX_TRIANGLES;

/// The order of triangles' corners [glTF 2.0, 3.7.2.1].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    /// Three corners for each triangle.
    List,
    /// Each corner makes a triangle with the two before it; every other triangle is reversed.
    Strip,
    /// Each corner makes a triangle with the one before it and the first one.
    Fan,
}

impl Mode {
    /// Number of triangles that `corners` corners make; remaining corners are ignored.
    fn triangles(self, corners: usize) -> usize {
        match self {
            Mode::List => corners / 3,
            Mode::Strip | Mode::Fan => corners.saturating_sub(2),
        }
    }

    /// The corners of a triangle, by their number.
    fn corners(self, triangle: usize) -> [usize; 3] {
        let k = triangle;
        match self {
            Mode::List => [3 * k, 3 * k + 1, 3 * k + 2],
            Mode::Strip => [k, k + 1 + k % 2, k + 2 - k % 2],
            Mode::Fan => [k + 1, k + 2, 0],
        }
    }
}

/// A part of a mesh that has triangles.
#[derive(Clone, Copy, Debug)]
pub struct Drawable<'p, 'a> {
    mode: Mode,
    /// Positions of vertices.
    pub positions: &'p Elements<'a>,
    /// Normals of vertices, if it has them.
    pub normals: Option<&'p Elements<'a>>,
    indices: Option<&'p Elements<'a>>,
    /// The material's number, if it has one.
    pub material: Option<usize>,
    /// Number of triangles; at least one.
    pub triangles: usize,
}

impl Drawable<'_, '_> {
    /// The vertices of a triangle, which are checked to exist.
    ///
    /// # Errors
    /// A vertex that does not exist.
    pub fn triangle(&self, number: usize) -> Result<[usize; 3], MeshProblem> {
        let corners = self.mode.corners(number);
        let Some(indices) = self.indices else { return Ok(corners) };
        let vertices = corners.map(|corner| indices.integer(corner) as usize);
        match vertices.iter().position(|&vertex| vertex >= self.positions.count) {
            None => Ok(vertices),
            Some(k) => Err(MeshProblem::Syntax(format!(
                "element {} of accessor {} names vertex {}, but accessor {} has only {} (all counted from 0)",
                corners[k],
                indices.number,
                vertices[k],
                self.positions.number,
                self.positions.count
            ))),
        }
    }
}

/// Accessors that have been looked up, each once.
pub struct Accessors<'a> {
    document: &'a Document,
    buffers: &'a Buffers<'a>,
    known: BTreeMap<usize, Elements<'a>>,
    /// Number of replaced elements in all of them.
    replaced: usize,
}

impl<'a> Accessors<'a> {
    /// The accessors of a document, none of which has been looked up yet.
    pub fn new(document: &'a Document, buffers: &'a Buffers<'a>) -> Accessors<'a> {
        Accessors { document, buffers, known: BTreeMap::new(), replaced: 0 }
    }

    /// Looks up an accessor.
    ///
    /// # Errors
    /// The errors of [`Elements::new`], and more replaced elements than triangles could have
    /// corners.
    pub fn look_up(&mut self, number: Whole) -> Result<(), MeshProblem> {
        if self.known.contains_key(&number.0) {
            return Ok(());
        }
        let elements = Elements::new(self.document, self.buffers, number)?;
        self.replaced += elements.replaced_count();
        if self.replaced > MAX_REPLACED {
            let text = format!(
                "its accessors replace {} elements; at most {MAX_REPLACED} are read",
                self.replaced
            );
            return Err(MeshProblem::Syntax(text));
        }
        self.known.insert(number.0, elements);
        Ok(())
    }

    /// An accessor that was looked up.
    pub fn get(&self, number: Whole) -> Option<&Elements<'a>> {
        self.known.get(&number.0)
    }

    /// Looks up the accessors of a mesh's triangles, and adds notes about what is ignored.
    ///
    /// # Errors
    /// A mesh or accessor that does not exist.
    pub fn look_up_mesh(
        &mut self,
        number: usize,
        notices: &mut Notices,
    ) -> Result<(), MeshProblem> {
        let document = self.document;
        let missing = || {
            MeshProblem::Syntax(format!(
                "mesh {number} is named, but there are only {}",
                document.meshes.len()
            ))
        };
        for primitive in &document.meshes.get(number).ok_or_else(missing)?.primitives {
            note(primitive, number, notices);
            if mode(primitive)?.is_none() {
                notices.add("mode", None, || {
                    format!("a part of mesh {number} is points or lines; it is left out")
                });
                continue;
            }
            let Some(positions) = primitive.attributes.position else {
                notices.add("position", None, || {
                    format!("a part of mesh {number} has no positions; it is left out")
                });
                continue;
            };
            self.look_up(positions)?;
            let others = [primitive.attributes.normal, primitive.indices];
            others.into_iter().flatten().try_for_each(|accessor| self.look_up(accessor))?;
            self.note_bounds(positions, notices);
        }
        Ok(())
    }

    /// Adds a note if positions do not state their bounds, which the format requires but which are
    /// not needed here.
    fn note_bounds(&self, positions: Whole, notices: &mut Notices) {
        let accessor = self.document.accessors.get(positions.0);
        if accessor.is_some_and(|accessor| accessor.min.is_none() || accessor.max.is_none()) {
            let text = || {
                format!(
                    "accessor {} of positions has no `min` and `max`; its numbers are taken as they are",
                    positions.0
                )
            };
            notices.add("bounds", None, text);
        }
    }

    /// The parts of a mesh that have triangles; its accessors must have been looked up.
    ///
    /// # Errors
    /// Positions, normals or indices of the wrong types, or compressed ones.
    pub fn drawables(&self, mesh: usize) -> Result<Vec<Drawable<'_, 'a>>, MeshProblem> {
        let primitives = self.document.meshes.get(mesh).map_or(&[][..], |mesh| &mesh.primitives);
        let mut drawables = Vec::new();
        for primitive in primitives {
            drawables.extend(self.drawable(primitive)?.filter(|drawable| drawable.triangles > 0));
        }
        Ok(drawables)
    }

    fn drawable(&self, primitive: &Primitive) -> Result<Option<Drawable<'_, 'a>>, MeshProblem> {
        let Some(mode) = mode(primitive)? else { return Ok(None) };
        let Some(positions) = primitive.attributes.position.and_then(|number| self.get(number))
        else {
            return Ok(None);
        };
        if primitive.extensions.draco.is_some() && positions.has_no_bytes() {
            return Err(unread("KHR_draco_mesh_compression"));
        }
        let Document { extensions_used, extensions_required, .. } = self.document;
        let is_quantized =
            [extensions_used, extensions_required].iter().any(|all| all.0.contains(QUANTIZATION));
        let may_be = |component| {
            component == Component::F32 || (is_quantized && component != Component::U32)
        };
        let normals = primitive.attributes.normal.and_then(|number| self.get(number));
        for vectors in [Some(positions), normals].into_iter().flatten() {
            if vectors.kind != "VEC3" || !may_be(vectors.component) {
                return Err(MeshProblem::Unsupported(
                    "positions or normals that are not three 32-bit floats".into(),
                ));
            }
        }
        let indices = primitive.indices.and_then(|number| self.get(number));
        if let Some(indices) =
            indices.filter(|indices| indices.kind != "SCALAR" || !is_index(indices.component))
        {
            return Err(MeshProblem::Syntax(format!(
                "the indices of accessor {} are not unsigned integers",
                indices.number
            )));
        }
        let triangles = mode.triangles(indices.unwrap_or(positions).count);
        let material = primitive.material.0;
        Ok(Some(Drawable { mode, positions, normals, indices, material, triangles }))
    }
}

/// The order of a part's corners; `None` for points or lines.
fn mode(primitive: &Primitive) -> Result<Option<Mode>, MeshProblem> {
    match primitive.mode.map_or(4, |mode| mode.0) {
        0..=3 => Ok(None),
        4 => Ok(Some(Mode::List)),
        5 => Ok(Some(Mode::Strip)),
        6 => Ok(Some(Mode::Fan)),
        other => Err(MeshProblem::Syntax(format!(
            "the mode of a primitive is {other}; modes are 0 to 6"
        ))),
    }
}

/// Adds notes about data of a part that are not geometry.
fn note(primitive: &Primitive, mesh: usize, notices: &mut Notices) {
    if let Some(name) = &primitive.attributes.custom {
        notices.add("attribute", None, || {
            format!("the attribute {} of mesh {mesh} is left out", quoted(name.as_bytes()))
        });
    }
    if !primitive.targets.is_empty() {
        notices.add("targets", None, || {
            format!("mesh {mesh} has morph targets; it is drawn without them")
        });
    }
}

//! Faces as mesh files state them, before they are checked and split into triangles.
use glam::DVec3;

use super::error::{Item, Located, MeshProblem};
use super::indexed::Mesh;
use super::limits::{FARTHEST, MAX_TRIANGLES};
use super::normals::{direction, newell, vertex_normals};
use super::triangulate::{MAX_CROSSINGS, Triangulation, triangulate};
use super::warning::Notices;
use super::weld::weld;
use crate::{Facet, PartialMaterial};

/// What happens to a corner without a usable normal.
const INSTEAD: &str = "corners that name it get the normal that the faces around their vertex make";

/// A corner of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Index of its position.
    pub vertex: u32,
    /// Index of its normal, where the file gives one.
    pub normal: Option<u32>,
}

/// Positions, normals and faces with any number of corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polygons {
    /// Positions of vertices.
    pub positions: Vec<DVec3>,
    /// Normals of any length.
    pub normals: Vec<DVec3>,
    /// The corners of all faces, one face after the other.
    corners: Vec<Corner>,
    /// For each face its end in `corners`.
    ends: Vec<usize>,
    /// Materials, to which faces refer; empty for a file that states none.
    pub materials: Vec<PartialMaterial>,
    /// The material of the faces that are added next, an index of `materials`.
    pub material: u32,
    /// For each face its material.
    face_materials: Vec<u32>,
}

impl Polygons {
    /// Adds a face; one with fewer than three corners is a point or a line and is left out.
    pub fn push(&mut self, corners: impl IntoIterator<Item = Corner>) {
        let start = self.corners.len();
        self.corners.extend(corners);
        if self.corners.len() - start < 3 {
            self.corners.truncate(start);
        } else {
            self.ends.push(self.corners.len());
            self.face_materials.push(self.material);
        }
    }

    /// The faces, each as its corners.
    pub(super) fn faces(&self) -> impl Iterator<Item = &[Corner]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.corners[start..end])
    }

    /// Joins vertices at the same place, for formats that do not share vertices between faces.
    pub fn welded(mut self) -> Polygons {
        let (positions, indices) = weld(&self.positions);
        for corner in &mut self.corners {
            // A wrong index stays wrong, and is reported later.
            corner.vertex = indices.get(corner.vertex as usize).copied().unwrap_or(u32::MAX);
        }
        self.positions = positions;
        self
    }

    /// Whether each corner has a normal.
    pub fn has_all_normals(&self) -> bool {
        self.corners.iter().all(|corner| corner.normal.is_some())
    }

    /// Checks everything, splits faces into triangles and fills in missing normals (methods A1,
    /// A2).
    ///
    /// `line` gives the line of an item in the file, counted from 1, if it has one.
    ///
    /// # Errors
    /// Numbers that are not finite or too large, indices out of range, too many triangles, or none
    /// with an area.
    pub(super) fn into_mesh(
        self,
        notices: &mut Notices,
        line: &dyn Fn(Item) -> Option<usize>,
    ) -> Result<Mesh, Located> {
        self.made(notices, line)
            .map_err(|problem| Located { line: problem.item().and_then(line), problem })
    }

    fn made(
        mut self,
        notices: &mut Notices,
        line: &dyn Fn(Item) -> Option<usize>,
    ) -> Result<Mesh, MeshProblem> {
        self.check()?;
        self.drop_missing_normals(notices, line);
        let split = self.split(notices, line)?;
        if split.pieces.is_empty() {
            return Err(MeshProblem::Empty);
        }
        Ok(self.with_normals(split))
    }

    /// Removes references to normals that do not exist or have no direction, so that those corners
    /// get the normal computed from the faces around their vertex.
    pub(super) fn drop_missing_normals(
        &mut self,
        notices: &mut Notices,
        line: &dyn Fn(Item) -> Option<usize>,
    ) {
        let count = self.normals.len();
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        for (face, (start, &end)) in starts.zip(&self.ends).enumerate() {
            for corner in &mut self.corners[start..end] {
                let Some(index) = corner.normal.map(|normal| normal as usize) else { continue };
                match self.normals.get(index) {
                    Some(&normal) if direction_of_any_length(normal).is_some() => continue,
                    Some(normal) => notices.add("normal without direction", line(Item::Normal(index)), || {
                        format!("a normal is {normal}, which is no direction; {INSTEAD}")
                    }),
                    None => notices.add("no such normal", line(Item::Face(face)), || {
                        format!("a face names a normal that is not among the {count} of the file; {INSTEAD}")
                    }),
                }
                corner.normal = None;
            }
        }
    }

    /// Checks the items that faces name; vertices that no face names may be anything.
    fn check(&self) -> Result<(), MeshProblem> {
        for (face, corners) in self.faces().enumerate() {
            for corner in corners {
                check_vertex(face, corner.vertex, &self.positions)?;
            }
        }
        Ok(())
    }

    /// Splits all faces into triangles.
    fn split(
        &self,
        notices: &mut Notices,
        line: &dyn Fn(Item) -> Option<usize>,
    ) -> Result<Split, MeshProblem> {
        let mut split = Split::with_capacity(self.ends.len());
        for (face, corners) in self.faces().enumerate() {
            let places: Vec<DVec3> =
                corners.iter().map(|c| self.positions[c.vertex as usize]).collect();
            let Some(normal) = newell(&places).or_else(|| normal_of_a_part(&places)) else {
                continue;
            };
            let tangled = MeshProblem::Tangled { face, corners: corners.len() };
            let crossings_left = MAX_CROSSINGS.saturating_sub(split.crossings.len());
            let triangulation = triangulate(&places, normal, crossings_left).ok_or(tangled)?;
            if triangulation.overlaps {
                notices.add("polygon that covers itself", line(Item::Face(face)), || {
                    format!(
                        "a polygon of {} corners crosses or covers itself; what an odd number of its edges surrounds is drawn",
                        corners.len()
                    )
                });
            }
            let material = self.face_materials[face];
            split.push(Face { corners, normal, material }, triangulation, self.positions.len());
            if split.pieces.len() > MAX_TRIANGLES {
                let corners_left = self.corners.len() - self.ends[face];
                let faces_left = self.ends.len() - face - 1;
                let all = split.pieces.len() + corners_left - 2 * faces_left;
                return Err(MeshProblem::TooManyTriangles(all));
            }
        }
        Ok(split)
    }

    fn with_normals(mut self, split: Split) -> Mesh {
        let Split { pieces, flats, crossings } = split;
        let shared = if self.has_all_normals() {
            vec![None; self.positions.len()]
        } else {
            vertex_normals(
                self.positions.len(),
                flats.iter().map(|f| (f.vertices.as_slice(), Some(f.normal))),
            )
        };
        let normal_at = |corner: Corner, face: DVec3| {
            let given =
                corner.normal.and_then(|n| direction_of_any_length(self.normals[n as usize]));
            given.or_else(|| *shared.get(corner.vertex as usize)?).unwrap_or(face)
        };
        let normals =
            pieces.iter().map(|p| p.corners.map(|c| normal_at(c, flats[p.flat].normal))).collect();
        let triangles = pieces.iter().map(|p| p.corners.map(|c| c.vertex)).collect();
        let facets: Vec<Facet> = flats.iter().map(|flat| flat.facet(&self.positions)).collect();
        let facets = pieces.iter().map(|p| facets[p.flat]).collect();
        self.positions.extend(crossings);
        let stated = pieces.iter().map(|p| flats[p.flat].material);
        let (materials, material_indices) = used_materials(&self.materials, stated);
        Mesh { positions: self.positions, triangles, normals, facets, materials, material_indices }
    }
}

/// The materials that are used, in the order of their first use, and for each triangle its own; both
/// are empty if nothing is said of any.
fn used_materials(
    all: &[PartialMaterial],
    of_triangles: impl Iterator<Item = u32>,
) -> (Vec<PartialMaterial>, Vec<u32>) {
    let mut used: Vec<PartialMaterial> = Vec::new();
    let mut renamed = vec![None; all.len()];
    let of_triangles = of_triangles.map_while(|material| {
        let known = renamed.get_mut(material as usize)?;
        Some(*known.get_or_insert_with(|| {
            used.push(all[material as usize].clone());
            // There are no more materials than a file of 2^30 bytes names.
            (used.len() - 1) as u32
        }))
    });
    let of_triangles: Vec<u32> = of_triangles.collect();
    let says_nothing = used.iter().all(|material| *material == PartialMaterial::default());
    if says_nothing { (Vec::new(), Vec::new()) } else { (used, of_triangles) }
}

/// A face that is to be split, with its plane.
struct Face<'c> {
    corners: &'c [Corner],
    normal: DVec3,
    material: u32,
}

/// All faces as triangles.
struct Split {
    pieces: Vec<Piece>,
    flats: Vec<Flat>,
    /// Vertices where a face crosses itself; they are numbered after those of the file.
    crossings: Vec<DVec3>,
}

/// A face with its plane, as it contributes to the normals of its vertices.
struct Flat {
    /// Its vertices, each once.
    vertices: Vec<u32>,
    normal: DVec3,
    material: u32,
}

impl Flat {
    fn facet(&self, positions: &[DVec3]) -> Facet {
        let places = self.vertices.iter().map(|&vertex| positions[vertex as usize]);
        Facet { normal: self.normal, middle: places.sum::<DVec3>() / self.vertices.len() as f64 }
    }
}

/// A triangle of a flat face.
struct Piece {
    corners: [Corner; 3],
    flat: usize,
}

impl Split {
    fn with_capacity(faces: usize) -> Split {
        Split {
            pieces: Vec::with_capacity(faces),
            flats: Vec::with_capacity(faces),
            crossings: Vec::new(),
        }
    }

    /// Adds a face; `vertices` is the number of vertices in the file.
    fn push(&mut self, face: Face<'_>, triangulation: Triangulation, vertices: usize) {
        let Face { corners, normal, material } = face;
        let (flat, first_crossing) = (self.flats.len(), vertices + self.crossings.len());
        self.crossings.extend(triangulation.crossings);
        let corner = |k: usize| match corners.get(k) {
            Some(&corner) => corner,
            // Indices are far below 2^32: a file of 2^30 bytes has at most 2^29 corners, and a face
            // at most 10^6 crossings.
            None => Corner { vertex: (first_crossing + k - corners.len()) as u32, normal: None },
        };
        self.pieces
            .extend(triangulation.triangles.iter().map(|t| Piece { corners: t.map(corner), flat }));
        let mut vertices: Vec<u32> = corners.iter().map(|c| c.vertex).collect();
        if vertices.len() > 3 {
            vertices.sort_unstable();
            vertices.dedup();
        }
        self.flats.push(Flat { vertices, normal, material });
    }
}

/// The normal of the largest triangle between the first corner and an edge: the plane of a polygon
/// whose parts cancel, such as a bow tie's.
fn normal_of_a_part(places: &[DVec3]) -> Option<DVec3> {
    let area = |edge: &&[DVec3]| (edge[0] - places[0]).cross(edge[1] - places[0]).length();
    let largest = places.get(1..)?.windows(2).max_by(|a, b| area(a).total_cmp(&area(b)))?;
    newell(&[places[0], largest[0], largest[1]])
}

/// A unit vector along a file's normal, which may have any length except 0.
fn direction_of_any_length(normal: DVec3) -> Option<DVec3> {
    let largest = normal.abs().max_element();
    if largest > 0.0 { direction(normal / largest) } else { None }
}

fn check_vertex(face: usize, index: u32, positions: &[DVec3]) -> Result<(), MeshProblem> {
    let missing = || MeshProblem::Index { face, what: "vertex", index, count: positions.len() };
    let position = positions.get(index as usize).ok_or_else(missing)?;
    let wrong = |x: &f64| x.is_nan() || x.abs() > FARTHEST;
    match position.to_array().into_iter().find(wrong) {
        Some(value) => {
            Err(MeshProblem::Coordinate { what: "vertex", index: index as usize, value })
        }
        None => Ok(()),
    }
}

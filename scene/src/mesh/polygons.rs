//! Faces as mesh files state them, before they are checked and split into triangles.
use glam::DVec3;

use super::error::MeshProblem;
use super::normals::{direction, newell, vertex_normals};
use super::triangulate::triangulate;
use super::weld::weld;
use super::{FARTHEST, MOST_TRIANGLES, Mesh};
use crate::Facet;

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
    /// Places of vertices.
    pub positions: Vec<DVec3>,
    /// Normals of any length.
    pub normals: Vec<DVec3>,
    /// The corners of all faces, one face after the other.
    corners: Vec<Corner>,
    /// Where each face ends in `corners`.
    ends: Vec<usize>,
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

    /// Checks everything, splits faces into triangles and fills in missing normals (METHODS.md A1, A2).
    ///
    /// # Errors
    /// Numbers that are not finite or absurdly large, indices out of range, too many triangles, or none with an area.
    pub fn into_mesh(self) -> Result<Mesh, MeshProblem> {
        self.check()?;
        let (faces, flat) = self.split()?;
        if faces.is_empty() {
            return Err(MeshProblem::Empty);
        }
        if faces.len() > MOST_TRIANGLES {
            return Err(MeshProblem::TooManyTriangles(faces.len()));
        }
        Ok(self.with_normals(&faces, &flat))
    }

    fn check(&self) -> Result<(), MeshProblem> {
        check_vectors("vertex", &self.positions)?;
        check_vectors("normal", &self.normals)?;
        for (face, corners) in self.faces().enumerate() {
            for corner in corners {
                check_index(face, "vertex", corner.vertex, self.positions.len())?;
                if let Some(normal) = corner.normal {
                    check_index(face, "normal", normal, self.normals.len())?;
                }
            }
        }
        Ok(())
    }

    /// Triangles with the index of the flat face each lies in, and the flat faces.
    fn split(&self) -> Result<(Vec<Piece>, Vec<Flat>), MeshProblem> {
        let (mut pieces, mut flats) = (Vec::with_capacity(self.ends.len()), Vec::with_capacity(self.ends.len()));
        for (face, corners) in self.faces().enumerate() {
            let places: Vec<DVec3> = corners.iter().map(|c| self.positions[c.vertex as usize]).collect();
            match newell(&places) {
                Some(normal) => {
                    let too_many = MeshProblem::Corners { face, corners: corners.len() };
                    let triangles = triangulate(&places, normal).ok_or(too_many)?;
                    let flat = flats.len();
                    flats.push(Flat { corners: corners.iter().map(|c| c.vertex).collect(), normal });
                    pieces.extend(triangles.into_iter().map(|t| Piece { corners: t.map(|k| corners[k]), flat }));
                }
                None => split_by_triangles(corners, &places, &mut pieces, &mut flats),
            }
        }
        Ok((pieces, flats))
    }

    fn with_normals(self, pieces: &[Piece], flats: &[Flat]) -> Mesh {
        let shared = if self.has_all_normals() {
            vec![None; self.positions.len()]
        } else {
            vertex_normals(self.positions.len(), flats.iter().map(|f| (f.corners.as_slice(), Some(f.normal))))
        };
        let normal_at = |corner: Corner, face: DVec3| {
            let given = corner.normal.and_then(|n| direction_of_any_length(self.normals[n as usize]));
            given.or(shared[corner.vertex as usize]).unwrap_or(face)
        };
        let normals = pieces.iter().map(|p| p.corners.map(|c| normal_at(c, flats[p.flat].normal))).collect();
        let triangles = pieces.iter().map(|p| p.corners.map(|c| c.vertex)).collect();
        let facets: Vec<Facet> = flats.iter().map(|flat| flat.facet(&self.positions)).collect();
        let facets = pieces.iter().map(|p| facets[p.flat]).collect();
        Mesh { positions: self.positions, triangles, normals, facets }
    }
}

/// A face with a normal of its own.
struct Flat {
    corners: Vec<u32>,
    normal: DVec3,
}

impl Flat {
    fn facet(&self, positions: &[DVec3]) -> Facet {
        let corners = self.corners.iter().map(|&vertex| positions[vertex as usize]);
        Facet { normal: self.normal, middle: corners.sum::<DVec3>() / self.corners.len() as f64 }
    }
}

/// A triangle of a flat face.
struct Piece {
    corners: [Corner; 3],
    flat: usize,
}

/// Splits a face without a normal of its own (a bow tie, or nothing at all) into triangles that are faces themselves;
/// those without area are left out.
fn split_by_triangles(corners: &[Corner], places: &[DVec3], pieces: &mut Vec<Piece>, flats: &mut Vec<Flat>) {
    for k in 1..corners.len() - 1 {
        let Some(normal) = newell(&[places[0], places[k], places[k + 1]]) else { continue };
        let triangle = [corners[0], corners[k], corners[k + 1]];
        pieces.push(Piece { corners: triangle, flat: flats.len() });
        flats.push(Flat { corners: triangle.iter().map(|c| c.vertex).collect(), normal });
    }
}

/// A unit vector along a file's normal, which may have any length but 0.
fn direction_of_any_length(normal: DVec3) -> Option<DVec3> {
    let largest = normal.abs().max_element();
    if largest > 0.0 { direction(normal / largest) } else { None }
}

fn check_vectors(what: &'static str, vectors: &[DVec3]) -> Result<(), MeshProblem> {
    let wrong = |x: &f64| x.is_nan() || x.abs() > FARTHEST;
    for (index, vector) in vectors.iter().enumerate() {
        if let Some(&value) = vector.to_array().iter().find(|x| wrong(x)) {
            return Err(MeshProblem::Coordinate { what, index, value });
        }
    }
    Ok(())
}

fn check_index(face: usize, what: &'static str, index: u32, count: usize) -> Result<(), MeshProblem> {
    if (index as usize) < count { Ok(()) } else { Err(MeshProblem::Index { face, what, index, count }) }
}

//! Joins the meshes at their places into one.
use std::collections::BTreeMap;

use glam::{DMat3, DMat4, DVec3};

use super::accessors::Elements;
use super::json::{Instancing, Whole};
use super::materials::Materials;
use super::nodes::{Placed, rotation};
use super::primitives::{Accessors, Drawable};
use crate::mesh::error::MeshProblem;
use crate::mesh::limits::{FARTHEST, MAX_TRIANGLES};
use crate::mesh::normals::normal_matrix;
use crate::mesh::polygons::{Corner, Polygons};
use crate::mesh::warning::Notices;

/// All triangles of `placed`; the accessors and materials of their meshes have been looked up.
///
/// The triangles are counted before any is copied, since a small file may instance large meshes
/// many times.
///
/// # Errors
/// Too many triangles, indices and coordinates that are out of range, accessors of wrong types.
pub fn draw(
    placed: &[Placed<'_>],
    accessors: &Accessors<'_>,
    materials: &Materials,
    notices: &mut Notices,
) -> Result<Polygons, MeshProblem> {
    let mut meshes = BTreeMap::new();
    for one in placed {
        if let std::collections::btree_map::Entry::Vacant(entry) = meshes.entry(one.mesh) {
            entry.insert(accessors.drawables(one.mesh)?);
        }
    }
    let parts = placed
        .iter()
        .map(|one| Ok((one, &meshes[&one.mesh], Instances::new(one.instancing, accessors)?)));
    // A mesh without triangles may be instanced any number of times.
    let parts = parts.filter(|part| !matches!(part, Ok((_, drawables, _)) if drawables.is_empty()));
    let parts = parts.collect::<Result<Vec<_>, MeshProblem>>()?;
    let triangles = parts
        .iter()
        .map(|(_, drawables, instances)| triangles(drawables).saturating_mul(instances.count));
    let triangles = triangles.fold(0, usize::saturating_add);
    if triangles > MAX_TRIANGLES {
        return Err(MeshProblem::TooManyTriangles(triangles));
    }
    let mut drawing =
        Drawing { polygons: Polygons::default(), copied: Copied::default(), materials };
    for (one, drawables, instances) in &parts {
        for k in 0..instances.count {
            drawing.mesh(drawables, one.place * instances.place(k), notices)?;
        }
    }
    Ok(drawing.polygons)
}

fn triangles(drawables: &[Drawable<'_, '_>]) -> usize {
    drawables.iter().map(|drawable| drawable.triangles).fold(0, usize::saturating_add)
}

/// Places at which a mesh is drawn, relative to its node.
struct Instances<'p, 'a> {
    count: usize,
    translations: Option<&'p Elements<'a>>,
    rotations: Option<&'p Elements<'a>>,
    scales: Option<&'p Elements<'a>>,
}

impl<'p, 'a> Instances<'p, 'a> {
    /// There is one instance if the node says nothing about it [EXT_mesh_gpu_instancing].
    fn new(
        instancing: Option<&Instancing>,
        accessors: &'p Accessors<'a>,
    ) -> Result<Instances<'p, 'a>, MeshProblem> {
        let attributes = instancing.map(|instancing| &instancing.attributes);
        let named = |number: Option<Whole>, kind: &str| match number
            .and_then(|number| accessors.get(number))
        {
            Some(elements) if elements.kind != kind => Err(MeshProblem::Syntax(format!(
                "accessor {} of instances is not of type `{kind}`",
                elements.number
            ))),
            found => Ok(found),
        };
        let translations = named(attributes.and_then(|all| all.translation), "VEC3")?;
        let rotations = named(attributes.and_then(|all| all.rotation), "VEC4")?;
        let scales = named(attributes.and_then(|all| all.scale), "VEC3")?;
        let mut counts =
            [translations, rotations, scales].into_iter().flatten().map(|elements| elements.count);
        let count = counts.next().unwrap_or(1);
        if counts.any(|other| other != count) {
            return Err(MeshProblem::Syntax(
                "the accessors of instances have different counts".into(),
            ));
        }
        Ok(Instances { count, translations, rotations, scales })
    }

    fn place(&self, k: usize) -> DMat4 {
        let vector = |elements: Option<&Elements<'_>>, otherwise| {
            elements.map_or(otherwise, |elements| DVec3::from_array(elements.numbers(k)))
        };
        let turn =
            rotation(self.rotations.map_or([0.0, 0.0, 0.0, 1.0], |elements| elements.numbers(k)));
        let (scale, shift) =
            (vector(self.scales, DVec3::ONE), vector(self.translations, DVec3::ZERO));
        DMat4::from_scale_rotation_translation(scale, turn, shift)
    }
}

/// The mesh put together so far.
struct Drawing<'m> {
    polygons: Polygons,
    copied: Copied,
    materials: &'m Materials,
}

impl Drawing<'_> {
    fn mesh(
        &mut self,
        drawables: &[Drawable<'_, '_>],
        place: DMat4,
        notices: &mut Notices,
    ) -> Result<(), MeshProblem> {
        self.copied.forget();
        let place = Placement::new(place);
        drawables.iter().try_for_each(|drawable| self.part(drawable, &place, notices))
    }

    fn part(
        &mut self,
        drawable: &Drawable<'_, '_>,
        place: &Placement,
        notices: &mut Notices,
    ) -> Result<(), MeshProblem> {
        self.copied.begin(drawable);
        self.polygons.material = self.materials.index(drawable.material);
        for number in 0..drawable.triangles {
            let [a, b, c] = drawable.triangle(number)?;
            if a == b || b == c || c == a {
                // These degenerate triangles lead strips elsewhere.
                continue;
            }
            // A mirror reverses the orientation of triangles [glTF 2.0, 3.7.4].
            let turned = if place.is_mirror { [a, c, b] } else { [a, b, c] };
            let mut corners = [Corner { vertex: 0, normal: None }; 3];
            for (corner, vertex) in corners.iter_mut().zip(turned) {
                *corner = match self.copied.corner(vertex) {
                    Some(known) => known,
                    None => self.vertex(vertex, drawable, place, notices)?,
                };
            }
            self.polygons.push(corners);
        }
        Ok(())
    }

    /// Copies a vertex that is used for the first time.
    fn vertex(
        &mut self,
        vertex: usize,
        drawable: &Drawable<'_, '_>,
        place: &Placement,
        notices: &mut Notices,
    ) -> Result<Corner, MeshProblem> {
        let position =
            place.whole.transform_point3(DVec3::from_array(drawable.positions.numbers(vertex)));
        if let Some(value) =
            position.to_array().into_iter().find(|x| x.is_nan() || x.abs() > FARTHEST)
        {
            return Err(MeshProblem::Coordinate { what: "vertex", index: vertex, value });
        }
        // There are at most three times [`MAX_TRIANGLES`] vertices, so indices fit.
        let mut corner = Corner { vertex: self.polygons.positions.len() as u32, normal: None };
        self.polygons.positions.push(position);
        if let Some(normals) = drawable.normals.filter(|normals| vertex < normals.count) {
            let normal = place.to_normals * DVec3::from_array(normals.numbers(vertex));
            let largest = normal.abs().max_element();
            if normal.is_finite() && largest > 0.0 {
                corner.normal = Some(self.polygons.normals.len() as u32);
                self.polygons.normals.push(normal / largest);
            } else {
                notices.add("normal without direction", None, || {
                    "a normal has no direction; it is made from the faces around its vertex instead".into()
                });
            }
        }
        self.copied.add(vertex, corner);
        Ok(corner)
    }
}

/// A place at which a mesh is drawn.
struct Placement {
    whole: DMat4,
    to_normals: DMat3,
    is_mirror: bool,
}

impl Placement {
    fn new(whole: DMat4) -> Placement {
        let linear = DMat3::from_mat4(whole);
        Placement {
            whole,
            to_normals: normal_matrix(linear),
            is_mirror: linear.determinant() < 0.0,
        }
    }
}

/// The vertices copied from a mesh's accessors: consecutive parts that share accessors share the
/// copies.
#[derive(Default)]
struct Copied {
    /// The accessors of positions and normals.
    accessors: Option<(usize, Option<usize>)>,
    /// For each vertex its position in `corners`, or [`NOT_COPIED`].
    places: Vec<u32>,
    /// The vertices and corners copied so far.
    corners: Vec<(usize, Corner)>,
}

const NOT_COPIED: u32 = u32::MAX;

impl Copied {
    fn forget(&mut self) {
        for (vertex, _) in self.corners.drain(..) {
            self.places[vertex] = NOT_COPIED;
        }
        self.accessors = None;
    }

    /// Forgets what was copied from accessors other than those of `drawable`.
    fn begin(&mut self, drawable: &Drawable<'_, '_>) {
        let accessors =
            Some((drawable.positions.number, drawable.normals.map(|normals| normals.number)));
        if self.accessors != accessors {
            self.forget();
            self.accessors = accessors;
        }
    }

    fn corner(&self, vertex: usize) -> Option<Corner> {
        let place = self.places.get(vertex).filter(|place| **place != NOT_COPIED)?;
        Some(self.corners[*place as usize].1)
    }

    fn add(&mut self, vertex: usize, corner: Corner) {
        if self.places.len() <= vertex {
            self.places.resize(vertex + 1, NOT_COPIED);
        }
        self.places[vertex] = self.corners.len() as u32;
        self.corners.push((vertex, corner));
    }
}

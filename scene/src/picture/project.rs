//! Projects a scene to the frame that is to be shaded.
use glam::{DAffine3, DMat3, DVec3};

use super::coverage::{Coverage, Point};
pub use super::error::PictureError;
use super::limits;
use super::normal_cones::{Face, VertexFans};
use super::scene::{Light, LightSource, LightSpace, Object, Scene};
use super::view::{Piece, View};
use super::visibility::{Projected, visible_spans};
use crate::mesh::normals::{direction, newell, normal_matrix};
use crate::surface::Surface;
use crate::{DirectionalLight, Facet, Frame, LocalLight, Span, Spot, Triangle, VertexCone};

impl Scene {
    /// Projects the scene, along parallel lines or to the eye of a perspective camera, determines what
    /// is visible and cuts it into spans.
    ///
    /// Each pixel is sampled at its centre. Both sides of a surface are drawn, since meshes may
    /// have holes, and faces of either orientation. The normals of a triangle that is seen from
    /// behind (opposite to its vertex normals) are reversed, so that the visible side is lit.
    ///
    /// # Errors
    /// A [`PictureError`] if the picture's size is out of range, the camera is invalid, or nothing
    /// is visible.
    pub fn frame(&self) -> Result<Frame, PictureError> {
        if !limits::is_allowed(self.size) {
            return Err(PictureError::Size(self.size.0, self.size.1));
        }
        let rotation = self.camera.rotation().ok_or(PictureError::Up)?;
        let seen = self.viewed(rotation);
        let (view, (kept, spans)) = self.visible(&seen, self.view(rotation, &seen)?)?;
        let fans: Vec<VertexFans> =
            seen.iter().enumerate().map(|(object, seen)| seen.fans(object, &kept)).collect();
        let triangle =
            |&name: &TriangleId| seen[name.object].triangle(name, &fans[name.object], &view);
        let triangles: Vec<Triangle> = kept.iter().map(triangle).collect::<Result<_, _>>()?;
        let spans = spans.into_iter().map(|span| with_weights_of(&triangles, span)).collect();
        let view = ViewTransform { rotation, centre: view.middle() };
        Ok(Frame {
            width: self.size.0,
            height: self.size.1,
            background: self.background,
            ambient: self.ambient,
            lights: self.lights.iter().filter_map(|light| light.at_infinity(view)).collect(),
            local_lights: self.lights.iter().filter_map(|light| light.at_a_place(view)).collect(),
            eye: self.camera.eye.map(|eye| rotation * eye),
            materials: self.objects.iter().flat_map(Object::materials).collect(),
            triangles,
            spans,
        })
    }

    /// The smallest and largest coordinates of all objects in view space.
    ///
    /// # Errors
    /// [`PictureError::Up`] if the camera is invalid, [`PictureError::NothingVisible`] without
    /// objects.
    pub fn extent(&self) -> Result<[DVec3; 2], PictureError> {
        let rotation = self.camera.rotation().ok_or(PictureError::Up)?;
        let seen = self.viewed(rotation);
        bounds(&seen).ok_or(PictureError::NothingVisible)
    }

    /// The projection of the scene.
    fn view(&self, rotation: DMat3, seen: &[ViewedObject<'_>]) -> Result<View, PictureError> {
        let bounds = bounds(seen).ok_or(PictureError::NothingVisible)?;
        View::new(&self.camera, rotation, (bounds, corners(seen)), self.size)
    }

    /// The objects in view space.
    fn viewed(&self, rotation: DMat3) -> Vec<ViewedObject<'_>> {
        let mut materials = 0;
        let viewed = self.objects.iter().map(|object| {
            let seen = ViewedObject::new(object, materials, rotation);
            materials += object.materials().len();
            seen
        });
        viewed.collect()
    }

    /// The visible triangles and their spans, with the view that shows them.
    ///
    /// If a camera that frames the objects itself shows none, since they lie between the middles of
    /// pixels, as in pictures of a pixel or two, the picture is moved until the largest triangle
    /// covers one.
    fn visible(
        &self,
        seen: &[ViewedObject<'_>],
        view: View,
    ) -> Result<(View, Visible), PictureError> {
        if let Some(visible) = self.visible_in(seen, &view)? {
            return Ok((view, visible));
        }
        let nothing = || view.nothing_of(corners(seen));
        let frames_objects = self.camera.frames_objects();
        let largest = frames_objects.then(|| middle_of_largest(seen, &view)).flatten();
        let moved = view.with_on_a_pixel(largest.ok_or_else(nothing)?);
        let visible = self.visible_in(seen, &moved)?.ok_or_else(nothing)?;
        Ok((moved, visible))
    }

    /// What a view shows; `None` if that is nothing.
    fn visible_in(
        &self,
        seen: &[ViewedObject<'_>],
        view: &View,
    ) -> Result<Option<Visible>, PictureError> {
        let (names, projected) = project(seen, view)?;
        let spans = visible_spans(&projected, self.size.0, self.size.1);
        Ok((!spans.is_empty()).then(|| keep_visible(spans, &names)))
    }

    /// The surfaces that objects represent, where they are known: one for each material of the
    /// [`Frame`]. Empty if the camera is invalid.
    pub fn surfaces(&self) -> Vec<Option<Surface>> {
        let Some(rotation) = self.camera.rotation() else { return vec![] };
        let eye = match self.camera.lens {
            None => None,
            Some(_) => {
                let seen = self.viewed(rotation);
                let Ok(view) = self.view(rotation, &seen) else { return vec![] };
                view.eye()
            }
        };
        let of = |object: &Object| {
            let to_view = DAffine3::from_mat3(rotation) * object.place;
            Some(Surface::of(object.primitive?, to_view)?.seen_from(eye))
        };
        let for_each_material =
            |object: &Object| std::iter::repeat_n(of(object), object.materials().len());
        self.objects.iter().flat_map(for_each_material).collect()
    }
}

/// The triangles that may be in the picture, and pieces of them, each with its name.
fn project(
    seen: &[ViewedObject<'_>],
    view: &View,
) -> Result<(Vec<TriangleId>, Vec<Projected>), PictureError> {
    let (mut names, mut projected) = (Vec::new(), Vec::new());
    for (object, seen) in seen.iter().enumerate() {
        for triangle in 0..seen.object.mesh.triangles.len() {
            for (piece, Piece { points, nearness, .. }) in
                view.pieces(seen.places(triangle))?.into_iter().enumerate()
            {
                if let Some(coverage) = Coverage::new(points) {
                    names.push(TriangleId { object, triangle, piece });
                    projected.push(Projected { coverage, nearness });
                }
            }
        }
    }
    Ok((names, projected))
}

/// A span with weights of its triangle in place of those of the piece that it is cut from.
fn with_weights_of(triangles: &[Triangle], span: Span) -> Span {
    match &triangles[span.triangle].perspective {
        None => span,
        Some(seen) => {
            let [start, end] = [span.start, span.end].map(|weights| seen.interpolated(weights));
            Span { start, end, ..span }
        }
    }
}

/// The transformation from the world to view space.
#[derive(Clone, Copy)]
pub(super) struct ViewTransform {
    rotation: DMat3,
    /// The point at the picture's centre, in view space.
    centre: DVec3,
}

impl ViewTransform {
    /// The view of a world that is already in view space.
    pub const NONE: ViewTransform =
        ViewTransform { rotation: DMat3::IDENTITY, centre: DVec3::ZERO };

    /// A direction in view space, of length 1.
    fn direction(self, space: LightSpace, direction: DVec3) -> DVec3 {
        let largest = direction.abs().max_element();
        let unit = (direction / largest).normalize_or(DVec3::Z);
        match space {
            LightSpace::World => (self.rotation * unit).normalize(),
            LightSpace::View => unit,
        }
    }

    /// A position in view space; one that is given in view space is relative to the picture's
    /// centre.
    fn place(self, space: LightSpace, position: DVec3) -> DVec3 {
        match space {
            LightSpace::World => self.rotation * position,
            LightSpace::View => self.centre + position,
        }
    }
}

impl Light {
    pub(super) fn at_infinity(&self, view: ViewTransform) -> Option<DirectionalLight> {
        match self.source {
            LightSource::Directional { direction } => Some(DirectionalLight {
                direction: view.direction(self.space, direction),
                colour: self.colour,
            }),
            LightSource::Point { .. } | LightSource::Spot { .. } => None,
        }
    }

    pub(super) fn at_a_place(&self, view: ViewTransform) -> Option<LocalLight> {
        let (position, spot, attenuation) = match self.source {
            LightSource::Directional { .. } => return None,
            LightSource::Point { position, attenuation } => (position, None, attenuation),
            LightSource::Spot { position, axis, exponent, attenuation } => {
                let spot = Spot { axis: view.direction(self.space, axis), exponent };
                (position, Some(spot), attenuation)
            }
        };
        Some(LocalLight {
            position: view.place(self.space, position),
            spot,
            attenuation,
            colour: self.colour,
        })
    }
}

/// The name of an object's triangle, or of a piece of it.
#[derive(Clone, Copy)]
pub(super) struct TriangleId {
    pub object: usize,
    pub triangle: usize,
    /// The number of the piece; 0 where it is whole.
    pub piece: usize,
}

/// The visible triangles, and the spans that refer to them.
type Visible = (Vec<TriangleId>, Vec<Span>);

/// An object in view space.
pub(super) struct ViewedObject<'a> {
    object: &'a Object,
    /// Where its materials begin among those of the frame.
    first_material: usize,
    place: DAffine3,
    positions: Vec<DVec3>,
    to_normals: DMat3,
}

impl<'a> ViewedObject<'a> {
    pub fn new(object: &'a Object, first_material: usize, rotation: DMat3) -> ViewedObject<'a> {
        let place = DAffine3::from_mat3(rotation) * object.place;
        let positions = object.mesh.positions.iter().map(|&p| place.transform_point3(p)).collect();
        let to_normals = normal_matrix(place.matrix3);
        ViewedObject { object, first_material, place, positions, to_normals }
    }

    /// The corners that triangles use; meshes may have unused vertices.
    fn corners(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.object.mesh.triangles.iter().flatten().map(|&k| self.positions[k as usize])
    }

    /// The corners of a triangle.
    fn places(&self, triangle: usize) -> [DVec3; 3] {
        self.object.mesh.triangles[triangle].map(|k| self.positions[k as usize])
    }

    /// A triangle of the object, turned to the side to which its vertex normals point.
    pub fn face(&self, triangle: usize) -> Face {
        let places = self.places(triangle);
        let face = newell(&places);
        let fallback = face.unwrap_or(DVec3::Z);
        let normals = self.object.mesh.normals[triangle]
            .map(|n| direction_of(self.to_normals * n).unwrap_or(fallback));
        let outward =
            face.map(|face| if face.dot(normals.iter().sum()) < 0.0 { -face } else { face });
        Face { places, normals, outward }
    }

    /// The faces around the vertices of this object's visible triangles.
    pub fn fans(&self, object: usize, visible: &[TriangleId]) -> VertexFans {
        let wanted = visible
            .iter()
            .filter(|name| name.object == object)
            .map(|name| self.face(name.triangle));
        let all = (0..self.object.mesh.triangles.len()).map(|triangle| self.face(triangle));
        let extent =
            self.corners().fold(f64::MIN_POSITIVE, |extent, p| extent.max(p.abs().max_element()));
        VertexFans::around(wanted, all, extent)
    }

    /// The triangle as it is shaded, where a view shows it, with its normals on the visible side.
    fn triangle(
        &self,
        name: TriangleId,
        fans: &VertexFans,
        view: &View,
    ) -> Result<Triangle, PictureError> {
        let face = self.face(name.triangle);
        let piece = view.pieces(face.places)?.into_iter().nth(name.piece);
        let towards_eye = view.towards_eye(face.places[0]);
        let outward = face.outward.unwrap_or_else(|| face.normals.iter().sum());
        let turn = if outward.dot(towards_eye) < 0.0 { -1.0 } else { 1.0 };
        let cones = fans.cones(&face).map(|cone| VertexCone { axis: cone.axis * turn, ..cone });
        Ok(Triangle {
            normals: face.normals.map(|n| n * turn),
            facet: self.facet(name.triangle, &face, towards_eye),
            positions: face.places,
            outline: piece.as_ref().map(|piece| piece.points.map(Point::in_pixels)),
            perspective: piece.and_then(|piece| piece.perspective),
            cones,
            material: self.first_material + self.object.material_index(name.triangle),
        })
    }

    /// The polygon of a triangle, with its normal on the side from which the triangle is seen.
    ///
    /// A mirror reverses the orientation of corners. `to_normals` nevertheless keeps a normal
    /// outside, so the side is determined for the reversed triangle.
    fn facet(&self, triangle: usize, face: &Face, towards_eye: DVec3) -> Facet {
        let facet = self.object.mesh.facets[triangle];
        let side = if self.place.matrix3.determinant() < 0.0 { -1.0 } else { 1.0 };
        let of_triangle = newell(&face.places).map(|normal| normal * side);
        let normal =
            direction_of(self.to_normals * facet.normal).or(of_triangle).unwrap_or(DVec3::Z);
        let turn = if of_triangle.unwrap_or(normal).dot(towards_eye) < 0.0 { -1.0 } else { 1.0 };
        Facet { normal: normal * turn, middle: self.place.transform_point3(facet.middle) }
    }
}

/// A unit vector along a vector of any length except 0.
fn direction_of(normal: DVec3) -> Option<DVec3> {
    let largest = normal.abs().max_element();
    if largest > 0.0 { direction(normal / largest) } else { None }
}

/// The middle of the triangle that is largest in the picture.
fn middle_of_largest(seen: &[ViewedObject<'_>], view: &View) -> Option<DVec3> {
    let all =
        seen.iter().flat_map(|seen| (0..seen.object.mesh.triangles.len()).map(|t| seen.places(t)));
    let area = |&triangle: &[DVec3; 3]| view.seen_area(triangle);
    let largest = all.max_by(|a, b| area(a).total_cmp(&area(b)))?;
    Some(largest.iter().sum::<DVec3>() / 3.0)
}

/// All corners of triangles.
fn corners(seen: &[ViewedObject<'_>]) -> impl Iterator<Item = DVec3> {
    seen.iter().flat_map(ViewedObject::corners)
}

/// The smallest and largest coordinates of all corners, if there are any.
fn bounds(seen: &[ViewedObject<'_>]) -> Option<[DVec3; 2]> {
    corners(seen).map(|p| [p, p]).reduce(|[low, high], [p, _]| [low.min(p), high.max(p)])
}

/// Keeps the triangles that spans refer to, in the order of their first use, and adapts the
/// references.
fn keep_visible(spans: Vec<Span>, names: &[TriangleId]) -> (Vec<TriangleId>, Vec<Span>) {
    let mut kept: Vec<Option<usize>> = vec![None; names.len()];
    let mut triangles = Vec::new();
    let renamed = spans.into_iter().map(|span| {
        let index = *kept[span.triangle].get_or_insert_with(|| {
            triangles.push(names[span.triangle]);
            triangles.len() - 1
        });
        Span { triangle: index, ..span }
    });
    let spans = renamed.collect();
    (triangles, spans)
}

//! Projects a scene to the frame that is to be shaded.
use glam::{DAffine3, DMat3, DVec3};
use thiserror::Error;

use super::camera::Window;
use super::coverage::{Coverage, Point};
use super::limits;
use super::normal_cones::{Face, VertexFans};
use super::scene::{Light, LightSource, LightSpace, Object, Scene};
use super::visibility::{Projected, visible_spans};
use crate::mesh::normals::{direction, newell, normal_matrix};
use crate::surface::Surface;
use crate::{DirectionalLight, Facet, Frame, LocalLight, Span, Spot, Triangle, VertexCone};

/// The reason why a scene cannot be drawn.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum PictureError {
    /// The picture would be too large, or without pixels.
    #[error("a picture of {0} x {1} pixels cannot be made")]
    Size(u32, u32),
    /// A size was requested for a scene of spans.
    #[error("spans say themselves how large the picture is")]
    OwnSize,
    /// The camera's `up` points to the eye or away from it, or one of the two is 0.
    #[error("the camera does not know what is up")]
    Up,
    /// All objects are at one point as the camera sees them.
    #[error("the objects have no extent as the camera sees them, so it cannot choose a height")]
    NoExtent,
    /// Part of an object is too far outside the picture for exact arithmetic.
    #[error("an object reaches more than 2 million pixels beyond the picture")]
    TooClose,
    /// No pixel's centre is covered.
    #[error("nothing of the scene is visible")]
    NothingVisible,
}

impl PictureError {
    /// What would be right.
    pub fn help(&self) -> String {
        match self {
            PictureError::Size(..) => limits::described(),
            PictureError::OwnSize => "leave the size out".into(),
            PictureError::Up => "give the camera an `up` that does not point along the direction to the eye".into(),
            PictureError::NoExtent => "give the camera a `height`, or turn it so that it does not see the objects edge on".into(),
            PictureError::TooClose => "give the camera a larger `height`, or split the object".into(),
            PictureError::NothingVisible => {
                "aim the camera's `target` at the objects, raise its `height`, or leave both out to have the objects framed".into()
            }
        }
    }
}

impl Scene {
    /// Projects the scene along parallel lines, determines what is visible and cuts it into spans.
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
        let bounds = bounds(&seen).ok_or(PictureError::NothingVisible)?;
        let window =
            Window::new(&self.camera, rotation, bounds, self.size).ok_or(PictureError::NoExtent)?;
        let (window, (kept, spans)) = self.visible(&seen, window)?;
        let fans: Vec<VertexFans> =
            seen.iter().enumerate().map(|(object, seen)| seen.fans(object, &kept)).collect();
        let triangle = |&name: &TriangleId| {
            let (seen, fans) = (&seen[name.object], &fans[name.object]);
            seen.triangle(name, fans, snapped(self.places(seen, name.triangle, &window)))
        };
        let triangles = kept.iter().map(triangle).collect();
        let view = ViewTransform { rotation, centre: window.centre };
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

    /// The visible triangles and their spans, with the window that shows them.
    ///
    /// If a camera that frames the objects itself shows none, since they lie between the middles of
    /// pixels, as in pictures of a pixel or two, the window is moved until the largest triangle
    /// covers one.
    fn visible(
        &self,
        seen: &[ViewedObject<'_>],
        window: Window,
    ) -> Result<(Window, Visible), PictureError> {
        if let Some(visible) = self.visible_in(seen, &window)? {
            return Ok((window, visible));
        }
        let largest = self.camera.frames_objects().then(|| middle_of_largest(seen)).flatten();
        let moved = window.with_on_a_pixel(largest.ok_or(PictureError::NothingVisible)?, self.size);
        let visible = self.visible_in(seen, &moved)?.ok_or(PictureError::NothingVisible)?;
        Ok((moved, visible))
    }

    /// What a window shows; `None` if that is nothing.
    fn visible_in(
        &self,
        seen: &[ViewedObject<'_>],
        window: &Window,
    ) -> Result<Option<Visible>, PictureError> {
        let (names, projected) = self.project(seen, window)?;
        let spans = visible_spans(&projected, self.size.0, self.size.1);
        Ok((!spans.is_empty()).then(|| keep_visible(spans, &names)))
    }

    /// The surfaces that objects represent, where they are known: one for each material of the
    /// [`Frame`]. Empty if the camera is invalid.
    pub fn surfaces(&self) -> Vec<Option<Surface>> {
        let Some(rotation) = self.camera.rotation() else { return vec![] };
        let of = |object: &Object| {
            Surface::of(object.primitive?, DAffine3::from_mat3(rotation) * object.place)
        };
        let for_each_material =
            |object: &Object| std::iter::repeat_n(of(object), object.materials().len());
        self.objects.iter().flat_map(for_each_material).collect()
    }

    /// The triangles that may be in the picture, each with its name.
    fn project(
        &self,
        seen: &[ViewedObject<'_>],
        window: &Window,
    ) -> Result<(Vec<TriangleId>, Vec<Projected>), PictureError> {
        let (mut names, mut projected) = (Vec::new(), Vec::new());
        for (object, seen) in seen.iter().enumerate() {
            for (triangle, corners) in seen.object.mesh.triangles.iter().enumerate() {
                let places = self.places(seen, triangle, window);
                if self.is_outside(places) {
                    continue;
                }
                let points = snapped(places).ok_or(PictureError::TooClose)?;
                if let Some(coverage) = Coverage::new(points) {
                    let nearness = corners.map(|k| seen.positions[k as usize].z);
                    names.push(TriangleId { object, triangle });
                    projected.push(Projected { coverage, nearness });
                }
            }
        }
        Ok((names, projected))
    }

    /// The places of the corners of an object's triangle in the picture, in pixels.
    fn places(&self, seen: &ViewedObject<'_>, triangle: usize, window: &Window) -> [[f64; 2]; 3] {
        let corners = seen.object.mesh.triangles[triangle];
        corners.map(|k| window.place(seen.positions[k as usize], self.size))
    }

    /// Whether all corners are beyond the same side of the picture.
    fn is_outside(&self, places: [[f64; 2]; 3]) -> bool {
        let beyond = |axis: usize, size: u32| {
            let size = f64::from(size);
            places.iter().all(|p| p[axis] < 0.0) || places.iter().all(|p| p[axis] > size)
        };
        beyond(0, self.size.0) || beyond(1, self.size.1)
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

/// The name of an object's triangle.
#[derive(Clone, Copy)]
pub(super) struct TriangleId {
    pub object: usize,
    pub triangle: usize,
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

    /// A triangle of the object, turned to the side to which its vertex normals point.
    pub fn face(&self, triangle: usize) -> Face {
        let places = self.object.mesh.triangles[triangle].map(|k| self.positions[k as usize]);
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

    /// The triangle as it is shaded, at these points of the picture, with its normals on the
    /// visible side.
    fn triangle(
        &self,
        name: TriangleId,
        fans: &VertexFans,
        points: Option<[Point; 3]>,
    ) -> Triangle {
        let face = self.face(name.triangle);
        let outward = face.outward.unwrap_or_else(|| face.normals.iter().sum());
        let turn = if outward.z < 0.0 { -1.0 } else { 1.0 };
        let cones = fans.cones(&face).map(|cone| VertexCone { axis: cone.axis * turn, ..cone });
        Triangle {
            normals: face.normals.map(|n| n * turn),
            facet: self.facet(name.triangle, &face),
            positions: face.places,
            outline: points.map(|points| points.map(Point::in_pixels)),
            cones,
            material: self.first_material + self.object.material_index(name.triangle),
        }
    }

    /// The polygon of a triangle, with its normal on the side from which the triangle is seen.
    ///
    /// A mirror reverses the orientation of corners. `to_normals` nevertheless keeps a normal
    /// outside, so the side is determined for the reversed triangle.
    fn facet(&self, triangle: usize, face: &Face) -> Facet {
        let facet = self.object.mesh.facets[triangle];
        let side = if self.place.matrix3.determinant() < 0.0 { -1.0 } else { 1.0 };
        let of_triangle = newell(&face.places).map(|normal| normal * side);
        let normal =
            direction_of(self.to_normals * facet.normal).or(of_triangle).unwrap_or(DVec3::Z);
        let turn = if of_triangle.unwrap_or(normal).z < 0.0 { -1.0 } else { 1.0 };
        Facet { normal: normal * turn, middle: self.place.transform_point3(facet.middle) }
    }
}

/// A unit vector along a vector of any length except 0.
fn direction_of(normal: DVec3) -> Option<DVec3> {
    let largest = normal.abs().max_element();
    if largest > 0.0 { direction(normal / largest) } else { None }
}

/// The grid points nearest to places in pixels; `None` if one is beyond the grid.
fn snapped(places: [[f64; 2]; 3]) -> Option<[Point; 3]> {
    let [a, b, c] = places.map(|[x, y]| Point::snap(x, y));
    Some([a?, b?, c?])
}

/// The middle of the triangle that is largest in the picture.
fn middle_of_largest(seen: &[ViewedObject<'_>]) -> Option<DVec3> {
    let corners =
        |seen: &ViewedObject<'_>, triangle: &[u32; 3]| triangle.map(|k| seen.positions[k as usize]);
    let all = seen
        .iter()
        .flat_map(|seen| seen.object.mesh.triangles.iter().map(move |t| corners(seen, t)));
    let area = |&[a, b, c]: &[DVec3; 3]| (b - a).cross(c - a).z.abs();
    let largest = all.max_by(|a, b| area(a).total_cmp(&area(b)))?;
    Some(largest.iter().sum::<DVec3>() / 3.0)
}

/// The smallest and largest coordinates of all corners, if there are any.
fn bounds(seen: &[ViewedObject<'_>]) -> Option<[DVec3; 2]> {
    let corners = seen.iter().flat_map(ViewedObject::corners).map(|p| [p, p]);
    corners.reduce(|[low, high], [p, _]| [low.min(p), high.max(p)])
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

//! Projects a scene to the frame that is to be shaded.
use glam::{DAffine3, DMat3, DVec3};
use rayon::prelude::*;

pub use super::error::PictureError;
use super::limits;
use super::normal_cones::VertexFans;
use super::scene::{Object, Scene};
use super::view::{Piece, Sighted, View};
use super::view_transform::ViewTransform;
use super::viewed::{TriangleId, ViewedObject, bounds, corners, middle_of_largest, viewed};
use super::visibility::{Projected, visible_spans};
use crate::surface::Surface;
use crate::{Frame, Span, Triangle};

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
        let sight = self.sight()?;
        let (view, visible) = self.visible(&sight)?.ok_or_else(|| sight.nothing())?;
        Ok(self.frame_of(&sight, &view, visible))
    }

    /// The same where a picture of the background alone is one like any other: without spans, if
    /// nothing is visible.
    ///
    /// # Errors
    /// As [`Scene::frame`], but for the last.
    pub fn frame_or_background(&self) -> Result<Frame, PictureError> {
        let sight = self.sight()?;
        Ok(match self.visible(&sight)? {
            Some((view, visible)) => self.frame_of(&sight, &view, visible),
            None => self.frame_of(&sight, &sight.view, Visible::default()),
        })
    }

    fn frame_of(&self, sight: &Sight<'_>, view: &View, (kept, mut spans): Visible) -> Frame {
        let Sight { rotation, seen, .. } = sight;
        let fans = |object: usize| {
            let own = kept.iter().filter(|name| name.object as usize == object);
            seen[object].fans(own.map(|name| name.triangle as usize))
        };
        let fans: Vec<VertexFans> = (0..seen.len()).map(fans).collect();
        let triangle = |&name: &TriangleId| {
            let object = name.object as usize;
            seen[object].triangle(name, &fans[object], view)
        };
        let triangles: Vec<Triangle> = kept.par_iter().map(triangle).collect();
        spans.iter_mut().for_each(|span| take_weights_of(&triangles, span));
        let transform = ViewTransform { rotation: *rotation, centre: view.middle() };
        let (lights, at) = (self.lights.iter(), transform);
        Frame {
            width: self.size.0,
            height: self.size.1,
            background: self.background,
            ambient: self.ambient,
            lights: lights.clone().filter_map(|light| light.at_infinity(at)).collect(),
            local_lights: lights.filter_map(|light| light.at_a_place(at)).collect(),
            eye: self.camera.eye.map(|eye| *rotation * eye),
            materials: self.objects.iter().flat_map(Object::materials).collect(),
            triangles,
            spans,
        }
    }

    /// The smallest and largest coordinates of all objects in view space.
    ///
    /// # Errors
    /// [`PictureError::Up`] if the camera is invalid, [`PictureError::NothingVisible`] without
    /// objects.
    pub fn extent(&self) -> Result<[DVec3; 2], PictureError> {
        let rotation = self.camera.rotation().ok_or(PictureError::Up)?;
        let seen = viewed(&self.objects, rotation);
        bounds(&seen).ok_or(PictureError::NothingVisible)
    }

    /// What the camera has before it.
    fn sight(&self) -> Result<Sight<'_>, PictureError> {
        if !limits::is_allowed(self.size) {
            return Err(PictureError::Size(self.size.0, self.size.1));
        }
        let rotation = self.camera.rotation().ok_or(PictureError::Up)?;
        let seen = viewed(&self.objects, rotation);
        let bounds = bounds(&seen).ok_or(PictureError::NothingVisible)?;
        let view = View::new(&self.camera, rotation, (bounds, corners(&seen)), self.size)?;
        Ok(Sight { rotation, seen, view })
    }

    /// The visible triangles and their spans, with the view that shows them; `None` if nothing is
    /// visible.
    ///
    /// If a camera that frames the objects itself shows none, since they lie between the middles of
    /// pixels, as in pictures of a pixel or two, the picture is moved until the largest triangle
    /// covers one.
    fn visible(&self, sight: &Sight<'_>) -> Result<Option<(View, Visible)>, PictureError> {
        let Sight { seen, view, .. } = sight;
        if let Some(visible) = self.visible_in(seen, view)? {
            return Ok(Some((*view, visible)));
        }
        let frames_objects = self.camera.frames_objects();
        let largest = frames_objects.then(|| middle_of_largest(seen, view)).flatten();
        let Some(largest) = largest else { return Ok(None) };
        let moved = view.with_on_a_pixel(largest);
        Ok(self.visible_in(seen, &moved)?.map(|visible| (moved, visible)))
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
                let Ok(sight) = self.sight() else { return vec![] };
                sight.view.eye()
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

/// What a camera has before it.
struct Sight<'a> {
    /// The camera's.
    rotation: DMat3,
    seen: Vec<ViewedObject<'a>>,
    view: View,
}

impl Sight<'_> {
    /// The error of a picture in which nothing is visible.
    fn nothing(&self) -> PictureError {
        self.view.nothing_of(corners(&self.seen))
    }
}

/// The triangles that may be in the picture, and pieces of them, each with its name.
fn project(
    seen: &[ViewedObject<'_>],
    view: &View,
) -> Result<(Vec<TriangleId>, Vec<Projected>), PictureError> {
    let (mut names, mut projected) = (Vec::new(), Vec::new());
    let mut add = |name: TriangleId, points, nearness| {
        if let Some(coverage) = view.coverage(points) {
            names.push(name);
            projected.push(Projected { coverage, nearness });
        }
    };
    for (object, seen) in (0..).zip(seen) {
        let marks = seen.marks(view);
        // Scenes have far fewer than 2^32 objects, triangles and pieces.
        for triangle in 0..seen.triangles() as u32 {
            let name = |piece| TriangleId { object, triangle, piece };
            match view.sighted(seen.indices(triangle as usize).map(|k| marks[k])) {
                Sighted::Nothing => {}
                Sighted::Whole { points, nearness } => add(name(0), points, nearness),
                Sighted::Cut => {
                    let pieces = view.cut(seen.places(triangle as usize));
                    for (number, Piece { points, nearness, .. }) in (0..).zip(pieces) {
                        add(name(number), points, nearness);
                    }
                }
                Sighted::TooFar => return Err(PictureError::TooClose),
            }
        }
    }
    Ok((names, projected))
}

/// Gives a span weights of its triangle in place of those of the piece that it is cut from.
fn take_weights_of(triangles: &[Triangle], span: &mut Span) {
    if let Some(seen) = &triangles[span.triangle].perspective {
        (span.start, span.end) = (seen.interpolated(span.start), seen.interpolated(span.end));
    }
}

/// The visible triangles, and the spans that refer to them.
type Visible = (Vec<TriangleId>, Vec<Span>);

/// Keeps the triangles that spans refer to, in the order of their first use, and adapts the
/// references.
fn keep_visible(mut spans: Vec<Span>, names: &[TriangleId]) -> (Vec<TriangleId>, Vec<Span>) {
    let mut kept: Vec<Option<u32>> = vec![None; names.len()];
    let mut triangles = Vec::new();
    for span in &mut spans {
        let index = *kept[span.triangle].get_or_insert_with(|| {
            triangles.push(names[span.triangle]);
            (triangles.len() - 1) as u32
        });
        span.triangle = index as usize;
    }
    (triangles, spans)
}

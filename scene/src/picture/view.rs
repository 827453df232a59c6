//! How view space becomes a picture.
use glam::{DMat3, DVec3};
use rayon::prelude::*;

use super::camera::{Camera, Window};
use super::clip::HalfSpace;
use super::coverage::{Coverage, Point};
use super::error::PictureError;
use super::pinhole::Pinhole;
use crate::frame::EYE;
use crate::perspective::Perspective;

/// The projection from view space to a picture.
#[derive(Clone, Copy)]
pub(super) struct View {
    lines: Lines,
    /// Width and height of the picture in pixels.
    size: (u32, u32),
}

/// Where lines of sight go.
#[derive(Clone, Copy)]
enum Lines {
    /// They are parallel.
    Parallel(Window),
    /// They meet in the eye.
    Central(Pinhole),
}

/// A triangle in the picture, or a piece of one.
pub(super) struct Piece {
    /// Its corners.
    pub points: [Point; 3],
    /// Their nearness, linear on the screen; larger is nearer.
    pub nearness: [f64; 3],
    /// What it is of the triangle, in perspective.
    pub perspective: Option<Perspective>,
}

/// What may be in the picture of a triangle.
pub(super) enum Sighted {
    /// Nothing.
    Nothing,
    /// All of it.
    Whole {
        /// Its corners.
        points: [Point; 3],
        /// Their nearness, linear on the screen; larger is nearer.
        nearness: [f64; 3],
    },
    /// Pieces, which [`View::cut`] gives.
    Cut,
    /// Something of it, and a corner is too far outside for exact arithmetic.
    TooFar,
}

/// A point of view space in the picture.
#[derive(Clone, Copy)]
pub(super) struct Mark {
    /// The nearest grid point; `None` beyond the grid.
    point: Option<Point>,
    /// Linear on the screen; larger is nearer.
    nearness: f64,
    /// A bit for each side of the picture that it is beyond, or that hides it from the eye.
    beyond: u8,
}

impl View {
    /// The projection of a camera to a picture of `size` pixels.
    ///
    /// `bounds` are the smallest and largest view-space coordinates of all objects, `corners` those
    /// of their triangles; `rotation` is the camera's.
    ///
    /// # Errors
    /// [`PictureError::NoExtent`] or [`PictureError::NoDistance`] if the objects have no extent from
    /// which what the camera does not state could be computed.
    pub fn new(
        camera: &Camera,
        rotation: DMat3,
        (bounds, corners): ([DVec3; 2], impl Iterator<Item = DVec3>),
        size: (u32, u32),
    ) -> Result<View, PictureError> {
        let lines = match &camera.lens {
            None => Window::new(camera, rotation, bounds, size)
                .map(Lines::Parallel)
                .ok_or(PictureError::NoExtent)?,
            Some(lens) => Pinhole::new((camera, lens), rotation, (bounds, corners), size)
                .map(Lines::Central)
                .ok_or(PictureError::NoDistance)?,
        };
        Ok(View { lines, size })
    }

    /// The projection moved by at most half a pixel in either direction, so that a point of view
    /// space is at the middle of a pixel.
    pub fn with_on_a_pixel(self, point: DVec3) -> View {
        let lines = match self.lines {
            Lines::Parallel(window) => Lines::Parallel(window.with_on_a_pixel(point, self.size)),
            Lines::Central(pinhole) => Lines::Central(pinhole.with_on_a_pixel(point, self.size)),
        };
        View { lines, ..self }
    }

    /// The point of view space at the picture's middle, from which places of lights that stay with
    /// the camera are measured.
    pub fn middle(&self) -> DVec3 {
        match &self.lines {
            Lines::Parallel(window) => window.centre,
            Lines::Central(pinhole) => pinhole.target,
        }
    }

    /// The eye that lines of sight meet in; `None` where they are parallel.
    pub fn eye(&self) -> Option<DVec3> {
        match &self.lines {
            Lines::Parallel(_) => None,
            Lines::Central(pinhole) => Some(pinhole.eye),
        }
    }

    /// The vector from a point to the eye, of any length.
    pub fn towards_eye(&self, point: DVec3) -> DVec3 {
        self.eye().map_or(EYE, |eye| eye - point)
    }

    /// How large a triangle appears: its area as lines of sight meet it, where they are parallel, or
    /// about the solid angle in which the eye sees it.
    pub fn seen_area(&self, [a, b, c]: [DVec3; 3]) -> f64 {
        let (area, towards_eye) = ((b - a).cross(c - a), self.towards_eye(a));
        area.dot(towards_eye).abs() / towards_eye.length().powi(3)
    }

    /// The error of a picture in which none of these points' triangles is visible.
    pub fn nothing_of(&self, mut points: impl Iterator<Item = DVec3>) -> PictureError {
        match &self.lines {
            Lines::Parallel(_) => PictureError::NothingVisible,
            Lines::Central(pinhole) if points.any(|point| pinhole.is_in_front(point)) => {
                PictureError::OutOfSight
            }
            Lines::Central(_) => PictureError::BehindEye,
        }
    }

    /// Where points of view space are in the picture.
    pub fn marks(&self, points: &[DVec3]) -> Vec<Mark> {
        match &self.lines {
            Lines::Parallel(window) => {
                let mark = |&point: &DVec3| self.parallel_mark(window, point);
                points.par_iter().map(mark).collect()
            }
            Lines::Central(pinhole) => {
                let sight = pinhole.sight(self.size);
                let mark = |&point: &DVec3| self.central_mark(pinhole, &sight, point);
                points.par_iter().map(mark).collect()
            }
        }
    }

    fn parallel_mark(&self, window: &Window, point: DVec3) -> Mark {
        let [x, y] = window.place(point, self.size);
        let [width, height] = [self.size.0, self.size.1].map(f64::from);
        let beyond = [x < 0.0, x > width, y < 0.0, y > height];
        Mark { point: Point::snap(x, y), nearness: point.z, beyond: bits(beyond) }
    }

    fn central_mark(&self, pinhole: &Pinhole, sight: &[HalfSpace; 5], point: DVec3) -> Mark {
        let seen = point - pinhole.eye;
        let [x, y] = pinhole.place_in(seen, self.size);
        Mark {
            point: Point::snap(x, y),
            nearness: pinhole.nearness(seen),
            beyond: bits(sight.each_ref().map(|side| !side.contains(seen))),
        }
    }

    /// What may be in the picture of a triangle of view space: nothing, the triangle, or pieces; also
    /// nothing if a corner is beyond the grid.
    pub fn pieces(&self, corners: [DVec3; 3]) -> Vec<Piece> {
        let mark = |point| match &self.lines {
            Lines::Parallel(window) => self.parallel_mark(window, point),
            Lines::Central(pinhole) => self.central_mark(pinhole, &pinhole.sight(self.size), point),
        };
        match self.sighted(corners.map(mark)) {
            Sighted::Nothing | Sighted::TooFar => vec![],
            Sighted::Whole { points, nearness } => {
                let perspective = match &self.lines {
                    Lines::Parallel(_) => None,
                    Lines::Central(pinhole) => Some(pinhole.whole(nearness)),
                };
                vec![Piece { points, nearness, perspective }]
            }
            Sighted::Cut => self.cut(corners),
        }
    }

    /// What may be in the picture of a triangle, of whose corners the [`View::marks`] are given.
    pub fn sighted(&self, marks: [Mark; 3]) -> Sighted {
        let any = marks.iter().fold(0, |any, mark| any | mark.beyond);
        let all = marks.iter().fold(u8::MAX, |all, mark| all & mark.beyond);
        match &self.lines {
            Lines::Parallel(_) if all != 0 => Sighted::Nothing,
            // The first side that cuts anything off cuts off all.
            Lines::Central(_) if all & any & any.wrapping_neg() != 0 => Sighted::Nothing,
            Lines::Central(_) if any != 0 => Sighted::Cut,
            Lines::Parallel(_) | Lines::Central(_) => {
                let [Some(a), Some(b), Some(c)] = marks.map(|mark| mark.point) else {
                    return Sighted::TooFar;
                };
                Sighted::Whole { points: [a, b, c], nearness: marks.map(|mark| mark.nearness) }
            }
        }
    }

    /// The pieces of a triangle of view space that is cut off.
    pub fn cut(&self, corners: [DVec3; 3]) -> Vec<Piece> {
        let Lines::Central(pinhole) = &self.lines else { return vec![] };
        let piece = |(places, seen): ([[f64; 2]; 3], Perspective)| {
            let (points, nearness) = (snapped(places)?, seen.nearness);
            Some(Piece { points, nearness, perspective: Some(seen) })
        };
        pinhole.pieces(corners, self.size).filter_map(piece).collect()
    }

    /// The pixels that a triangle with these corners covers; `None` if it has no area, or if none of
    /// the picture's pixels has its centre in the rectangle around it.
    pub fn coverage(&self, points: [Point; 3]) -> Option<Coverage> {
        let is_seen = Coverage::may_cover(&points, self.size.0, self.size.1);
        is_seen.then(|| Coverage::new(points)).flatten()
    }
}

/// A number with a bit for each side.
fn bits<const SIDES: usize>(sides: [bool; SIDES]) -> u8 {
    (0..).zip(sides).fold(0, |bits, (side, is_set)| bits | u8::from(is_set) << side)
}

/// The grid points nearest to places in pixels; `None` if one is beyond the grid.
fn snapped(places: [[f64; 2]; 3]) -> Option<[Point; 3]> {
    let [a, b, c] = places.map(|[x, y]| Point::snap(x, y));
    Some([a?, b?, c?])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::picture::camera::Lens;

    const SIZE: (u32, u32) = (24, 18);

    /// A camera at the origin that looks along -z.
    fn view(field_of_view: f64, near: f64) -> View {
        let eye = Some(DVec3::ZERO);
        let interpolation = crate::perspective::Interpolation::Screen;
        let lens = Lens { field_of_view, eye, near: Some(near), interpolation };
        let target = Some(DVec3::NEG_Z);
        let camera = Camera { direction: DVec3::Z, target, lens: Some(lens), ..Camera::default() };
        View::new(&camera, DMat3::IDENTITY, ([DVec3::ZERO; 2], std::iter::empty()), SIZE)
            .unwrap_or_else(|error| unreachable!("its eye is known: {error}"))
    }

    /// How often each pixel is covered by triangles.
    fn counts(view: &View, triangles: &[[DVec3; 3]]) -> Vec<u32> {
        let mut counts = vec![0; (SIZE.0 * SIZE.1) as usize];
        let pieces = |&corners: &[DVec3; 3]| view.pieces(corners);
        let pieces = triangles.iter().flat_map(pieces);
        for coverage in pieces.filter_map(|piece| Coverage::new(piece.points)) {
            for (y, columns) in coverage.runs(SIZE.0, SIZE.1) {
                columns.for_each(|x| counts[(y * SIZE.0 + x) as usize] += 1);
            }
        }
        counts
    }

    fn place() -> impl Strategy<Value = DVec3> {
        let coordinate = prop_oneof![-3.0..3.0_f64, -100.0..100.0_f64];
        prop::array::uniform3(coordinate).prop_map(DVec3::from_array)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        /// Two triangles on either side of an edge, cut or not, cover no pixel twice.
        #[test]
        fn triangles_that_share_an_edge_do_not_overlap(
            [a, b, c, d] in prop::array::uniform4(place()),
            field_of_view in 1.0..170.0_f64,
            near in 0.001..2.0_f64,
        ) {
            let Some(normal) = a.cross(b).try_normalize() else { return Ok(()) };
            let [c, d] = [(c, 1.0), (d, -1.0)].map(|(tip, side)| {
                let height = normal.dot(tip);
                tip + normal * (side * height.abs() - height)
            });
            let view = view(field_of_view, near);
            let counts = counts(&view, &[[a, b, c], [b, a, d]]);
            prop_assert!(counts.iter().all(|&n| n <= 1), "{counts:?}");
        }

        /// A quadrilateral covers the same pixels, each once, along whichever diagonal it is split.
        #[test]
        fn the_diagonal_of_a_quadrilateral_does_not_matter(
            [origin, u, v] in prop::array::uniform3(place()),
            ends in prop::array::uniform4(0.5..3.0_f64),
            field_of_view in 1.0..170.0_f64,
        ) {
            let corners = [
                origin + u * ends[0],
                origin + v * ends[1],
                origin - u * ends[2],
                origin - v * ends[3],
            ];
            // All of it is before the near plane: where that cuts it, the cut has a corner at the diagonal.
            let nearest = corners.iter().map(|corner| corner.z).fold(f64::MIN, f64::max);
            let corners = corners.map(|corner| corner - DVec3::Z * (nearest + 0.02));
            // One that is seen edge on may be turned around on the grid.
            let normal = u.cross(v);
            let cosine = |corner: DVec3| normal.dot(corner).abs() / (normal.length() * corner.length());
            if corners.into_iter().any(|corner| cosine(corner) < 0.1) {
                return Ok(());
            }
            let [a, b, c, d] = corners;
            let view = view(field_of_view, 0.01);
            let [one, other] = [[[a, b, c], [a, c, d]], [[b, c, d], [b, d, a]]]
                .map(|triangles| counts(&view, &triangles));
            prop_assert!(one.iter().all(|&n| n <= 1), "{one:?}");
            prop_assert_eq!(one, other);
        }
    }
}

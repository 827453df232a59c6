//! Set-up of spans: what is computed once for a frame, and what is computed for each span.
use std::marker::PhantomData;

use glam::DVec3;
use specula_scene::frame::EYE;
use specula_scene::{DirectionalLight, Facet, Frame, Span, Triangle};

use super::along_span::{AlongSpan, Dimmed, OrPhong};
use super::linear::{AtPoints, Planes};
use super::mesh::{Mesh, Point};
use crate::exact::formula::diffuse::lambert;
use crate::exact::formula::illumination::{Illumination, lights_from, view_from};
use crate::exact::formula::{slerp, wrap};
use crate::loops::{Gouraud, Hybrid, Line, Number, Pair, Phong, Scheme, Uniform, intensities};

/// The set-up of a frame's spans.
pub trait SetUp<'a> {
    /// A light along a span.
    type Light: AlongSpan;

    /// Computes what belongs to the frame.
    fn new(mesh: &'a Mesh<'a>) -> Self;

    /// Adds the lights along a span, those at infinity first.
    fn span(&mut self, span: &Span, lights: &mut Vec<Self::Light>);
}

/// Sets up each span by itself, under lights at infinity.
pub struct Each<'a, S> {
    frame: &'a Frame,
    scheme: PhantomData<S>,
}

impl<'a, S: Scheme<f32>> SetUp<'a> for Each<'a, S> {
    type Light = S;

    fn new(mesh: &'a Mesh<'a>) -> Self {
        Each { frame: mesh.frame, scheme: PhantomData }
    }

    fn span(&mut self, span: &Span, lights: &mut Vec<S>) {
        let line = Line::new(self.frame, span);
        lights.extend(self.frame.lights.iter().map(|light| S::new(&line, light.direction)));
    }
}

/// The condition that is always met.
pub struct Always;

impl Serves for Always {
    fn serves(_: &Line) -> bool {
        true
    }
}

/// A condition under which a scheme can shade a span.
pub trait Serves {
    /// Whether the scheme can shade this span.
    fn serves(line: &Line) -> bool;
}

/// The condition that slerp can interpolate the end normals (extremes rows 13 to 15).
pub struct Arcs;

impl Serves for Arcs {
    fn serves(line: &Line) -> bool {
        slerp::angle(line.unit_ends()).is_some()
    }
}

/// The condition that the triangle can be wrapped around the polygon's normal (extremes row 8).
pub struct Wraps;

impl Serves for Wraps {
    fn serves(line: &Line) -> bool {
        wrap::serves(line.face, &line.vertices)
    }
}

/// Sets up spans as [`Each`] does, with Phong's chord where the scheme cannot shade the span.
pub struct Where<'a, S, W> {
    each: Each<'a, S>,
    serves: PhantomData<W>,
}

impl<'a, S: Scheme<f32>, W: Serves> SetUp<'a> for Where<'a, S, W> {
    type Light = OrPhong<S>;

    fn new(mesh: &'a Mesh<'a>) -> Self {
        Where { each: Each::new(mesh), serves: PhantomData }
    }

    fn span(&mut self, span: &Span, lights: &mut Vec<OrPhong<S>>) {
        let line = Line::new(self.each.frame, span);
        let serves = W::serves(&line);
        let light = |light: &DirectionalLight| or_phong(serves, &line, light.direction);
        lights.extend(self.each.frame.lights.iter().map(light));
    }
}

/// The scheme where it serves, and Phong's elsewhere.
pub(super) fn or_phong<S: Scheme<f32>>(serves: bool, line: &Line, light: DVec3) -> OrPhong<S> {
    if serves {
        OrPhong::Scheme(S::new(line, light))
    } else {
        OrPhong::Phong(Phong::new(line, light))
    }
}

/// Sets up spans as [`Where`] does, under lights and for an eye at places, with the directions to
/// them and the shares of spots from the middle of the span: no scheme but Phong's takes others.
pub struct FromMiddle<'a, S, W> {
    frame: &'a Frame,
    scheme: PhantomData<(S, W)>,
}

impl<'a, S: Scheme<f32>, W: Serves> SetUp<'a> for FromMiddle<'a, S, W> {
    type Light = Dimmed<OrPhong<S>>;

    fn new(mesh: &'a Mesh<'a>) -> Self {
        FromMiddle { frame: mesh.frame, scheme: PhantomData }
    }

    fn span(&mut self, span: &Span, lights: &mut Vec<Self::Light>) {
        let middle = Middle::of(self.frame, span);
        let serves = W::serves(&middle.line);
        lights.extend(middle.lights(self.frame).map(|light| Dimmed {
            light: or_phong(serves, &middle.line, light.direction),
            shares: light.shares,
        }));
    }
}

/// A span as it is lit and seen from its middle.
struct Middle {
    line: Line,
    position: DVec3,
    /// Whether the eye is anywhere but at that very point, where it sees no highlight.
    is_seen: bool,
}

/// A light as seen from the middle of a span.
struct MiddleLight {
    direction: DVec3,
    shares: [f32; 2],
}

impl Middle {
    fn of(frame: &Frame, span: &Span) -> Middle {
        let position = frame.position_at(span, span.middle());
        let view = view_from(frame, position);
        let line = Line { eye: view.unwrap_or(EYE), ..Line::new(frame, span) };
        Middle { line, position, is_seen: view.is_some() }
    }

    /// Every light, those at infinity first; one at that very point gives nothing (extremes row
    /// 39).
    fn lights<'a>(&self, frame: &'a Frame) -> impl Iterator<Item = MiddleLight> + use<'a> {
        let is_seen = self.is_seen;
        lights_from(frame, self.position).map(move |light| {
            let light = light.unwrap_or(Illumination { direction: EYE, share: 0.0 });
            let share = light.share as f32;
            let specular = if is_seen { share } else { 0.0 };
            MiddleLight { direction: light.direction, shares: [share, specular] }
        })
    }
}

/// Sets up intensities of vertices, wherever the lights are.
pub struct Vertices(Planes<2>);

impl<'a> SetUp<'a> for Vertices {
    type Light = Gouraud<f32>;

    fn new(mesh: &'a Mesh<'a>) -> Self {
        Vertices(Planes::new(mesh, &lit_vertices(mesh)))
    }

    fn span(&mut self, span: &Span, lights: &mut Vec<Gouraud<f32>>) {
        lights.extend(self.0.along(span).map(Gouraud::of));
    }
}

/// Sets up intensities of polygons, wherever the lights are.
pub struct Polygons(AtPoints<f64, 2>);

impl<'a> SetUp<'a> for Polygons {
    type Light = Uniform<f32>;

    fn new(mesh: &'a Mesh<'a>) -> Self {
        let middle = |triangle: &Triangle| {
            let Facet { normal, middle } = triangle.facet;
            Point { normal, position: middle, material: triangle.material }
        };
        let middles = mesh.frame.triangles.iter().map(middle);
        Polygons(AtPoints::new(middles, |polygon| lit(mesh.frame, polygon)))
    }

    fn span(&mut self, span: &Span, lights: &mut Vec<Uniform<f32>>) {
        lights.extend(
            self.0
                .of(span.triangle)
                .iter()
                .map(|&[diffuse, base]| Uniform::of(Pair { diffuse, base })),
        );
    }
}

/// Sets up diffuse intensities of vertices, and the highlight of each span.
pub struct DiffuseVertices<'a> {
    frame: &'a Frame,
    diffuse: Planes<1>,
}

impl<'a> DiffuseVertices<'a> {
    fn of(mesh: &'a Mesh<'a>) -> Self {
        let frame = mesh.frame;
        let of_light = |normal: DVec3, light: Option<Illumination>| {
            light.map_or(0.0, |light| light.share * lambert(normal, light.direction))
        };
        let diffuse = |vertex: Point| {
            lights_from(frame, vertex.position).map(move |light| [of_light(vertex.normal, light)])
        };
        let vertices = AtPoints::new(mesh.vertices.iter().copied(), diffuse);
        DiffuseVertices { frame, diffuse: Planes::new(mesh, &vertices) }
    }
}

impl<'a> SetUp<'a> for DiffuseVertices<'a> {
    type Light = Hybrid<f32>;

    fn new(mesh: &'a Mesh<'a>) -> Self {
        DiffuseVertices::of(mesh)
    }

    fn span(&mut self, span: &Span, lights: &mut Vec<Hybrid<f32>>) {
        let line = Line::new(self.frame, span);
        let along = self.frame.lights.iter().zip(self.diffuse.along(span));
        lights.extend(along.map(|(light, [diffuse])| Hybrid::of(diffuse, &line, light.direction)));
    }
}

/// Sets up spans as [`DiffuseVertices`] does, under lights and for an eye at places: diffuse light
/// from the vertices, the highlight from the middle of the span.
pub struct DiffuseVerticesFromMiddle<'a>(DiffuseVertices<'a>);

impl<'a> SetUp<'a> for DiffuseVerticesFromMiddle<'a> {
    type Light = Dimmed<Hybrid<f32>>;

    fn new(mesh: &'a Mesh<'a>) -> Self {
        DiffuseVerticesFromMiddle(DiffuseVertices::of(mesh))
    }

    fn span(&mut self, span: &Span, lights: &mut Vec<Self::Light>) {
        let DiffuseVertices { frame, diffuse } = &mut self.0;
        let middle = Middle::of(frame, span);
        let along = middle.lights(frame).zip(diffuse.along(span));
        lights.extend(along.map(|(light, [diffuse])| Dimmed {
            light: Hybrid::of(diffuse, &middle.line, light.direction),
            shares: [1.0, light.shares[1]],
        }));
    }
}

/// I_d and I_s^n at a mesh's vertices.
fn lit_vertices<T: Number>(mesh: &Mesh) -> AtPoints<T, 2> {
    AtPoints::new(mesh.vertices.iter().copied(), |vertex| lit(mesh.frame, vertex))
}

/// I_d and I_s^n of each light at a point.
///
/// A light at that very point gives nothing, and an eye there sees no highlight (extremes row 39).
fn lit<T: Number>(frame: &Frame, point: Point) -> impl Iterator<Item = [T; 2]> {
    let shininess = frame.materials[point.material].shininess;
    let view = view_from(frame, point.position).unwrap_or_default();
    lights_from(frame, point.position).map(move |light| {
        let Some(Illumination { direction, share }) = light else { return [T::of(0.0); 2] };
        let Pair { diffuse, base } = intensities::<T>(point.normal, direction, view, shininess);
        [T::of(share) * diffuse, T::of(share) * base]
    })
}

#[cfg(test)]
mod tests {
    use std::ops::Add;

    use super::*;
    use crate::loops::{Counted, Operations, count};

    /// The vertices of a frame's mesh, each once.
    fn vertices(frame: &Frame) -> Vec<Point> {
        let mut all: Vec<Point> = Vec::new();
        for triangle in &frame.triangles {
            for (normal, position) in triangle.normals.into_iter().zip(triangle.positions) {
                let point = Point { normal, position, material: triangle.material };
                if !all.contains(&point) {
                    all.push(point);
                }
            }
        }
        all
    }

    /// A vertex of a mesh is lit once, however many triangles meet there.
    #[test]
    fn intensities_are_worked_out_once_a_vertex() {
        for scene in ["icosahedron", "teapot", "lamps"] {
            let frame = specula_scene::load(scene, Some((160, 120))).unwrap().frame;
            let vertices = vertices(&frame);
            assert!(vertices.len() < frame.triangles.len(), "{scene}");
            let lit_once =
                |&vertex: &Point| count(|| lit::<Counted>(&frame, vertex).for_each(drop));
            let once = vertices.iter().map(lit_once).fold(Operations::NONE, Add::add);
            let mesh = Mesh::of(&frame);
            assert_eq!(count(|| drop(lit_vertices::<Counted>(&mesh))), once, "{scene}");
            assert!(once.multiplies > 0, "{scene}");
        }
    }

    /// Half of the 20 faces are visible, and those of the 12 vertices that are not on the far side.
    #[test]
    fn triangles_of_an_icosahedron_share_nine_vertices() {
        let frame = specula_scene::load("icosahedron", None).unwrap().frame;
        assert_eq!((frame.triangles.len(), Mesh::of(&frame).vertices.len()), (10, 9));
    }
}

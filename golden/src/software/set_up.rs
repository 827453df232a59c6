//! Set-up of spans: what is worked out once for a frame, and what for each span.
use std::marker::PhantomData;

use specula_scene::{DirectionalLight, Frame, Span, Triangle};

use super::looped::{AlongSpan, OrPhong};
use crate::exact::coefficients::Amounts;
use crate::exact::diffuse::lambert;
use crate::exact::gouraud::amounts;
use crate::exact::{slerp, wrap};
use crate::recurrence::{AtVertices, Corners, Gouraud, Hybrid, Line, Pair, Phong, Scheme, Uniform};

/// Sets spans of a frame up.
pub trait SetUp<'a> {
    /// A light along a span.
    type Light: AlongSpan;

    /// Works out what belongs to the frame.
    fn new(frame: &'a Frame) -> Self;

    /// Adds the lights along a span, those at infinity first.
    fn span(&self, span: &Span, lights: &mut Vec<Self::Light>);
}

/// Each span by itself, under lights at infinity.
pub struct Each<'a, S> {
    frame: &'a Frame,
    scheme: PhantomData<S>,
}

impl<'a, S: Scheme<f32>> SetUp<'a> for Each<'a, S> {
    type Light = S;

    fn new(frame: &'a Frame) -> Self {
        Each { frame, scheme: PhantomData }
    }

    fn span(&self, span: &Span, lights: &mut Vec<S>) {
        let line = Line::new(self.frame, span);
        lights.extend(self.frame.lights.iter().map(|light| S::new(&line, light.direction)));
    }
}

/// Where a scheme serves a span.
pub trait Serves {
    /// Whether it serves this one.
    fn serves(line: &Line) -> bool;
}

/// Where slerp serves the end normals (extremes rows 13 to 15).
pub struct Arcs;

impl Serves for Arcs {
    fn serves(line: &Line) -> bool {
        slerp::angle(line.unit_ends()).is_some()
    }
}

/// Where the polygon's normal serves the triangle (extremes row 8).
pub struct Wraps;

impl Serves for Wraps {
    fn serves(line: &Line) -> bool {
        wrap::serves(line.face, &line.vertices)
    }
}

/// As [`Each`], and Phong's chord where the scheme does not serve.
pub struct Where<'a, S, W> {
    each: Each<'a, S>,
    serves: PhantomData<W>,
}

impl<'a, S: Scheme<f32>, W: Serves> SetUp<'a> for Where<'a, S, W> {
    type Light = OrPhong<S>;

    fn new(frame: &'a Frame) -> Self {
        Where { each: Each::new(frame), serves: PhantomData }
    }

    fn span(&self, span: &Span, lights: &mut Vec<OrPhong<S>>) {
        let line = Line::new(self.each.frame, span);
        let serves = W::serves(&line);
        let light = |light: &DirectionalLight| match serves {
            true => OrPhong::Scheme(S::new(&line, light.direction)),
            false => OrPhong::Phong(Phong::new(&line, light.direction)),
        };
        lights.extend(self.each.frame.lights.iter().map(light));
    }
}

/// A value for each light of each triangle.
struct OfTriangles<V> {
    lights: usize,
    values: Vec<V>,
}

impl<V> OfTriangles<V> {
    fn new<'a, I: Iterator<Item = V>>(frame: &'a Frame, of: impl Fn(&'a Triangle) -> I) -> Self {
        let values: Vec<V> = frame.triangles.iter().flat_map(of).collect();
        OfTriangles { lights: values.len() / frame.triangles.len().max(1), values }
    }

    /// Those of a span's triangle.
    fn of(&self, span: &Span) -> &[V] {
        &self.values[span.triangle * self.lights..][..self.lights]
    }
}

/// Intensities of a triangle's vertices, taken once for all of its spans, wherever the lights are.
pub struct Vertices(OfTriangles<AtVertices>);

impl<'a> SetUp<'a> for Vertices {
    type Light = Gouraud<f32>;

    fn new(frame: &'a Frame) -> Self {
        Vertices(OfTriangles::new(frame, |triangle| {
            let shininess = frame.materials[triangle.material].shininess;
            let [a, b, c] = [0, 1, 2]
                .map(|v| amounts(frame, shininess, triangle.normals[v], triangle.positions[v]));
            a.zip(b).zip(c).map(|((a, b), c)| AtVertices::new([a, b, c].map(pair)))
        }))
    }

    fn span(&self, span: &Span, lights: &mut Vec<Gouraud<f32>>) {
        let (weights, per_step) = ([span.start, span.end], span.weight_step());
        let along = |polygon| Gouraud::along(polygon, weights, per_step);
        lights.extend(self.0.of(span).iter().map(along));
    }
}

/// Intensities of a polygon, taken once for all of its spans, wherever the lights are.
pub struct Polygons(OfTriangles<Uniform<f32>>);

impl<'a> SetUp<'a> for Polygons {
    type Light = Uniform<f32>;

    fn new(frame: &'a Frame) -> Self {
        Polygons(OfTriangles::new(frame, |triangle| {
            let shininess = frame.materials[triangle.material].shininess;
            let facet = triangle.facet;
            amounts(frame, shininess, facet.normal, facet.middle).map(|at| Uniform::of(pair(at)))
        }))
    }

    fn span(&self, span: &Span, lights: &mut Vec<Uniform<f32>>) {
        lights.extend(self.0.of(span));
    }
}

/// Diffuse intensities of a triangle's vertices, taken once; the highlight for each span.
pub struct DiffuseVertices<'a> {
    frame: &'a Frame,
    diffuse: OfTriangles<Corners>,
}

impl<'a> SetUp<'a> for DiffuseVertices<'a> {
    type Light = Hybrid<f32>;

    fn new(frame: &'a Frame) -> Self {
        let lights = |triangle: &'a Triangle| {
            let diffuse = |l| Corners::new(triangle.normals.map(|normal| lambert(normal, l)));
            frame.lights.iter().map(move |light| diffuse(light.direction))
        };
        DiffuseVertices { frame, diffuse: OfTriangles::new(frame, lights) }
    }

    fn span(&self, span: &Span, lights: &mut Vec<Hybrid<f32>>) {
        let line = Line::new(self.frame, span);
        let polygon = self.frame.lights.iter().zip(self.diffuse.of(span));
        lights.extend(polygon.map(|(light, at)| Hybrid::along(at, &line, light.direction)));
    }
}

fn pair(amounts: Amounts) -> Pair<f64> {
    Pair { diffuse: amounts.diffuse, base: amounts.specular }
}

//! Quantities that are linear in triangles: computed once at each vertex of the mesh, stepped along
//! edges and then along spans [lecture, §3].
use std::collections::HashMap;

use specula_scene::Span;

use super::mesh::{Mesh, Point};
use crate::loops::{Edge, Linear, Plane};

/// N values for each light at each point, light after light.
pub(super) struct AtPoints<V, const N: usize> {
    lights: usize,
    values: Vec<[V; N]>,
}

impl<V, const N: usize> AtPoints<V, N> {
    /// Calls `of` once for each point.
    pub fn new<I: Iterator<Item = [V; N]>>(
        points: impl ExactSizeIterator<Item = Point>,
        of: impl Fn(Point) -> I,
    ) -> Self {
        let (number, mut values) = (points.len(), Vec::new());
        points.for_each(|point| values.extend(of(point)));
        AtPoints { lights: values.len() / number.max(1), values }
    }

    /// The values of a point's lights.
    pub fn of(&self, point: usize) -> &[[V; N]] {
        &self.values[point * self.lights..][..self.lights]
    }
}

/// N values for each light of each triangle, stepped down the triangles' edges.
pub(super) struct Planes<const N: usize> {
    edges: Vec<Edge>,
    lights: usize,
    planes: Vec<[Plane; N]>,
    /// Values at the vertices of triangles without such an edge, by their number.
    without_edge: HashMap<usize, Vec<[[f64; 3]; N]>>,
}

impl<const N: usize> Planes<N> {
    /// The quantities with these values at a mesh's vertices.
    pub fn new(mesh: &Mesh, vertices: &AtPoints<f64, N>) -> Self {
        let (lights, count) = (vertices.lights, mesh.corners.len());
        let mut planes = Planes {
            edges: Vec::with_capacity(count),
            lights,
            planes: Vec::with_capacity(count * lights),
            without_edge: HashMap::new(),
        };
        for (triangle, (edge, corners)) in mesh.edges().zip(&mesh.corners).enumerate() {
            let values = || at_corners(vertices, *corners);
            if edge.is_none() {
                planes.without_edge.insert(triangle, values().collect());
            }
            let edge = edge.unwrap_or_default();
            planes.edges.push(edge);
            planes.planes.extend(values().map(|values| of(&edge, &values)));
        }
        planes
    }

    /// Each light's values along a span.
    pub fn along(&mut self, span: &Span) -> impl Iterator<Item = [Linear<f32>; N]> {
        let planes = &mut self.planes[span.triangle * self.lights..][..self.lights];
        if let Some(values) = self.without_edge.get(&span.triangle) {
            let edge = Edge::of_span(span);
            self.edges[span.triangle] = edge;
            planes.iter_mut().zip(values).for_each(|(planes, values)| *planes = of(&edge, values));
        }
        let step = self.edges[span.triangle].to_span(span);
        planes.iter_mut().map(move |values| values.each_mut().map(|value| value.to_span(step)))
    }
}

/// N values of each light at the three corners of a triangle.
fn at_corners<const N: usize>(
    vertices: &AtPoints<f64, N>,
    corners: [usize; 3],
) -> impl Iterator<Item = [[f64; 3]; N]> {
    let [a, b, c] = corners.map(|vertex| vertices.of(vertex));
    let lights = a.iter().zip(b).zip(c);
    lights.map(|((a, b), c)| std::array::from_fn(|k| [a[k], b[k], c[k]]))
}

fn of<const N: usize>(edge: &Edge, values: &[[f64; 3]; N]) -> [Plane; N] {
    values.map(|at_corners| Plane::new(edge, at_corners))
}

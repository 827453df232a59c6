//! Quantities that are linear in triangles: computed once at each vertex of the mesh, stepped along
//! edges and then along spans [lecture, §3].
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
}

impl<const N: usize> Planes<N> {
    /// The quantities with these values at a mesh's vertices.
    pub fn new(mesh: &Mesh, vertices: &AtPoints<f64, N>) -> Self {
        let (edges, lights) = (mesh.edges(), vertices.lights);
        let mut planes = Vec::with_capacity(edges.len() * lights);
        for (edge, corners) in edges.iter().zip(&mesh.corners) {
            let [a, b, c] = corners.map(|vertex| vertices.of(vertex));
            for ((a, b), c) in a.iter().zip(b).zip(c) {
                planes.push(std::array::from_fn(|k| Plane::new(edge, [a[k], b[k], c[k]])));
            }
        }
        Planes { edges, lights, planes }
    }

    /// Each light's values along a span.
    pub fn along(&mut self, span: &Span) -> impl Iterator<Item = [Linear<f32>; N]> {
        let step = self.edges[span.triangle].to_span(span);
        let planes = &mut self.planes[span.triangle * self.lights..][..self.lights];
        planes.iter_mut().map(move |values| values.each_mut().map(|value| value.to_span(step)))
    }
}

//! Set-up of spans whose end normals come by slerp along edges.
use std::marker::PhantomData;

use specula_scene::{Frame, Span, Triangle};

use super::along_span::OrPhong;
use super::mesh::Mesh;
use super::set_up::{Arcs, Serves, SetUp, or_phong};
use crate::loops::{EdgeArcs, Line, Scheme};

/// Sets up spans from normals that turn along the edges of their triangles, under lights at infinity
/// [lecture, §4.4, step ii].
pub struct ArcEdges<'a, S> {
    frame: &'a Frame,
    /// The edges of each triangle; none where it has no outline along which normals turn.
    edges: Vec<Option<EdgeArcs>>,
    scheme: PhantomData<S>,
}

impl<'a, S: Scheme<f32>> SetUp<'a> for ArcEdges<'a, S> {
    type Light = OrPhong<S>;

    fn new(mesh: &'a Mesh<'a>) -> Self {
        let edges = |triangle: &Triangle| {
            triangle.linear_outline().map(|outline| EdgeArcs::new(outline, triangle.normals))
        };
        let edges = mesh.frame.triangles.iter().map(edges).collect();
        ArcEdges { frame: mesh.frame, edges, scheme: PhantomData }
    }

    fn span(&mut self, span: &Span, lights: &mut Vec<OrPhong<S>>) {
        let of_edges = self.edges[span.triangle].as_mut().and_then(|edges| edges.ends(span));
        let ends = of_edges.unwrap_or_else(|| {
            let arc = self.frame.arc_between_edges(span);
            [arc.start, arc.end]
        });
        let line = Line { ends, ..Line::new(self.frame, span) };
        let serves = Arcs::serves(&line);
        lights
            .extend(self.frame.lights.iter().map(|light| or_phong(serves, &line, light.direction)));
    }
}

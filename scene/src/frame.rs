//! The contents of a picture after visibility is settled: spans of visible triangles, in view
//! space.
//!
//! View space is right-handed, x to the right, y up, z against the direction in which the camera
//! looks. Its origin is the world's: it is turned and not moved. Highlights are seen from infinity in
//! the direction +z, V = (0, 0, 1), or from a place ([`Frame::eye`]).
use glam::{DVec2, DVec3};

use crate::arc::{Arc, or_the_other};
use crate::attenuation::Attenuation;
use crate::mesh::normals::newell;
use crate::perspective::Perspective;

/// The direction to the eye, in view space.
pub const EYE: DVec3 = DVec3::Z;

/// H = (L + V)/|L + V|, Blinn's half-way vector; 0 if the light is opposite the eye, where H has no
/// direction (extremes row 12).
pub fn halfway(light: DVec3) -> DVec3 {
    (light + EYE).normalize_or_zero()
}

/// A colour, red, green and blue; 1.0 is full scale of the 8-bit output.
pub type Colour = [f64; 3];

/// The reflectances of a surface. Their components are factors of products, 0 or more.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Reflectance of ambient light.
    pub ambient: Colour,
    /// Lambert's reflectance.
    pub diffuse: Colour,
    /// Reflectance of the highlight.
    pub specular: Colour,
    /// Phong's exponent n, 1 to 8191.
    pub shininess: u32,
}

/// A light at infinity.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionalLight {
    /// Unit vector towards the light, in view space.
    pub direction: DVec3,
    /// Its colour and strength.
    pub colour: Colour,
}

/// A light at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalLight {
    /// Its position in view space.
    pub position: DVec3,
    /// The spot that narrows it to a cone, if there is one.
    pub spot: Option<Spot>,
    /// How it becomes weaker with distance, if it does.
    pub attenuation: Option<Attenuation>,
    /// Its colour and strength.
    pub colour: Colour,
}

/// Warn's spot: the light's strength is multiplied by max(-L·axis, 0)^exponent [Hast et al., after
/// eq. 35].
#[derive(Clone, Debug, PartialEq)]
pub struct Spot {
    /// Unit vector along which it shines, in view space.
    pub axis: DVec3,
    /// The exponent p, 1 to 8191.
    pub exponent: u32,
}

/// The cone about a vertex normal that contains the normals of all faces around the vertex, as
/// consistent normal interpolation needs it [Reshetov, Soupikov and Mark; methods D].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexCone {
    /// The vertex normal, a unit vector. If it was 90 degrees or more from a face, it has been
    /// turned closer, if possible.
    pub axis: DVec3,
    /// m, the smallest cosine between the axis and the normal of a face around the vertex.
    pub cosine: f64,
}

impl VertexCone {
    /// The cone of a vertex among faces that all have its normal.
    pub fn flat(normal: DVec3) -> VertexCone {
        VertexCone { axis: normal, cosine: 1.0 }
    }
}

/// The polygon that a triangle belongs to, as flat shading uses it [lecture, eq. 1.1 and 2.1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Its unit normal; 0 where it has none.
    pub normal: DVec3,
    /// The mean of its corners.
    pub middle: DVec3,
}

impl Facet {
    /// The facet of a polygon by Newell's method, on the side from which its corners go
    /// counter-clockwise; `None` for a polygon without area.
    pub fn of_polygon(corners: &[DVec3]) -> Option<Facet> {
        let normal = newell(corners)?;
        Some(Facet { normal, middle: corners.iter().sum::<DVec3>() / corners.len() as f64 })
    }

    /// A substitute for the polygon of a triangle of which only the vertices are known: its normal
    /// is the mean direction of the vertex normals, or 0 if their sum is 0.
    pub fn of_vertices(normals: &[DVec3; 3], positions: &[DVec3; 3]) -> Facet {
        let normal = normals.iter().sum::<DVec3>().normalize_or_zero();
        Facet { normal, middle: positions.iter().sum::<DVec3>() / 3.0 }
    }
}

/// A visible triangle, with what shading needs.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    /// Unit normals at the three vertices, in view space.
    pub normals: [DVec3; 3],
    /// The polygon that it belongs to, in view space, with its normal on the visible side.
    pub facet: Facet,
    /// The three vertices, in view space.
    pub positions: [DVec3; 3],
    /// The three vertices in the picture, in pixels to the right and down from its top left corner,
    /// or the corners of the piece that is seen in `perspective`; it has an area. `None` for a
    /// triangle that is known only by a span.
    pub outline: Option<[DVec2; 3]>,
    /// What a perspective camera sees of it; `None` where lines of sight are parallel.
    pub perspective: Option<Perspective>,
    /// Cones about the normals, turned to the visible side as the normals are.
    pub cones: [VertexCone; 3],
    /// Index into [`Frame::materials`].
    pub material: usize,
}

/// One visible run of pixels of one triangle on one scan line.
#[derive(Clone, Debug, PartialEq)]
pub struct Span {
    /// Column of the first pixel.
    pub x: u32,
    /// Row, counted from the top.
    pub y: u32,
    /// Number of pixels, at least 1.
    pub length: u32,
    /// Index into [`Frame::triangles`].
    pub triangle: usize,
    /// Barycentric weights at the centre of the first pixel; they add up to 1.
    pub start: [f64; 3],
    /// Barycentric weights at the centre of the last pixel.
    pub end: [f64; 3],
}

impl Span {
    /// Number of steps from the first pixel to the last (S in docs/methods.md): `length` - 1, and 0
    /// for a single pixel.
    pub fn steps(&self) -> u32 {
        self.length - 1
    }

    /// 1/S, the increment of the parameter with each pixel; 0 in a span of one pixel.
    pub fn weight_step(&self) -> f64 {
        if self.steps() == 0 { 0.0 } else { f64::from(self.steps()).recip() }
    }

    /// The parameter t = i/S of pixel `i`, 0 to 1; 0 in a span of one pixel.
    pub fn parameter(&self, i: u32) -> f64 {
        if self.length == 1 { 0.0 } else { f64::from(i) / f64::from(self.steps()) }
    }

    /// m and k of the vector m + k i at pixel i that has these values at the first pixel and the
    /// last; k is 0 in a span of one pixel.
    pub fn start_and_step(&self, [start, end]: [DVec3; 2]) -> [DVec3; 2] {
        [start, (end - start) / f64::from(self.steps().max(1))]
    }

    /// Barycentric weights half-way between the first pixel and the last.
    pub fn middle(&self) -> [f64; 3] {
        std::array::from_fn(|v| f64::midpoint(self.start[v], self.end[v]))
    }

    /// Barycentric weights at pixel `i`.
    pub fn weights(&self, i: u32) -> [f64; 3] {
        let t = self.parameter(i);
        std::array::from_fn(|k| self.start[k] + t * (self.end[k] - self.start[k]))
    }
}

/// A picture to be shaded.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// 8-bit colour of pixels that no span covers.
    pub background: [u8; 3],
    /// Colour of the ambient light.
    pub ambient: Colour,
    /// Lights at infinity.
    pub lights: Vec<DirectionalLight>,
    /// Lights at places, which are counted after those at infinity; there is at least one light of
    /// either kind.
    pub local_lights: Vec<LocalLight>,
    /// The position of the eye that sees highlights, in view space; `None` for an eye at infinity
    /// in the direction [`EYE`]. What is visible does not depend on it.
    pub eye: Option<DVec3>,
    /// Materials, to which triangles refer.
    pub materials: Vec<Material>,
    /// Triangles, to which spans refer.
    pub triangles: Vec<Triangle>,
    /// Visible runs from top to bottom and left to right; no two share a pixel.
    pub spans: Vec<Span>,
}

impl Frame {
    /// Number of pixels that are shaded.
    pub fn shaded_pixels(&self) -> u64 {
        self.spans.iter().map(|s| u64::from(s.length)).sum()
    }

    /// The material of a span.
    pub fn material(&self, span: &Span) -> &Material {
        &self.materials[self.triangles[span.triangle].material]
    }

    /// The linearly interpolated, unnormalised normal of a span's triangle at barycentric
    /// `weights`.
    pub fn normal_at(&self, span: &Span, weights: [f64; 3]) -> DVec3 {
        interpolated(&self.triangles[span.triangle].normals, weights)
    }

    /// Colours of all lights, those at infinity first.
    pub fn light_colours(&self) -> impl Iterator<Item = Colour> + '_ {
        self.lights
            .iter()
            .map(|light| light.colour)
            .chain(self.local_lights.iter().map(|light| light.colour))
    }

    /// The point of a span's triangle at barycentric `weights`, in view space.
    pub fn position_at(&self, span: &Span, weights: [f64; 3]) -> DVec3 {
        let positions = &self.triangles[span.triangle].positions;
        positions[0] * weights[0] + positions[1] * weights[1] + positions[2] * weights[2]
    }

    /// What distance leaves of light number `index`, those at infinity counted first, at a span's
    /// first pixel, half-way, and at its last; `None` for a light that does not become weaker.
    pub fn attenuation_along(&self, span: &Span, index: usize) -> Option<[f64; 3]> {
        let light = &self.local_lights.get(index.checked_sub(self.lights.len())?)?;
        let attenuation = light.attenuation?;
        let at =
            |weights| attenuation.at((light.position - self.position_at(span, weights)).length());
        Some([span.start, span.middle(), span.end].map(at))
    }

    /// Vectors from a span's first and last pixel to a `place` in view space, scaled by one common
    /// factor so that the longer has length 1: the F - P of methods C15 to C18, scaled beforehand.
    /// Two vectors of length 0 stay 0.
    pub fn end_vectors_to(&self, span: &Span, place: DVec3) -> [DVec3; 2] {
        scaled_to_unit(
            [span.start, span.end].map(|weights| place - self.position_at(span, weights)),
        )
    }

    /// The normals at a span's first and last pixel, scaled by one common factor so that the longer
    /// has length 1.
    ///
    /// The common factor changes no direction along the span and keeps each interpolated normal
    /// within the unit ball. Two normals of length 0 stay 0.
    pub fn end_normals(&self, span: &Span) -> [DVec3; 2] {
        scaled_to_unit([self.normal_at(span, span.start), self.normal_at(span, span.end)])
    }

    /// The unit normals at a span's first and last pixel. If the interpolated normal vanishes at
    /// one end, that end gets the other's; if it vanishes at both, both are 0.
    pub fn unit_end_normals(&self, span: &Span) -> [DVec3; 2] {
        let normal = |weights| self.normal_at(span, weights).normalize_or_zero();
        or_the_other([span.start, span.end].map(normal))
    }

    /// The unit normal of the polygon that a span shows, on the visible side; 0 if it has none.
    pub fn facet_normal(&self, span: &Span) -> DVec3 {
        self.triangles[span.triangle].facet.normal
    }

    /// The axes of the vertices' cones at a span's first and last pixel, scaled as
    /// [`Frame::end_normals`].
    pub fn end_axes(&self, span: &Span) -> [DVec3; 2] {
        let axes = self.triangles[span.triangle].cones.map(|cone| cone.axis);
        scaled_to_unit([interpolated(&axes, span.start), interpolated(&axes, span.end)])
    }

    /// N(i) = m + k i along a span, scaled as [`Frame::end_normals`]: m and k. In a span of one
    /// pixel k is 0.
    pub fn normal_and_step(&self, span: &Span) -> [DVec3; 2] {
        span.start_and_step(self.end_normals(span))
    }

    /// The arc from the normal at a span's first pixel to that at its last, both interpolated linearly
    /// in the triangle.
    pub fn arc(&self, span: &Span) -> Arc {
        Arc::between(self.unit_end_normals(span))
    }

    /// A quantity of a triangle's vertices, interpolated linearly: its value at the first pixel and
    /// its step [lecture, eq. 3.2 to 3.6].
    pub fn interpolated(&self, span: &Span, at_vertices: [f64; 3]) -> [f64; 2] {
        let at = |weights: [f64; 3]| (0..3).map(|v| weights[v] * at_vertices[v]).sum::<f64>();
        let (start, end) = (at(span.start), at(span.end));
        [start, (end - start) / f64::from(span.steps().max(1))]
    }
}

/// Two vectors, scaled by one common factor so that the longer has length 1; two of length 0 stay
/// 0.
fn scaled_to_unit(ends: [DVec3; 2]) -> [DVec3; 2] {
    let longest = ends[0].length().max(ends[1].length());
    if longest > 0.0 { ends.map(|vector| vector / longest) } else { ends }
}

/// Vectors at a triangle's vertices, interpolated linearly.
fn interpolated(at_vertices: &[DVec3; 3], weights: [f64; 3]) -> DVec3 {
    at_vertices[0] * weights[0] + at_vertices[1] * weights[1] + at_vertices[2] * weights[2]
}

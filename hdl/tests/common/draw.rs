//! Specs and frames drawn at random, the same ones for the same seed.
use glam::DVec3;
use specula_scene::{
    DirectionalLight, Facet, Frame, LocalLight, Material, Needs, Span, Spot, Triangle, VertexCone,
};
use specula_spec::{CoreSpec, Method};

#[path = "../../../scene/tests/common/any_spec.rs"]
mod any_spec;

use any_spec::any_spec;

/// Draws numbers [Steele, Lea and Flood, SplitMix64].
pub struct Draw(u64);

impl Draw {
    /// A stream of numbers; the test's output says which.
    pub fn new(seed: u64) -> Draw {
        println!("seed {seed}");
        Draw(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^ (bits >> 31)
    }

    /// A number from 0 to 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A whole number from `low` to `high`, the ends four times as often as their share: that is
    /// where faults are.
    pub fn between(&mut self, low: u32, high: u32) -> u32 {
        match self.bits() % 8 {
            0 => low,
            1 => high,
            _ => low + (self.bits() % u64::from(high - low + 1)) as u32,
        }
    }

    /// One of `choices`.
    pub fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[(self.bits() % choices.len() as u64) as usize]
    }

    /// A unit vector, on an axis now and then.
    pub fn direction(&mut self) -> DVec3 {
        if self.bits().is_multiple_of(8) {
            return self.one_of(&[DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z]);
        }
        let within = |draw: &mut Draw| 2.0 * draw.unit() - 1.0;
        let vector = DVec3::new(within(self), within(self), within(self));
        vector.try_normalize().unwrap_or(DVec3::Z)
    }
}

/// Triangles in a frame, each with a span.
const TRIANGLES: usize = 6;

/// A frame of a few triangles and a span of each, one to a row; the first span is the longest.
pub fn frame(draw: &mut Draw, longest: u32) -> Frame {
    let lengths: Vec<u32> =
        (0..TRIANGLES).map(|i| if i == 0 { longest } else { draw.between(1, longest) }).collect();
    let lights = draw.between(1, 4);
    let local = draw.between(0, lights);
    let viewer = draw.between(0, 1);
    let even = draw.one_of(&[true, false]);
    let triangles: Vec<Triangle> =
        (0..TRIANGLES).map(|material| triangle(draw, material)).collect();
    Frame {
        width: longest,
        height: TRIANGLES as u32,
        background: [1, 2, 3],
        ambient: [draw.unit(); 3],
        lights: (local..lights)
            .map(|_| DirectionalLight { direction: draw.direction(), colour: colour(draw, 2.0) })
            .collect(),
        local_lights: (0..local).map(|_| local_light(draw, &triangles)).collect(),
        eye: (0..viewer).map(|_| place_about(draw, &triangles)).next(),
        materials: (0..TRIANGLES).map(|_| material(draw, even)).collect(),
        triangles,
        spans: lengths
            .into_iter()
            .enumerate()
            .map(|(row, length)| span(draw, row, length))
            .collect(),
    }
}

/// Anywhere, or at the very corner of a triangle.
fn place_about(draw: &mut Draw, triangles: &[Triangle]) -> DVec3 {
    match draw.between(0, 3) {
        0 => draw.one_of(triangles[0].positions.as_slice()),
        _ => 5.0 * draw.unit() * draw.direction(),
    }
}

fn local_light(draw: &mut Draw, triangles: &[Triangle]) -> LocalLight {
    let spot = Spot { axis: draw.direction(), exponent: draw.between(1, 8191) };
    let spot = draw.one_of(&[true, false]).then_some(spot);
    LocalLight { position: place_about(draw, triangles), spot, colour: colour(draw, 2.0) }
}

fn colour(draw: &mut Draw, brightest: f64) -> [f64; 3] {
    std::array::from_fn(|_| brightest * draw.unit())
}

/// The exponent is a power of two where it is to be `even`.
fn material(draw: &mut Draw, even: bool) -> Material {
    let log2 = draw.between(0, 12);
    let shininess = if even { 1 << log2 } else { draw.between(1, 8191).min(2 << log2) };
    Material {
        ambient: colour(draw, 1.0),
        diffuse: colour(draw, 1.0),
        specular: colour(draw, 1.0),
        shininess: shininess.min(8191),
    }
}

fn triangle(draw: &mut Draw, material: usize) -> Triangle {
    let normals = normals(draw);
    let place = |draw: &mut Draw| 3.0 * draw.unit() * draw.direction();
    // All flat, all as wide as can be, or anything.
    let cosine: [f64; 3] = match draw.between(0, 3) {
        0 => [1.0; 3],
        1 => [0.0; 3],
        _ => std::array::from_fn(|_| 1.2 * draw.unit() - 0.2),
    };
    let cone = |v: usize| VertexCone { axis: normals[v], cosine: cosine[v] };
    let positions = [place(draw), place(draw), place(draw)];
    let of_vertices = Facet::of_vertices(&normals, &positions);
    // A polygon's normal may be anywhere among those of its vertices, or nowhere near them.
    let facet = match draw.between(0, 1) {
        0 => of_vertices,
        _ => Facet { normal: draw.direction(), ..of_vertices },
    };
    Triangle {
        normals,
        facet,
        positions,
        outline: None,
        cones: std::array::from_fn(cone),
        material,
    }
}

/// Normals of a vertex each: near each other, anywhere, or opposite.
fn normals(draw: &mut Draw) -> [DVec3; 3] {
    let first = draw.direction();
    let nearby = |draw: &mut Draw, away: f64| {
        (first + away * draw.direction()).try_normalize().unwrap_or(first)
    };
    match draw.between(0, 3) {
        0 => [first; 3],
        1 => [first, -first, draw.direction()],
        2 => [first, draw.direction(), draw.direction()],
        _ => [first, nearby(draw, 0.5), nearby(draw, 0.5)],
    }
}

fn span(draw: &mut Draw, row: usize, length: u32) -> Span {
    let weights = |draw: &mut Draw| {
        let (a, b) = (draw.unit(), draw.unit());
        [a, (1.0 - a) * b, (1.0 - a) * (1.0 - b)]
    };
    let (start, end) = match draw.between(0, 2) {
        0 => ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        _ => (weights(draw), weights(draw)),
    };
    Span { x: 0, y: row as u32, length, triangle: row, start, end }
}

/// A spec for `frame` with any formats and options that [`CoreSpec::check`] accepts.
pub fn spec(draw: &mut Draw, frame: &Frame, method: Method) -> CoreSpec {
    let mut needs = Needs::of(frame);
    needs.longest_span = draw.one_of(&[needs.longest_span, 8192]);
    let mut spec = any_spec(&needs, method, |low, high| draw.between(low, high));
    spec.coefficient.integer_bits = draw.between(spec.coefficient.integer_bits, 16);
    spec
}

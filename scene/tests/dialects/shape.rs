//! Meshes that tests write in many dialects.

/// Places of vertices, and triangles that name them; no vertex is stated twice.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Places, in single precision as most files have them.
    pub positions: Vec<[f32; 3]>,
    /// Indices of three vertices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Shape {
    /// Each triangle with vertices of its own.
    pub fn unshared(&self) -> Shape {
        let corners = self.triangles.iter().flatten();
        let positions: Vec<[f32; 3]> = corners.map(|&k| self.positions[k as usize]).collect();
        let triangles =
            (0..self.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        Shape { positions, triangles }
    }

    /// All places times a factor, which is a power of two so that nothing is rounded.
    pub fn scaled(&self, factors: [f32; 3]) -> Shape {
        let scaled = |p: &[f32; 3]| [p[0] * factors[0], p[1] * factors[1], p[2] * factors[2]];
        Shape {
            positions: self.positions.iter().map(scaled).collect(),
            triangles: self.triangles.clone(),
        }
    }

    /// All triangles turned around.
    pub fn turned_around(&self) -> Shape {
        Shape {
            positions: self.positions.clone(),
            triangles: self.triangles.iter().map(|&[a, b, c]| [a, c, b]).collect(),
        }
    }

    /// All triangles as one strip, held together by triangles without area: each begins at an even
    /// place, so that none is turned around.
    pub fn strip(&self) -> Vec<u32> {
        let mut strip: Vec<u32> = Vec::new();
        for &[a, b, c] in &self.triangles {
            if let Some(&last) = strip.last() {
                strip.extend([last, last, a]);
            }
            strip.extend([a, b, c]);
        }
        strip
    }
}

/// Five vertices and six triangles, closed, without symmetry.
pub fn wedge() -> Shape {
    Shape {
        positions: vec![
            [0.0, 0.0, 0.0],
            [2.0, 0.0, 0.0],
            [0.0, 1.5, 0.0],
            [0.0, 0.0, 1.0],
            [1.25, 0.25, 1.5],
        ],
        triangles: vec![[0, 2, 1], [0, 1, 4], [0, 4, 3], [0, 3, 2], [1, 2, 4], [2, 3, 4]],
    }
}

//! What a picture of faces in parallel projection covers, found pixel by pixel from the test's own
//! geometry.

/// Width and height of the picture in pixels.
pub const SIZE: [u32; 2] = [44, 33];

/// Pixels whose middle is nearer than this to an edge, in pixels, say nothing: vertices are rounded
/// to 1/256 of a pixel.
const NEAR: f64 = 0.02;

/// How a picture is looked at.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Towards the eye.
    pub direction: [f64; 3],
    /// What is at the picture's middle.
    pub target: [f64; 3],
    /// Units from the picture's bottom to its top.
    pub height: f64,
}

impl View {
    /// Where a point is in the picture, in pixels from the top left corner; y is up in the world.
    fn place(&self, point: [f32; 3]) -> [f64; 2] {
        let backward = unit(self.direction);
        let right = unit(cross([0.0, 1.0, 0.0], backward));
        let up = cross(backward, right);
        let relative = [0, 1, 2].map(|k| f64::from(point[k]) - self.target[k]);
        let scale = f64::from(SIZE[1]) / self.height;
        [
            f64::from(SIZE[0]) / 2.0 + scale * dot(relative, right),
            f64::from(SIZE[1]) / 2.0 - scale * dot(relative, up),
        ]
    }

    /// For each pixel, row by row, whether one of the faces covers its middle; none where that
    /// hangs on rounding.
    pub fn covered(&self, positions: &[[f32; 3]], faces: &[Vec<u32>]) -> Vec<Option<bool>> {
        let placed =
            |face: &Vec<u32>| face.iter().map(|&k| self.place(positions[k as usize])).collect();
        let placed: Vec<Vec<[f64; 2]>> = faces.iter().map(placed).collect();
        let pixels = (0..SIZE[1])
            .flat_map(|y| (0..SIZE[0]).map(move |x| [f64::from(x) + 0.5, f64::from(y) + 0.5]));
        pixels.map(|middle| covers(&placed, middle)).collect()
    }
}

fn covers(faces: &[Vec<[f64; 2]>], middle: [f64; 2]) -> Option<bool> {
    let edges = |face: &[[f64; 2]]| {
        face.iter()
            .copied()
            .zip(face.iter().copied().cycle().skip(1))
            .take(face.len())
            .collect::<Vec<_>>()
    };
    let all: Vec<Vec<([f64; 2], [f64; 2])>> = faces.iter().map(|face| edges(face)).collect();
    if all.iter().flatten().any(|&(a, b)| distance(middle, a, b) < NEAR) {
        return None;
    }
    let [x, y] = middle;
    let crosses = |&&(a, b): &&([f64; 2], [f64; 2])| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    };
    Some(all.iter().any(|edges| edges.iter().filter(crosses).count() % 2 == 1))
}

fn distance(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (along, from) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let length_squared = along[0] * along[0] + along[1] * along[1];
    let t = if length_squared > 0.0 {
        ((from[0] * along[0] + from[1] * along[1]) / length_squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (from[0] - t * along[0]).hypot(from[1] - t * along[1])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    v.map(|x| x / dot(v, v).sqrt())
}

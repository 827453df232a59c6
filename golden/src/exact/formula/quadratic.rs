//! Polynomials along a scan line [Hast, Barrera and Bengtsson, eq. 3 to 8; methods C2].
use glam::DVec3;

/// The polynomial A x² + B x + C along a scan line, x = 0 to S.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadratic(pub [f64; 3]);

impl Quadratic {
    /// (k·a x + m·a)(k·b x + m·b), for a normal m + k x.
    pub fn product(m: DVec3, k: DVec3, a: DVec3, b: DVec3) -> Quadratic {
        Quadratic([
            k.dot(a) * k.dot(b),
            k.dot(a) * m.dot(b) + m.dot(a) * k.dot(b),
            m.dot(a) * m.dot(b),
        ])
    }

    /// (m + k x)² [eq. 4].
    pub fn square(m: DVec3, k: DVec3) -> Quadratic {
        Quadratic([k.dot(k), 2.0 * k.dot(m), m.dot(m)])
    }

    /// The one that has these values at x = 0, 1/2 and 1.
    pub fn through([first, half, last]: [f64; 3]) -> Quadratic {
        let a = 2.0 * first - 4.0 * half + 2.0 * last;
        Quadratic([a, last - first - a, first])
    }

    /// The same over x = 0 to `steps` as this one over 0 to 1.
    pub fn stretched(self, steps: f64) -> Quadratic {
        let [a, b, c] = self.0;
        Quadratic([a / (steps * steps), b / steps, c])
    }

    /// `self` + `factor` · `other`.
    pub fn plus(self, factor: f64, other: Quadratic) -> Quadratic {
        Quadratic(std::array::from_fn(|c| self.0[c] + factor * other.0[c]))
    }

    /// The value at x.
    pub fn at(self, x: f64) -> f64 {
        let [a, b, c] = self.0;
        (a * x + b) * x + c
    }

    /// [C, A + B, 2A]: value, first and second forward difference at x = 0 [eq. 6 to 8].
    pub fn differences(self) -> [f64; 3] {
        let [a, b, c] = self.0;
        [c, a + b, 2.0 * a]
    }
}

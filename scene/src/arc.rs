//! Great circles between unit normals [lecture, eq. 4.7; methods A8, A11].
use glam::DVec3;

/// The great circle that a normal follows from one unit vector to another, its angle growing
/// steadily.
#[derive(Clone, Debug, PartialEq)]
pub struct Arc {
    /// A, the unit normal at its start; 0 if there is none at either end.
    pub start: DVec3,
    /// The unit normal at its end; 0 if there is none at either end.
    pub end: DVec3,
    /// T, the unit vector perpendicular to A, towards the end; 0 if there is no angle between them.
    pub across: DVec3,
    /// The angle f between the two normals, in radians, 0 to π.
    pub angle: f64,
}

impl Arc {
    /// The arc between two unit normals: N(t) = cos(t f) A + sin(t f) T, which needs no division by
    /// sin f. If one of them is 0, that end gets the other's.
    ///
    /// Opposite normals do not determine a plane of rotation; T is then one of the vectors
    /// perpendicular to A.
    pub fn between(ends: [DVec3; 2]) -> Arc {
        let [a, b] = or_the_other(ends);
        let axis = a.cross(b);
        let across = axis.cross(a).try_normalize().unwrap_or(if a.dot(b) < 0.0 {
            a.any_orthonormal_vector()
        } else {
            DVec3::ZERO
        });
        // An arc cosine of the rounded dot product would lose small angles (extremes row 15).
        Arc { start: a, end: b, across, angle: libm::atan2(axis.length(), a.dot(b)) }
    }

    /// The unit normal at the angle `turn` from A, in radians.
    pub fn turned(&self, turn: f64) -> DVec3 {
        self.start * libm::cos(turn) + self.across * libm::sin(turn)
    }

    /// The unit normal at `t`, 0 to 1: slerp of both ends.
    pub fn at(&self, t: f64) -> DVec3 {
        match t {
            t if t <= 0.0 => self.start,
            t if t >= 1.0 => self.end,
            t => self.turned(t * self.angle),
        }
    }

    /// The part of it from t = `from` to t = `to`, 0 to 1, `from` no more than `to`.
    pub fn part(&self, [from, to]: [f64; 2]) -> Arc {
        let first = from * self.angle;
        Arc {
            start: self.at(from),
            end: self.at(to),
            across: self.across * libm::cos(first) - self.start * libm::sin(first),
            angle: (to - from) * self.angle,
        }
    }
}

/// Two normals; where one of them is 0, the other in its place.
pub(crate) fn or_the_other([start, end]: [DVec3; 2]) -> [DVec3; 2] {
    let or = |normal: DVec3, other: DVec3| if normal == DVec3::ZERO { other } else { normal };
    [or(start, end), or(end, start)]
}

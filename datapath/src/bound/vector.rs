//! What is known of a vector as a whole, which is less than what its components say each by itself.

/// Bounds on the lengths of a vector and on its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VectorBound {
    /// s: the real vector is no shorter.
    pub shortest: f64,
    /// The fixed vector is no longer.
    pub longest: f64,
    /// How far both are apart.
    pub error: VectorError,
    /// The largest bound on the error of a component.
    pub component_error: f64,
}

impl VectorBound {
    /// A vector off by no more than `error`, whatever the direction.
    pub fn ball(shortest: f64, longest: f64, error: f64) -> VectorBound {
        let component_error = error;
        VectorBound { shortest, longest, error: VectorError::ball(error), component_error }
    }

    /// s - e: fixed and real vector are both no shorter, where it is above 0.
    pub fn surely(self) -> f64 {
        self.shortest - self.error.length
    }

    /// t, how far the directions of fixed and real vector are apart, as the distance of unit
    /// vectors; for e < s.
    ///
    /// ```text
    /// |â - b̂|² = 2 - 2 â·b̂
    ///          = (|a - b|² - (|a| - |b|)²) / (|a||b|)
    ///          ≤ e² / (s (s - e))
    /// ```
    pub fn turn(self) -> f64 {
        self.error.length / (self.shortest * self.surely()).sqrt()
    }
}

/// Bounds on the error of a vector as a whole: lengths, where bounds on the errors of its components count
/// each of them at its worst.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VectorError {
    /// In any direction.
    pub length: f64,
    /// Across the real vector: what turns it.
    pub transverse: f64,
    /// Along the real vector: what makes it longer or shorter.
    pub radial: f64,
    /// So much of both is one error, whatever its direction.
    pub isotropic: f64,
}

impl VectorError {
    /// Nothing is known.
    pub const UNKNOWN: VectorError = VectorError::ball(f64::INFINITY);

    /// By no more than `length`, whatever the direction.
    pub const fn ball(length: f64) -> VectorError {
        VectorError { length, transverse: length, radial: length, isotropic: length }
    }

    /// By no more than these across and along the vector.
    pub fn components(transverse: f64, radial: f64) -> VectorError {
        VectorError { length: transverse.hypot(radial), transverse, radial, isotropic: 0.0 }
    }

    /// How far a linear function of the vector is off, which passes errors on with this
    /// sensitivity.
    pub fn propagated(self, sensitivity: Sensitivity) -> f64 {
        if self.length.is_infinite() {
            return f64::INFINITY;
        }
        let parts = sensitivity.transverse * (self.transverse - self.isotropic).max(0.0)
            + sensitivity.radial * (self.radial - self.isotropic).max(0.0);
        let error = parts + sensitivity.isotropic * self.isotropic;
        // A part of 0 with a gain without limit: nothing is known.
        if error.is_nan() { f64::INFINITY } else { error }
    }

    /// Bound on the error of the length of a real unit vector; infinite where nothing of it
    /// may be left.
    ///
    /// With t for the transverse and r for the radial error
    ///
    /// ```text
    /// |V'| ≥ 1 - r
    /// |V'| = √((1 + r)² + t²) ≤ 1 + r + t²/2
    /// ```
    pub fn stretch(self) -> f64 {
        if self.radial < 1.0 {
            self.radial + self.transverse * self.transverse / 2.0
        } else {
            f64::INFINITY
        }
    }

    /// And by no more than `length` besides.
    pub fn enlarged_by(self, length: f64) -> VectorError {
        VectorError {
            length: self.length + length,
            transverse: self.transverse + length,
            radial: self.radial + length,
            isotropic: self.isotropic + length,
        }
    }

    /// What both bounds leave. Parts of one and the other are no longer one error.
    pub fn intersection(self, other: VectorError) -> VectorError {
        let VectorError { length, transverse, radial, .. } = other;
        let is_within = |a: &VectorError, b: &VectorError| {
            a.length <= b.length && a.transverse <= b.transverse && a.radial <= b.radial
        };
        let isotropic = match (is_within(&self, &other), is_within(&other, &self)) {
            (true, _) => self.isotropic,
            (_, true) => other.isotropic,
            _ => 0.0,
        };
        VectorError {
            length: self.length.min(length),
            transverse: self.transverse.min(transverse),
            radial: self.radial.min(radial),
            isotropic,
        }
    }

    /// The angle by which it turns a real unit vector at most, in radians; a half turn where it may
    /// be longer than that vector.
    pub fn angle(self) -> f64 {
        let shortest = 1.0 - self.radial;
        if self.transverse < shortest {
            (self.transverse / shortest).atan()
        } else {
            std::f64::consts::PI
        }
    }
}

/// By how much errors of a vector show in what is computed of it, for each direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// Across the vector.
    pub transverse: f64,
    /// Along it.
    pub radial: f64,
    /// In the direction in which they show most.
    pub isotropic: f64,
}

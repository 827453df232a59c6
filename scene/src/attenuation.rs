//! Light that becomes weaker with the distance from where it is [Hast, Barrera and Bengtsson, §1].

/// A light's strength is multiplied by min(1, 1/(c + l d + q d²)) at the distance d, in units of the
/// world; its numbers are 0 or more and finite, and not all of them 0.
///
/// "Sometimes a distance term is used, since the intensity of light becomes smaller with increased
/// distance" [§1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attenuation {
    /// c.
    pub constant: f64,
    /// l, for a unit of distance.
    pub linear: f64,
    /// q, for the square of it.
    pub quadratic: f64,
}

impl Attenuation {
    /// The share of the light that arrives at a distance of 0 or more, 0 to 1.
    pub fn at(&self, distance: f64) -> f64 {
        (self.constant + distance * (self.linear + distance * self.quadratic)).max(1.0).recip()
    }
}

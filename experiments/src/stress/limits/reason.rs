//! Reasons why a method may have an error beyond the rounding of its core, according to the papers
//! or to measurements of them.
use serde::Serialize;

/// A documented limit. `docs/extremes.md` lists all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reason {
    /// Formats: the core's proven bound is above 1 LSB.
    Rounding,
    /// Formats that the row shortens.
    ShortFormats,
    /// There is no proven bound for a core with recommended formats.
    NoBound,
    /// There is no proven bound and the normal is shorter than 1/2.
    ShortNormal,
    /// The interpolated normal vanishes.
    NoNormal,
    /// Interpolated intensities instead of normals.
    Vertices,
    /// Diffuse light from the vertices.
    GouraudDiffuse,
    /// One normal or intensity for a whole polygon.
    Facet,
    /// A highlight other than max(R·L, 0)^n.
    Lobe,
    /// f_k instead of the power.
    Shape,
    /// Unit normals at a span's ends that were not unit vectors.
    UnitEnds,
    /// Lyon's approximations of 1/|N|.
    Length,
    /// Normals wrapped around a fixed one.
    Wrap,
    /// Normals wrapped around the previous ones.
    Chain,
    /// The arc instead of the chord.
    Arc,
    /// A chord that is not normalised.
    Chord,
    /// Reflections that never enter the surface.
    Consistent,
    /// Newton's root.
    Newton,
    /// One direction to a light or eye for a whole span.
    Middle,
    /// Wrapped directions to lights and eye.
    WrappedPlaces,
    /// A quadratic in place of what distance leaves of a light.
    Attenuation,
}

impl Reason {
    /// Every reason.
    pub const ALL: [Reason; 21] = [
        Reason::Rounding,
        Reason::ShortFormats,
        Reason::NoBound,
        Reason::ShortNormal,
        Reason::NoNormal,
        Reason::Vertices,
        Reason::GouraudDiffuse,
        Reason::Facet,
        Reason::Lobe,
        Reason::Shape,
        Reason::UnitEnds,
        Reason::Length,
        Reason::Wrap,
        Reason::Chain,
        Reason::Arc,
        Reason::Chord,
        Reason::Consistent,
        Reason::Newton,
        Reason::Middle,
        Reason::WrappedPlaces,
        Reason::Attenuation,
    ];

    /// The name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Reason::Rounding => "rounding",
            Reason::ShortFormats => "short formats",
            Reason::NoBound => "no bound",
            Reason::ShortNormal => "short normal",
            Reason::NoNormal => "no normal",
            Reason::Vertices => "vertices",
            Reason::GouraudDiffuse => "Gouraud diffuse",
            Reason::Facet => "facet",
            Reason::Lobe => "lobe",
            Reason::Shape => "shape",
            Reason::UnitEnds => "unit ends",
            Reason::Length => "length",
            Reason::Wrap => "wrap",
            Reason::Chain => "chain",
            Reason::Arc => "arc",
            Reason::Chord => "chord",
            Reason::Consistent => "consistent",
            Reason::Newton => "Newton",
            Reason::Middle => "middle",
            Reason::WrappedPlaces => "wrapped places",
            Reason::Attenuation => "attenuation",
        }
    }

    /// What is wrong, by how much at most, and the source. δ is an angle in radians; kd and ks are
    /// the shares of a light that a surface reflects.
    pub const fn text(self) -> &'static str {
        match self {
            Reason::Rounding => {
                "the core's formats: no code is farther from its method than the proven bound, which is above 1 LSB \
                 (the report of `run` has it, error-bounds.md derives it)"
            }
            Reason::ShortFormats => {
                "formats that the row makes shorter than is recommended: the figure is the row's, from numerics N3a to 3d"
            }
            Reason::NoBound => {
                "1.5 LSB: nothing is proven of the core (its bound is 255 LSB), and recommended formats leave 1 LSB before the rounding to \
                 8 bits (numerics N5); 2 LSB for powers above 256, 4n by half-way vectors, for which formats end at 22 fraction bits: 1.8 was seen"
            }
            Reason::ShortNormal => {
                "no limit: nothing is proven of the core (its bound is 255 LSB), and the normal is shorter than 1/2, that is in a span of \
                 more than 120 degrees, where rounding turns it by 1/|N| times as much (numerics N3b and 3c; extremes rows 3 and 19)"
            }
            Reason::NoNormal => {
                "no limit: the interpolated normal vanishes, and has no direction (extremes rows 1, 2, 50)"
            }
            Reason::Vertices => {
                "ks times what the highlights of the vertices, interpolated, differ from that of the normal (lecture, eq. 2.1 and 3.2 to \
                 3.6; methods A4); no limit but kd + ks where lights or eye are at places, which the vertices see"
            }
            Reason::GouraudDiffuse => {
                "kd (1 - |N| + d): intensities of vertices are interpolated, |N| is the length of the interpolated normal and d what \
                 vertices in the dark lack, the sum of w max(-N_v·L, 0) (lecture, eq. 3.2 to 3.6)"
            }
            Reason::Facet => {
                "as unit ends, with δ the angle between the polygon's normal and N (lecture, eq. 2.1; methods A3)"
            }
            Reason::Lobe => {
                "ks times what the lobe that is asked for differs from max(R·L, 0)^n at this pixel, by the formulas of Lyon's appendix \
                 (methods B5 to B8, C8, C12); no limit but ks where |L + V| < 1/8 leaves no half-way vector (extremes rows 12 and 35), or \
                 lights or eye are at places"
            }
            Reason::Shape => {
                "ks times the largest |f_k - cos^n|, at most .368, .162, .074 and .036 for large n and k = 0 to 3 (numerics N2a)"
            }
            Reason::UnitEnds => {
                "kd 2 sin(δ/2) + ks s 2δ: the ends of the span are made unit vectors before the normal is interpolated, δ is the angle \
                 that this turns it by, s the steepest slope of cos^n, √n (1 - 1/n)^((n-1)/2)"
            }
            Reason::Length => {
                "kd |1 - l| + ks √(2n) 2|1 - l²|, the steepest slope of f_0: l is the length that g1, g2 and Newton's steps leave (methods B8, B9; numerics N1)"
            }
            Reason::Wrap => {
                "as unit ends, with δ = θ - 2 atan(l sin θ/(1 + l cos θ)), θ the angle between the axis and N and l = |N| (numerics N2b)"
            }
            Reason::Chain => {
                "as wrap, with the axis behind by what the pixel before was short of its normal (numerics N2b)"
            }
            Reason::Arc => {
                "as unit ends, with δ the angle between arc and chord (numerics N2d; extremes row 17); none for opposite ends (14)"
            }
            Reason::Chord => {
                "kd (1 - l) + ks n 2(1 - l²) with l = |N|(3 - |N|²)/2, in spans below 10 degrees (arithmetic/slerp.md)"
            }
            Reason::Consistent => {
                "no limit but the share: consistent normals are meant to be others wherever a surface is curved (methods D; numerics N2c \
                 has 10 to 77 LSB as a mean)"
            }
            Reason::Newton => {
                "kd e/(1 + e): e is how much too long the root is, e²/(2(1 + e)) after each step (numerics N3c; extremes rows 18 to 20)"
            }
            Reason::Middle => {
                "kd (2 sin(δ/2) + f) + ks (s δ + f): the span's middle sees lights and eye for all of it, δ is the angle to what the \
                 pixel sees and f the difference of the spots' factors (decision 0008)"
            }
            Reason::WrappedPlaces => {
                "as middle, with the δ of wrap and of unit ends: for a light nearer to a span than the span is long next to no limit \
                 (methods C16 to C18; extremes rows 11 and 40)"
            }
            Reason::Attenuation => {
                "(kd + ks) |Q - A|: Q is a quadratic through A = min(1, 1/(c + l d + q d²)) at both ends of the span and half-way \
                 (decision 0043)"
            }
        }
    }
}

//! Approximate normalisation.
use specula_scene::Format;
use specula_scene::spec::lyon::{LOG2_LARGEST_GAIN, LyonFormats, LyonSpec, Normalisation};

use super::{ExactNormalisation, ReciprocalRoot, normalise_exactly};
use crate::builder::{Builder, Sig, Vector};

/// How long a normal can come out that was no longer than `longest`, before rounding.
///
/// With r = |N'|, g2 r = 2r - 3/2 r³ + 1/2 r⁵ overshoots to 1.00176 at r = 0.894 (METHODS B9), is 1 at r = 1 and grows from there on.
/// g1 r is 1 at most, and so is r g after a Newton step.
fn longest_scaled(longest: f64) -> f64 {
    let beyond = 2.0 * longest - 1.5 * longest.powi(3) + 0.5 * longest.powi(5);
    if longest > 1.0 { beyond.max(1.002) } else { 1.002 }
}

fn coarsest_ulp(formats: &LyonFormats) -> f64 {
    [formats.vector, formats.length_squared, formats.gain].map(Format::ulp).into_iter().fold(0.0, f64::max)
}

/// Brings N' near unit length: n = g N' with g about 1/|N'|. [Lyon, TR 43; METHODS B8, B9]
///
/// Both ends of a span lie in the unit ball, so |N'| ≤ 1 up to rounding. n is off by g e_N' + |N'| e_g, with the bounds of
/// [`GainBound`] for normals no shorter than `shortest`.
///
/// Beside n goes a bit that says whether N' has a direction at all (EXTREMES row 1). It is off by 1 where rounding may decide that.
pub fn normalise(b: &Builder, normal: &Vector, lyon: &LyonSpec, shortest: f64) -> (Vector, Sig) {
    let f = &lyon.formats;
    let (first, formula) = match lyon.normalisation {
        Normalisation::None => return unnormalised(b, normal, shortest),
        Normalisation::Exact => return normalise_exactly(b, normal, exactly(f), shortest),
        Normalisation::G1 => (FirstGain::G1, "n = g N', g = 1 + y/2, y = 1 - N'.N' [Lyon, TR 43]"),
        Normalisation::G2 => (FirstGain::G2, "n = g N', g = 1 + (y + y^2)/2, y = 1 - N'.N' [Lyon, TR 43]"),
    };
    b.unit("normalise", formula, (("normal", normal),), |b, (normal,)| {
        let longest = longest_scaled(normal.longest());
        let z = normal
            .length_squared_within(normal.longest(), "|N'| <= 1")
            .rounded(f.length_squared.fraction_bits)
            .named("length_squared");
        let mut bound = GainBound::first(first, shortest, z.error_value(), f.gain.ulp());
        let mut g = first_gain(b, &z, first, f).proven_error_value(bound.error).named("gain");
        for _ in 0..lyon.newton_steps {
            bound = bound.after_newton_step();
            g = newton_step(b, &g, &z, f, longest).proven_error_value(bound.error);
        }
        let e_normal = normal.largest_error();
        let error = bound.largest * e_normal + (1.0 + e_normal) * bound.error;
        let n = normal.scaled(&g).proven_error_value(error).rounded(f.vector.fraction_bits);
        let unsure = if direction_is_sure(shortest, e_normal, f) { 0.0 } else { 1.0 };
        let has_direction = b.integer(0).less_than(&z).named("has_direction").stated_error_value(unsure);
        // Each of a few roundings adds some units of the coarsest format's last place.
        (n.assumed_within(longest + 8.0 * coarsest_ulp(f), "|g N'| <= 1.002").named("n"), has_direction)
    })
}

/// The approximation that Newton steps begin with.
#[derive(Clone, Copy)]
enum FirstGain {
    G1,
    G2,
}

/// N' as it is, and whether it has a direction; off by 1 where all components may round to 0 though one is not.
fn unnormalised(b: &Builder, normal: &Vector, shortest: f64) -> (Vector, Sig) {
    let surely = shortest - 3f64.sqrt() * normal.largest_error();
    let unsure = if surely > 0.0 { 0.0 } else { 1.0 };
    (normal.clone(), has_direction(b, normal).stated_error_value(unsure))
}

fn exactly(formats: &LyonFormats) -> ExactNormalisation {
    ExactNormalisation {
        length_squared_fraction_bits: formats.length_squared.fraction_bits,
        reciprocal: ReciprocalRoot { integer_bits: LOG2_LARGEST_GAIN, fraction_bits: formats.gain.fraction_bits },
        vector_fraction_bits: formats.vector.fraction_bits,
    }
}

/// Whether a vector has a component that is not 0 (EXTREMES row 1).
pub fn has_direction(b: &Builder, n: &Vector) -> Sig {
    b.unit("direction_gate", "N is not 0", (("n", n),), |b, (n,)| {
        let zero = b.integer(0);
        let not_zero = |c: &Sig| c.less_than(&zero).or(&zero.less_than(c));
        not_zero(&n.x).or(&not_zero(&n.y)).or(&not_zero(&n.z)).named("has_direction")
    })
}

/// Whether z of a normal no shorter than `shortest`, its components off by `e_normal`, never rounds to 0.
fn direction_is_sure(shortest: f64, e_normal: f64, formats: &LyonFormats) -> bool {
    let surely = shortest - 3f64.sqrt() * e_normal;
    surely > 0.0 && surely * surely >= 0.5 * formats.length_squared.ulp()
}

/// What is known of g for normals no shorter than s, that is for y ≤ 1 - s².
///
/// The first g has the slope 1/2 (g1) or (1 + 2y)/2 (g2) in z. A Newton step g (3 - z g²)/2 has the slopes 3/2 (1 - z g²) in g and
/// g³/2 in z; rounding g² and 3 - z g² to u/2 adds (z g + g) u/4, and rounding the result u/2. 1 - z g² is largest at the shortest
/// normal, or 0.0036 where g2 overshoots.
#[derive(Clone, Copy)]
struct GainBound {
    /// Largest g.
    largest: f64,
    /// Bound on the error of g.
    error: f64,
    /// Largest |1 - z g²|.
    residue: f64,
    shortest: f64,
    error_of_z: f64,
    ulp: f64,
}

impl GainBound {
    fn first(first: FirstGain, shortest: f64, error_of_z: f64, ulp: f64) -> GainBound {
        let y = 1.0 - shortest * shortest;
        let (largest, slope) = match first {
            FirstGain::G1 => (1.0 + y / 2.0, 0.5),
            FirstGain::G2 => (1.0 + (y + y * y) / 2.0, 0.5 + y),
        };
        // The fixed-point z may lie e_z beyond the real one, where g2 is steeper by e_z.
        let error = (slope + error_of_z) * error_of_z + 0.5 * ulp;
        let residue = (1.0 - (1.0 - y) * largest * largest).max(0.0036);
        GainBound { largest, error, residue, shortest, error_of_z, ulp }
    }

    fn after_newton_step(self) -> GainBound {
        let exact = if self.shortest > 0.0 { self.shortest.recip() } else { f64::INFINITY };
        let largest = exact.min(1.5 * self.largest);
        let g = self.largest + self.error;
        let steepest_in_g = 1.5 * (self.residue + g * g * self.error_of_z + 2.0 * g * self.error);
        let error = steepest_in_g * self.error + g.powi(3) / 2.0 * self.error_of_z + (g / 2.0 + 0.5) * self.ulp;
        // After the step g = (1 - 3/2 r² + ...)/√z with r the residue before it: a new residue of 3/4 r² + r³/4 at most.
        let residue = 0.75 * self.residue.powi(2) + 0.25 * self.residue.powi(3);
        GainBound { largest, error, residue, ..self }
    }
}

fn first_gain(b: &Builder, z: &Sig, first: FirstGain, formats: &LyonFormats) -> Sig {
    let y = (b.integer(1) - z).named("y");
    let above_one = match first {
        FirstGain::G1 => y.halved(),
        FirstGain::G2 => (&y + y.squared()).halved(),
    };
    (b.integer(1) + above_one).rounded(formats.gain.fraction_bits)
}

/// One Newton step towards 1/√z: g ← g (3 - z g²)/2.
///
/// z g² ≤ `longest`², 1.0035 for g2 of normals within the unit ball (and ≤ 1 for g1 and after any step), so 3 - z g² stays near 2 or
/// above, and rounding z and g² moves it by less than the margin.
fn newton_step(b: &Builder, g: &Sig, z: &Sig, formats: &LyonFormats, longest: f64) -> Sig {
    let fraction_bits = formats.gain.fraction_bits;
    b.unit("newton_step", "g' = g (3 - z g^2)/2 [Newton, for 1/sqrt z]", (("g", g), ("z", z)), |b, (g, z)| {
        let square = g.squared().rounded(fraction_bits).named("g_squared");
        let margin = 0.01 + 16.0 * coarsest_ulp(formats);
        let product = (&z * square).assumed(0.0, longest * longest + margin, "z g^2 <= 1.004");
        let correction = (b.integer(3) - product).rounded(fraction_bits).named("correction");
        (&g * correction).halved().rounded(fraction_bits).named("g_next")
    })
}

//! Approximate normalisation.
use specula_scene::Format;
use specula_scene::spec::lyon::{LOG2_LARGEST_GAIN, LyonFormats, LyonSpec, Normalisation};

use super::{ExactNormalisation, ReciprocalRoot, normalise_exactly};
use crate::builder::{Builder, Off, Sig, Vector};

/// How long a normal can come out that was no longer than `longest`, before rounding.
///
/// With r = |N'|, g2 r = 2r - 3/2 r³ + 1/2 r⁵ overshoots to 1.00176 at r = 0.894 (methods B9), is 1
/// at r = 1 and grows from there on. g1 r is 1 at most, and so is r g after a Newton step.
fn longest_scaled(longest: f64) -> f64 {
    let beyond = 2.0 * longest - 1.5 * longest.powi(3) + 0.5 * longest.powi(5);
    if longest > 1.0 { beyond.max(1.002) } else { 1.002 }
}

fn coarsest_ulp(formats: &LyonFormats) -> f64 {
    [formats.vector, formats.length_squared, formats.gain]
        .map(Format::ulp)
        .into_iter()
        .fold(0.0, f64::max)
}

/// Brings N' near unit length: n = g N' with g about 1/|N'|. [Lyon, TR 43; methods B8, B9]
///
/// Both ends of a span lie in the unit ball, so |N'| ≤ 1 up to rounding.
///
/// # Error
/// Let N' be off by e as a whole, and no shorter than s = `shortest` but for e. Directions are then
/// no further apart than t = e/√(s (s - e)), whatever g is. Real lengths are r g(r²) with r = |N'|;
/// so lengths are off by e times the steepest slope of that, and by r times what g is off for this
/// N', with the bounds of [`GainBound`], in which z is off by its own rounding alone. With lengths
/// up to ℓ, n is off by ℓ t across, and along N by what the length is off and ℓ t²/2.
///
/// Beside n goes a bit that says whether N' has a direction at all (extremes row 1). It is off by 1
/// where rounding may decide that.
pub fn normalise(b: &Builder, normal: &Vector, lyon: &LyonSpec, shortest: f64) -> (Vector, Sig) {
    let f = &lyon.formats;
    let (first, formula) = match lyon.normalisation {
        Normalisation::None => return unnormalised(b, normal, shortest),
        Normalisation::Exact => return normalise_exactly(b, normal, exactly(f), shortest),
        Normalisation::G1 => (FirstGain::G1, "n = g N', g = 1 + y/2, y = 1 - N'.N' [Lyon, TR 43]"),
        Normalisation::G2 => {
            (FirstGain::G2, "n = g N', g = 1 + (y + y^2)/2, y = 1 - N'.N' [Lyon, TR 43]")
        }
    };
    b.unit("normalise", formula, (("normal", normal),), |b, (normal,)| {
        let longest = longest_scaled(normal.longest());
        let z = normal
            .length_squared_within(normal.longest(), "|N'| <= 1")
            .rounded(f.length_squared.fraction_bits)
            .named("length_squared");
        let e = normal.off().length;
        let mut bound = GainBound::first(
            first,
            (shortest - e, normal.longest() + e),
            0.5 * z.ulp(),
            f.gain.ulp(),
        );
        let mut g = first_gain(b, &z, first, f).named("gain");
        for _ in 0..lyon.newton_steps {
            bound = bound.after_newton_step();
            g = newton_step(b, &g, &z, f, longest);
        }
        let off = bound.off(e, shortest, normal.longest(), longest);
        let n = normal.scaled(&g).known_off(off).rounded(f.vector.fraction_bits);
        let unsure = if direction_is_sure(shortest, e, f) { 0.0 } else { 1.0 };
        let has_direction =
            b.integer(0).less_than(&z).named("has_direction").stated_error_value(unsure);
        // Each of a few roundings adds some units of the coarsest format's last place.
        (
            n.assumed_within(longest + 8.0 * coarsest_ulp(f), "|g N'| <= 1.002").named("n"),
            has_direction,
        )
    })
}

/// How short n can be in exact arithmetic for normals no shorter than `shortest`, up to 1.
pub fn shortest_normalised(lyon: &LyonSpec, shortest: f64) -> f64 {
    let after = |first: FirstGain| {
        let first = GainBound::first(first, (shortest, 1.0), 0.0, 0.0);
        let bound = (0..lyon.newton_steps).fold(first, |bound, _| bound.after_newton_step());
        (1.0 - bound.residue).max(0.0).sqrt()
    };
    match lyon.normalisation {
        Normalisation::None => shortest,
        Normalisation::Exact => (shortest * f64::from(1u32 << LOG2_LARGEST_GAIN)).min(1.0),
        Normalisation::G1 => after(FirstGain::G1),
        Normalisation::G2 => after(FirstGain::G2),
    }
}

/// The approximation that Newton steps begin with.
#[derive(Clone, Copy)]
enum FirstGain {
    G1,
    G2,
}

impl FirstGain {
    /// The steepest slope of r g(r²) for r from `shortest` to `longest`, which is about 1: r g1 =
    /// (3r - r³)/2 has 3/2 (1 - r²), and r g2 = 2r - 3/2 r³ + 1/2 r⁵ has (1 - r²)(4 - 5r²)/2, which
    /// is least at r² = 9/10, -1/40.
    fn steepest_length(self, shortest: f64, longest: f64) -> f64 {
        let slope = |r: f64| {
            let y = 1.0 - r * r;
            match self {
                FirstGain::G1 => 1.5 * y,
                FirstGain::G2 => 0.5 * y * (5.0 * y - 1.0),
            }
        };
        slope(shortest).abs().max(slope(longest).abs()).max(0.025)
    }

    fn gain(self, y: f64) -> f64 {
        match self {
            FirstGain::G1 => 1.0 + y / 2.0,
            FirstGain::G2 => 1.0 + (y + y * y) / 2.0,
        }
    }
}

/// N' as it is, and whether it has a direction; off by 1 where all components may round to 0 though
/// one is not.
fn unnormalised(b: &Builder, normal: &Vector, shortest: f64) -> (Vector, Sig) {
    let surely = shortest - normal.off().length;
    let unsure = if surely > 0.0 { 0.0 } else { 1.0 };
    (normal.clone(), has_direction(b, normal).stated_error_value(unsure))
}

fn exactly(formats: &LyonFormats) -> ExactNormalisation {
    ExactNormalisation {
        length_squared_fraction_bits: formats.length_squared.fraction_bits,
        reciprocal: ReciprocalRoot {
            integer_bits: LOG2_LARGEST_GAIN,
            fraction_bits: formats.gain.fraction_bits,
        },
        vector_fraction_bits: formats.vector.fraction_bits,
    }
}

/// Whether a vector has a component that is not 0 (extremes row 1).
pub fn has_direction(b: &Builder, n: &Vector) -> Sig {
    b.unit("direction_gate", "N is not 0", (("n", n),), |b, (n,)| {
        let zero = b.integer(0);
        let not_zero = |c: &Sig| c.less_than(&zero).or(&zero.less_than(c));
        not_zero(&n.x).or(&not_zero(&n.y)).or(&not_zero(&n.z)).named("has_direction")
    })
}

/// Whether z of a normal no shorter than `shortest`, off by `e`, never rounds to 0.
fn direction_is_sure(shortest: f64, e: f64, formats: &LyonFormats) -> bool {
    let surely = shortest - e;
    surely > 0.0 && surely * surely >= 0.5 * formats.length_squared.ulp()
}

/// What is known of g for normals no shorter than s, that is for y ≤ 1 - s², and of a length about
/// 1 at most.
///
/// The first g has the slope 1/2 (g1) or (1 + 2y)/2 (g2) in z. A Newton step g (3 - z g²)/2 has the
/// slopes 3/2 (1 - z g²) in g and g³/2 in z; rounding g² and 3 - z g² to u/2 adds (z g + g) u/4,
/// and rounding the result u/2. 1 - z g² is largest at the shortest or longest normal, or 0.0036
/// where g2 overshoots.
#[derive(Clone, Copy)]
struct GainBound {
    /// Largest g.
    largest: f64,
    /// Bound on the error of g.
    error: f64,
    /// Largest |1 - z g²|.
    residue: f64,
    /// Largest slope of the length r g(r²) in r.
    slope: f64,
    shortest: f64,
    error_of_z: f64,
    ulp: f64,
}

impl GainBound {
    fn first(
        first: FirstGain,
        (shortest, longest): (f64, f64),
        error_of_z: f64,
        ulp: f64,
    ) -> GainBound {
        let shortest = shortest.max(0.0);
        let y = 1.0 - shortest * shortest;
        let largest = first.gain(y);
        let slope = match first {
            FirstGain::G1 => 0.5,
            FirstGain::G2 => 0.5 + y,
        };
        // The fixed-point z may lie e_z beyond the real one, where g2 is steeper by e_z.
        let error = (slope + error_of_z) * error_of_z + 0.5 * ulp;
        let residue_at = |r: f64| (1.0 - (r * first.gain(1.0 - r * r)).powi(2)).abs();
        let residue = residue_at(shortest).max(residue_at(longest)).max(0.0036);
        let slope = first.steepest_length(shortest, longest);
        GainBound { largest, error, residue, slope, shortest, error_of_z, ulp }
    }

    /// How far n is off where N' is by `e`, no shorter than `shortest` and no longer than
    /// `longest`, and n no longer than `reach`.
    fn off(&self, e: f64, shortest: f64, longest: f64, reach: f64) -> Off {
        if e >= shortest {
            return Off::within(2.0 * reach + (longest + e) * self.error);
        }
        let turned = reach * e / (shortest * (shortest - e)).sqrt();
        let stretched = self.slope * e + (longest + e) * self.error;
        Off::parts(turned, stretched + turned * turned / 2.0)
    }

    fn after_newton_step(self) -> GainBound {
        let exact = if self.shortest > 0.0 { self.shortest.recip() } else { f64::INFINITY };
        let largest = exact.min(1.5 * self.largest);
        let g = self.largest + self.error;
        let steepest_in_g = 1.5 * (self.residue + g * g * self.error_of_z + 2.0 * g * self.error);
        let error = steepest_in_g * self.error
            + g.powi(3) / 2.0 * self.error_of_z
            + (g / 2.0 + 0.5) * self.ulp;
        // After the step g = (1 - 3/2 r² + ...)/√z with r the residue before it: a new residue of
        // 3/4 r² + r³/4 at most.
        let residue = 0.75 * self.residue.powi(2) + 0.25 * self.residue.powi(3);
        // A length l becomes l (3 - l²)/2, whose slope is 3/2 (1 - l²), and 1 - l² is the residue.
        let slope = 1.5 * self.residue * self.slope;
        GainBound { largest, error, residue, slope, ..self }
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
/// z g² ≤ `longest`², 1.0035 for g2 of normals within the unit ball (and ≤ 1 for g1 and after any
/// step), so 3 - z g² stays near 2 or above, and rounding z and g² moves it by less than the
/// margin.
fn newton_step(b: &Builder, g: &Sig, z: &Sig, formats: &LyonFormats, longest: f64) -> Sig {
    let fraction_bits = formats.gain.fraction_bits;
    b.unit(
        "newton_step",
        "g' = g (3 - z g^2)/2 [Newton, for 1/sqrt z]",
        (("g", g), ("z", z)),
        |b, (g, z)| {
            let square = g.squared().rounded(fraction_bits).named("g_squared");
            let margin = 0.01 + 16.0 * coarsest_ulp(formats);
            let product = (&z * square).assumed(0.0, longest * longest + margin, "z g^2 <= 1.004");
            let correction = (b.integer(3) - product).rounded(fraction_bits).named("correction");
            (&g * correction).halved().rounded(fraction_bits).named("g_next")
        },
    )
}

//! From intensities to a pixel.
use crate::error;
use crate::error::colour::Term;
use specula_datapath::builder::{Builder, Sig, TimeSlots};

/// A colour coefficient for each channel, in LSBs of the output.
pub type Coefficients = [Sig; 3];

/// What one light contributes.
pub struct Light {
    /// Diffuse intensity, 0 to 1.
    pub diffuse: Sig,
    /// Specular intensity, 0 to 1.
    pub specular: Sig,
    /// Diffuse coefficients.
    pub diffuse_coefficients: Coefficients,
    /// Specular coefficients.
    pub specular_coefficients: Coefficients,
}

/// The 8-bit codes of red, green and blue of the lights in every time slot of a pixel, right in the
/// last. [methods A3]
pub fn channels(
    b: &Builder,
    slots: &TimeSlots,
    ambient: &Coefficients,
    lights: &[Light],
) -> [Sig; 3] {
    let code = |c: usize| {
        b.instance(&format!("{}_channel", NAMES[c]), || channel(b, slots, &ambient[c], lights, c))
    };
    let red = code(0);
    let green = if alike(ambient, lights, [0, 1]) { shared(b, &red, [0, 1]) } else { code(1) };
    let blue =
        match [(0, &red), (1, &green)].into_iter().find(|(c, _)| alike(ambient, lights, [*c, 2])) {
            Some((c, earlier)) => shared(b, earlier, [c, 2]),
            None => code(2),
        };
    [red, green, blue]
}

const NAMES: [&str; 3] = ["red", "green", "blue"];

/// Whether two channels have the same coefficients, and so the same codes.
fn alike(ambient: &Coefficients, lights: &[Light], [a, b]: [usize; 2]) -> bool {
    let same = |coefficients: &Coefficients| coefficients[a].is(&coefficients[b]);
    same(ambient)
        && lights
            .iter()
            .all(|light| same(&light.diffuse_coefficients) && same(&light.specular_coefficients))
}

/// The code of an earlier channel for a later one.
fn shared(b: &Builder, code: &Sig, [earlier, later]: [usize; 2]) -> Sig {
    b.leave_out(
        &format!("channel `{}`", NAMES[later]),
        &format!("it is always what `{}` is", NAMES[earlier]),
    );
    code.clone()
}

/// c = ambient + Σ (diffuse coefficient · diffuse + specular coefficient · specular), rounded, at
/// most 255.
///
/// # Error
/// [`error::colour::code`].
fn channel(b: &Builder, slots: &TimeSlots, ambient: &Sig, lights: &[Light], c: usize) -> Sig {
    let coefficients = |light: &Light| {
        [light.diffuse_coefficients[c].clone(), light.specular_coefficients[c].clone()]
    };
    let intensities = |light: &Light| [light.diffuse.clone(), light.specular.clone()];
    let coefficients: Vec<Sig> = lights.iter().flat_map(coefficients).collect();
    let intensities: Vec<Sig> = lights.iter().flat_map(intensities).collect();
    let inputs = (
        ("ambient", ambient),
        ("coefficient", &coefficients),
        ("intensity", &intensities),
        ("begins", &slots.first_slot),
    );
    let formula = "c = min(ambient + sum of coefficient x intensity, 255) [methods A3]";
    b.unit("channel", formula, inputs, |_, (ambient, coefficients, intensities, begins)| {
        let known = coefficients.iter().zip(&intensities);
        let known: Vec<Term> = known.map(|(k, f)| Term::new(k.bound(), f.bound())).collect();
        let error = error::colour::code(ambient.bound(), &known, slots.count());
        let terms = coefficients
            .iter()
            .zip(&intensities)
            .map(|(coefficient, intensity)| coefficient * intensity);
        let sum = match slots.count() {
            1 => terms.fold(ambient, |sum, term| sum + term),
            count => sum_of_slots(&begins, &ambient, terms, count),
        };
        sum.rounded(0).clamped_above(255).tighten_error("error::colour::code", error).named("code")
    })
}

/// The ambient light and the terms of a pixel's time slots up to this one; nothing is negative.
fn sum_of_slots(begins: &Sig, ambient: &Sig, terms: impl Iterator<Item = Sig>, count: u32) -> Sig {
    let term = terms.reduce(|sum, term| sum + term).unwrap_or_else(|| ambient.clone());
    let largest = |sig: &Sig| sig.bound().fixed.high.max(0.0);
    let most = largest(ambient) + f64::from(count) * largest(&term);
    Sig::summed(
        begins,
        ambient,
        &term,
        (0.0, most),
        count,
        "no pixel has more turns than there are lights",
    )
}

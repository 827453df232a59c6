//! A spec's narrowing points and options, in the order of the data, for people to read.
use specula_scene::spec::hybrid::HybridFormats;
use specula_scene::spec::lyon::{Difference, LyonFormats, Normalisation};
use specula_scene::{CoreSpec, Format, MethodSpec};

/// A place where values are rounded.
pub struct NarrowingPoint {
    /// Its name in the spec.
    pub name: &'static str,
    /// What it is rounded to.
    pub format: Format,
    /// What is rounded.
    pub value: &'static str,
}

/// Every narrowing point of a core. Names, formulas and order are those of docs/arithmetic.md.
pub fn points(spec: &CoreSpec) -> Vec<NarrowingPoint> {
    match &spec.method {
        MethodSpec::Lyon(lyon) => lyon_points(&lyon.formats),
        MethodSpec::Hybrid(hybrid) => hybrid_points(&hybrid.formats),
    }
}

fn lyon_points(formats: &LyonFormats) -> Vec<NarrowingPoint> {
    // Taken apart, so that a format that is new there cannot be forgotten here.
    let &LyonFormats { weight_accumulator, weight, vector, length_squared, gain, diffuse, difference, shape } = formats;
    vec![
        point("weight_accumulator", weight_accumulator, "step of the interpolation weight, rounded by the host"),
        point("weight", weight, "interpolation weight a"),
        point("vector", vector, "components of N' = N0 + a (N1 - N0) and of n = g N'"),
        point("length_squared", length_squared, "z = N'.N'"),
        point("gain", gain, "g, about 1/sqrt(z)"),
        point("diffuse", diffuse, "n.L, clamped at 0"),
        point("difference", difference, "components of D"),
        point("shape", shape, "x = n D.D / 2^(k+1), and each square of 1 - x"),
    ]
}

fn hybrid_points(formats: &HybridFormats) -> Vec<NarrowingPoint> {
    let &HybridFormats { diffuse_accumulator, diffuse, accumulator, operand, base } = formats;
    vec![
        point("diffuse_accumulator", diffuse_accumulator, "start and step of the diffuse intensity, rounded by the host"),
        point("diffuse", diffuse, "diffuse intensity, clamped to 0..1"),
        point("accumulator", accumulator, "start and differences of p and q, rounded by the host"),
        point("operand", operand, "p and q as they enter the divider"),
        point("base", base, "p/q, and each square of it"),
    ]
}

fn point(name: &'static str, format: Format, value: &'static str) -> NarrowingPoint {
    NarrowingPoint { name, format, value }
}

/// What else the spec says: names and values.
pub fn options(spec: &CoreSpec) -> Vec<(&'static str, String)> {
    let mut options = vec![
        ("lights", spec.lights.to_string()),
        ("longest span", format!("{} pixels", spec.longest_span)),
        ("largest exponent n", spec.largest_shininess.to_string()),
        ("colour coefficients", format!("{}, in LSBs of the 8-bit output", spec.coefficient)),
        ("shortest interpolated normal", format!("{:.3} of the longer one at the ends of its span", spec.shortest_normal)),
    ];
    if let MethodSpec::Lyon(lyon) = &spec.method {
        let first = match lyon.normalisation {
            Normalisation::G1 => "g1 = 1 + y/2",
            Normalisation::G2 => "g2 = 1 + (y + y^2)/2",
        };
        let difference = match lyon.difference {
            Difference::ReflectionMinusLight => "D = R - L",
            Difference::HalfwayCrossNormal => "D = H x N",
        };
        options.push(("normalisation", format!("{first}, y = 1 - z")));
        options.push(("Newton steps", lyon.newton_steps.to_string()));
        options.push(("difference", difference.to_owned()));
        options.push(("shape", format!("f = (1 - x)^(2^k), 0 from x = 1 on; k = {}", lyon.squarings)));
    }
    options
}
